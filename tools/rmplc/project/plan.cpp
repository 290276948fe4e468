// From sets to calls.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/project/plan.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/glob.hpp"
#include "compiler/session/files.hpp"
#include "tools/rmplc/project/dependencies.hpp"
#include "tools/shared/property_subject.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

namespace fs = std::filesystem;
using compiler::Compilation;

std::string quoted(const std::string& name) { return "'" + name + "'"; }

/// Whether a file is in what was named, or is it.
bool is_below(const std::string& file, const std::string& where) {
  std::error_code error;
  const fs::path from = fs::proximate(file, where, error);
  return !error && !from.empty() && *from.begin() != "..";
}

bool is_chosen(const TestChoice& choice, const std::string& file, const std::string& name) {
  if (!choice.below.empty() && !is_below(file, choice.below)) return false;
  if (choice.only.empty()) return true;
  return std::any_of(choice.only.begin(), choice.only.end(), [&](const std::string& pattern) {
    return base::name_matches(pattern, name) || base::name_matches(pattern, file) ||
           base::name_matches(pattern, file + ": " + name);
  });
}

Compilation compiled(const SetFiles& files) {
  std::vector<std::string> inputs;
  for (const std::string& one : {files.plant, files.program}) {
    if (!one.empty()) inputs.push_back(one);
  }
  for (const auto* more : {&files.scenarios, &files.properties, &files.monitors})
    inputs.insert(inputs.end(), more->begin(), more->end());
  return compiler::compile(inputs, {.main = files.main, .properties = true, .monitors = true, .flown = true});
}

/// The files that a set is made of, imports too.
std::vector<std::string> sources_of(const PlannedSet& set) {
  std::vector<std::string> names;
  for (const compiler::File& file : set.compilation.files()) {
    names.push_back(set.compilation.findings().sources[file.index].name());
  }
  return names;
}

/// What a scenario names, and then what its expectations do.
std::vector<RequirementTag> tags_of(const automata::Scenario& scenario) {
  std::vector<RequirementTag> tags;
  for (const std::string& requirement : scenario.requirements) {
    tags.push_back({requirement, scenario.name, std::nullopt, {}, scenario.origin});
  }
  for (std::size_t e = 0; e < scenario.expectations.size(); ++e) {
    const automata::Expectation& expectation = scenario.expectations[e];
    for (const std::string& requirement : expectation.requirements) {
      tags.push_back({requirement, scenario.name, e, expectation.text, expectation.origin});
    }
  }
  return tags;
}

class Planning {
 public:
  Planning(const Manifest& manifest, const TestChoice& choice) : manifest_(manifest), choice_(choice) {
    plan_.manifest = manifest.path;
    if (choice.since.empty()) return;
    changed_ = changed_since(choice.since, fs::path(manifest.path).parent_path().string());
    for (const char* name : {manifest_name, "rmpl.ini"}) {
      all_changed_ = all_changed_ || std::any_of(changed_.begin(), changed_.end(), [&](const std::string& path) {
                       return fs::path(path).filename() == name;
                     });
    }
  }

  TestPlan run() {
    check_names();
    plan_.lints = !choice_.is_narrow();
    if (choice_.is_whole()) {
      for (const ManifestText& one : manifest_.requirements) plan_.requirements.push_back(one.text);
    }
    for (const ManifestSet& set : manifest_.sets) {
      const bool meant =
          choice_.sets.empty() || std::find(choice_.sets.begin(), choice_.sets.end(), set.name) != choice_.sets.end();
      if (meant) add(set);
    }
    if (plan_.calls.empty() && !plan_.lints) {
      throw base::InputError(manifest_.path + ": no scenario and no property matches the choice");
    }
    return std::move(plan_);
  }

 private:
  void check_names() const {
    if (manifest_.sets.empty()) throw base::InputError(manifest_.path + ": expected a set of files, as in [set.NAME]");
    std::vector<std::string_view> names;
    for (const ManifestSet& set : manifest_.sets) names.emplace_back(set.name);
    for (const std::string& name : choice_.sets) {
      if (std::find(names.begin(), names.end(), name) != names.end()) continue;
      throw base::InputError("--set: " + manifest_.path + " has no set " + quoted(name) +
                             suggestion_or_list(name, names));
    }
  }

