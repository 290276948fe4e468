// What can be done with what stands there: fly or debug a scenario, check a property or a program.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/positions.hpp"
#include "tools/shared/manifest.hpp"
#include "tools/shared/settings.hpp"

namespace rmpl::tools {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

/// A plant that a program flies, as scenarios and projects name it.
struct FlownPlant {
  std::string plant;
  std::string main;  ///< the definition to start with; empty: the only one
  auto operator<=>(const FlownPlant&) const = default;
};

/// Whether it is claimed of a program.
bool is_of_program(const grammar::PropertyDefinition& property) {
  return std::any_of(property.items.begin(), property.items.end(), [](const grammar::PropertyItem& item) {
    return std::visit(
        [](const auto& one) {
          using Item = std::decay_t<decltype(one)>;
          if constexpr (requires { one.of_program; }) return one.of_program;
          return std::is_same_v<Item, grammar::EventuallyClaim> || std::is_same_v<Item, grammar::FinallyClaim>;
        },
        item);
  });
}

class Lenses {
 public:
  Lenses(Workspace& workspace, const OpenDocument& document, const Analysis& analysis, std::uint32_t file)
      : workspace_(workspace), document_(document), analysis_(analysis), file_(file) {}

  Json run() {
    const compiler::File& file = analysis_.file(file_);
    if (file.scenarios) scenarios(file.scenarios->scenarios);
    if (file.properties) properties(file.properties->properties);
    if (file.program) definitions(file.program->items);
    return std::move(lenses_);
  }

 private:
  void add(grammar::Span span, const std::string& title, const char* command, Json argument) {
    lenses_.push_back(
        {{"range", range_of(analysis_.sources()[file_], span)},
         {"command", {{"title", title}, {"command", command}, {"arguments", Json::array({std::move(argument)})}}}});
  }

  /// A call of one of the programs, in the folder of the document.
  void run_lens(grammar::Span span, const std::string& title, const char* program, Words words) {
    add(span, title, "rmpl.run",
        {{"program", program},
         {"arguments", std::move(words)},
         {"folder", fs::path(document_.path).parent_path().string()}});
  }

  void scenarios(const std::vector<grammar::ScenarioDefinition>& all) {
    if (all.size() > 1) run_lens(all.front().name.span, "fly all", "rmpl-run", {"scenario", document_.path});
    for (const grammar::ScenarioDefinition& scenario : all) {
      const std::string& name = scenario.name.text;
      run_lens(scenario.name.span, "fly", "rmpl-run", {"scenario", document_.path, "--only", name});
      add(scenario.name.span, "debug", "rmpl.debug",
          {{"type", "rmpl"}, {"request", "launch"}, {"name", name}, {"scenario", document_.path}, {"only", name}});
    }
  }

  void properties(const std::vector<grammar::PropertyDefinition>& all) {
    const auto words = check_words();
    if (!words) return;
    const auto can_check = [&](const grammar::PropertyDefinition& one) {
      return knows_program_ || !is_of_program(one);
    };
    if (all.size() > 1 && std::all_of(all.begin(), all.end(), can_check)) {
      run_lens(all.front().name.span, "check all", "tcca-check", *words);
    }
    for (const grammar::PropertyDefinition& property : all) {
      if (!can_check(property)) continue;
      Words own = *words;
      own.insert(own.end(), {"--only", property.name.text});
      run_lens(property.name.span, "check", "tcca-check", std::move(own));
    }
  }

  /// How the properties are checked: as the project says, else with the plant of their unit and the program beside it
  /// that has the name of one of the two. Nothing where there is no plant.
  std::optional<Words> check_words() {
    if (is_in_one_set()) {
      knows_program_ = true;
      return Words{"check", document_.path};
    }
    for (const std::string& path : analysis_.unit().paths) {
      if (compiler::kind_by_name(path) != compiler::Kind::plant) continue;
      Words words{"check", path, document_.path};
      for (const std::string& named : {document_.path, path}) {
        const std::string program = fs::path(named).replace_extension(".rmpl").string();
        std::error_code unknown;
        if (!fs::is_regular_file(program, unknown)) continue;
        knows_program_ = true;
        words.push_back(program);
        break;
      }
      return words;
    }
    return std::nullopt;
  }

  /// Whether one set of the project, and no other, has the document among its properties.
  bool is_in_one_set() {
    const auto path = find_manifest(fs::path(document_.path).parent_path().string());
    if (!path) return false;
    std::size_t sets = 0;
    try {
      const Manifest manifest = read_manifest(*path, workspace_.texts().read(*path));
      for (const ManifestSet& set : manifest.sets) {
        const std::vector<std::string> files = files_of(manifest, set).properties;
        sets += static_cast<std::size_t>(
            std::count_if(files.begin(), files.end(), [&](const std::string& one) { return is_document(one); }));
      }
    } catch (const base::InputError&) {
      return false;  // `rmplc test` tells what is wrong with it
    }
    return sets == 1;
  }