  void add(const ManifestSet& set) {
    SetFiles files = files_of(manifest_, set);
    Compilation compilation = compiled(files);
    PlannedSet planned{set.name, std::move(files), std::move(compilation)};
    if (!depends_on_changes(planned)) return;
    plan_.sets.push_back(std::move(planned));
    add_scenarios(plan_.sets.back());
    if (!plan_.sets.back().files.properties.empty()) add_properties(set, plan_.sets.back());
  }

  /// One that does not compile may lack what is no more.
  [[nodiscard]] bool depends_on_changes(const PlannedSet& set) const {
    if (choice_.since.empty() || all_changed_ || !set.compilation.ok()) return true;
    const std::vector<std::string> names = sources_of(set);
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return changed_.contains(changed_name(name)); });
  }

  void add_scenarios(const PlannedSet& set) {
    for (const std::string& file : set.files.scenarios) {
      if (!set.compilation.ok()) {
        if (is_chosen(choice_, file, file)) add_flight(file, {}, {});
        continue;
      }
      for (const automata::Scenario& scenario : set.compilation.document().scenarios) {
        const bool here = scenario.origin.file == file;
        if (here && is_chosen(choice_, file, scenario.name)) add_flight(file, {scenario.name}, tags_of(scenario));
      }
    }
  }

  void add_flight(const std::string& file, const std::vector<std::string>& names, std::vector<RequirementTag> tags) {
    std::vector<std::string> arguments = {"rmpl-run", "scenario", file, "--jobs", "1"};
    for (const std::string& monitors : plan_.sets.back().files.monitors)
      arguments.insert(arguments.end(), {"--monitors", monitors});
    call(PlannedCall::Kind::scenario, file, names, std::move(arguments), std::move(tags));
  }

  void call(PlannedCall::Kind kind, const std::string& file, const std::vector<std::string>& names,
            std::vector<std::string> arguments, std::vector<RequirementTag> tags) {
    for (const std::string& name : names) {
      arguments.emplace_back("--only");
      arguments.push_back(name);
    }
    arguments.insert(arguments.end(), {"--format", "junit", "--color", "never"});
    plan_.calls.push_back({plan_.sets.size() - 1, kind, file, names, std::move(arguments), std::move(tags)});
  }

  void add_properties(const ManifestSet& set, const PlannedSet& planned) {
    const PropertySubject subject = subject_of(manifest_, set, planned.files, planned.compilation);
    for (const std::string& file : planned.files.properties) {
      std::vector<std::string> names;
      std::vector<RequirementTag> tags;
      bool all = true;
      if (planned.compilation.ok()) {
        for (const automata::PlantProperty& property : planned.compilation.properties()) {
          if (property.origin.file != file) continue;
          const bool known = std::find(names.begin(), names.end(), property.name) != names.end();
          const bool chosen = is_chosen(choice_, file, property.name);
          if (chosen && !known) names.push_back(property.name);
          if (chosen && !known) {
            for (const std::string& requirement : property.requirements) {
              tags.push_back({requirement, property.name, std::nullopt, {}, property.origin});
            }
          }
          all = all && chosen;
        }
      } else if (!is_chosen(choice_, file, file)) {
        all = false;
      }
      if (all) names.clear();
      if (!all && names.empty()) continue;
      std::vector<std::string> arguments = {"tcca-check", "check", subject.plant, file};
      if (!subject.program.empty()) arguments.push_back(subject.program);
      if (!subject.main.empty()) arguments.insert(arguments.end(), {"--main", subject.main});
      call(PlannedCall::Kind::properties, file, names, std::move(arguments), std::move(tags));
    }
  }

  const Manifest& manifest_;
  const TestChoice& choice_;
  std::set<std::string> changed_;
  bool all_changed_ = false;  ///< the manifest or the settings have
  TestPlan plan_;
};

}  // namespace

std::vector<std::string> TestPlan::files() const {
  std::vector<std::string> all = {manifest};
  for (const PlannedSet& set : sets) {
    for (std::string& name : sources_of(set)) {
      if (std::find(all.begin(), all.end(), name) == all.end()) all.push_back(std::move(name));
    }
  }
  return all;
}

TestPlan plan_tests(const Manifest& manifest, const TestChoice& choice) { return Planning(manifest, choice).run(); }

}  // namespace rmpl::tools