  bool is_document(const std::string& path) {
    const fs::path whole = fs::path(path).is_absolute() ? fs::path(path) : fs::current_path() / path;
    return workspace_.texts().identity(whole.lexically_normal().string()) ==
           workspace_.texts().identity(document_.path);
  }

  void definitions(const std::vector<grammar::ProgramItem>& items) {
    const std::set<FlownPlant> flown = flights();
    if (flown.empty()) return;
    std::set<std::string> plants;
    for (const FlownPlant& one : flown) plants.insert(one.plant);
    for (const grammar::ProgramItem& item : items) {
      const auto* definition = std::get_if<grammar::Definition>(&item);
      if (definition == nullptr || definition->model || !definition->parameters.empty()) continue;
      const bool called = is_called(*definition);
      std::set<std::string> with_lens;
      for (const FlownPlant& one : flown) {
        if (one.main.empty() ? called : one.main != definition->name.text) continue;
        if (!with_lens.insert(one.plant).second) continue;
        Words words{"program", document_.path, one.plant};
        if (!one.main.empty()) words.insert(words.end(), {"--main", one.main});
        const std::string with = plants.size() == 1 ? "" : " with " + fs::path(one.plant).filename().string();
        run_lens(definition->name.span, "check" + with, "tcca-check", std::move(words));
      }
    }
  }

  /// Whether another definition calls it.
  bool is_called(const grammar::Definition& definition) const {
    for (const compiler::Mention& mention : analysis_.names().of(definition.name.span)) {
      const bool own = mention.span.file == definition.span.file && definition.span.begin <= mention.span.begin &&
                       mention.span.end <= definition.span.end;
      if (!own && analysis_.file(mention.span.file).program) return true;
    }
    return false;
  }

  /// The plants that the document flies as a program.
  std::set<FlownPlant> flights() {
    std::set<FlownPlant> found;
    for (const auto& analysis : workspace_.analyses()) {
      if (!analysis || !analysis->find(workspace_.texts().identity(document_.path))) continue;
      for (const compiler::File& file : analysis->files()) {
        if (!file.scenarios) continue;
        for (const grammar::ScenarioDefinition& scenario : file.scenarios->scenarios) add_flight(file, scenario, found);
      }
      const std::vector<std::string>& paths = analysis->unit().paths;
      const auto is_plant = [](const std::string& path) {
        return compiler::kind_by_name(path) == compiler::Kind::plant;
      };
      const auto plant = std::find_if(paths.begin(), paths.end(), is_plant);
      if (plant != paths.end() &&
          std::any_of(paths.begin(), paths.end(), [&](const auto& p) { return is_document(p); }))
        found.insert({*plant, {}});
    }
    return found;
  }

  void add_flight(const compiler::File& file, const grammar::ScenarioDefinition& scenario,
                  std::set<FlownPlant>& found) {
    const grammar::ProgramPart* program = nullptr;
    const grammar::PlantPart* plant = nullptr;
    for (const grammar::ScenarioItem& item : scenario.items) {
      if (const auto* part = std::get_if<grammar::ProgramPart>(&item)) program = part;
      if (const auto* part = std::get_if<grammar::PlantPart>(&item)) plant = part;
    }
    if (program == nullptr || plant == nullptr || compiler::kind_by_name(plant->path.text) != compiler::Kind::plant)
      return;
    const auto path = [&](const grammar::String& name) {
      return (fs::path(file.directory) / name.text).lexically_normal().string();
    };
    if (is_document(path(program->path)))
      found.insert({path(plant->path), program->main ? program->main->text : std::string()});
  }

  Workspace& workspace_;
  const OpenDocument& document_;
  const Analysis& analysis_;
  std::uint32_t file_;
  bool knows_program_ = false;  ///< that the properties may speak of
  Json lenses_ = Json::array();
};

}  // namespace

Json code_lenses(Workspace& workspace, const Json& params) {
  const OpenDocument& document = workspace.documents().of(params);
  if (!document.is_file) return Json::array();  // the programs read files
  const Analysis* analysis = workspace.analysis_of(document);
  if (analysis == nullptr) return Json::array();
  return Lenses(workspace, document, *analysis, *analysis->find(workspace.texts().identity(document.path))).run();
}

}  // namespace rmpl::tools
