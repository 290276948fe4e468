// Goals by hand become the text of a program, which lies over the files in memory.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/step_model.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/output_file.hpp"
#include "compiler/session/files.hpp"
#include "compiler/session/kind.hpp"
#include "compiler/session/provider.hpp"
#include "grammar/source/render.hpp"
#include "runtime/executive/step/scenario_text.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/program.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* entry_by_hand = "Stepped";
constexpr const char* file_by_hand = "stepped-goals.rmpl";

compiler::Compilation compiled(const std::vector<std::string>& paths, const std::string& main,
                               compiler::Provider& provider, const Common& common) {
  compiler::Compilation compilation =
      compiler::compile(paths, {.main = main, .monitors = true, .flown = true, .model_is_plant = true}, provider);
  tell_findings(compilation.findings(), common);
  if (!compilation.ok()) throw Rejected{grammar::render_text(compilation.findings(), false)};
  return compilation;
}

/// A path as a file in `folder` names it.
std::string seen_from(const fs::path& folder, const std::string& path) {
  std::error_code unknown;
  const fs::path relative = fs::relative(fs::absolute(path), fs::absolute(folder), unknown);
  std::string text = unknown || relative.empty() ? fs::absolute(path).string() : relative.string();
  if (text.find_first_of("\"\n") != std::string::npos) {
    throw base::InputError("'" + text + "' cannot be named in a scenario");
  }
  return text;
}

}  // namespace

StepModel::StepModel(StepOptions options, const Common& common) : options_(std::move(options)), common_(common) {
  if (options_.files.size() > 2) throw base::InputError("expected PROGRAM PLANT, PLANT, or one file of scenarios");
  for (const std::string& file : options_.files) {
    if (file == "-") throw base::InputError("'-': the commands already come from standard input");
  }
  open();
}

void StepModel::open() {
  compiler::Disk disk;
  if (options_.files.size() == 2) {
    kind_ = Kind::program;
  } else if (compiler::kind_by_name(options_.files.front()) == compiler::Kind::scenario) {
    kind_ = Kind::scenario;
  }
  if (kind_ != Kind::scenario && !options_.monitors.empty()) {
    throw base::InputError("--monitors: goes only with a file of scenarios");
  }
  if (kind_ != Kind::scenario && !options_.only.empty()) {
    throw base::InputError("--only: goes only with a file of scenarios");
  }
  if (kind_ == Kind::scenario && (options_.cycle || options_.duration || !options_.main.empty())) {
    throw base::InputError(std::string(options_.cycle      ? "--cycle"
                                       : options_.duration ? "--duration"
                                                           : "--main") +
                           ": the scenario says that");
  }
  if (kind_ == Kind::plant && !options_.main.empty()) throw base::InputError("--main: there is no program");
  if (kind_ == Kind::plant) return compile_with_goals();
  std::vector<std::string> files = options_.files;
  files.insert(files.end(), options_.monitors.begin(), options_.monitors.end());
  compilation_ = compiled(files, options_.main, disk, common_);
  if (kind_ == Kind::scenario) return choose_scenario();
  entry_ = only_program(document(), options_.files.front()).name;
  scenario_ = own_scenario();
}

void StepModel::choose_scenario() {
  const std::vector<automata::Scenario>& all = document().scenarios;
  std::vector<std::string_view> names;
  names.reserve(all.size());
  for (const automata::Scenario& scenario : all) names.emplace_back(scenario.name);
  const std::string& file = options_.files.front();
  if (all.empty()) throw base::InputError(file + ": expected a scenario, but the file has none");
  if (options_.only.empty() && all.size() > 1) {
    throw base::InputError(file + ": expected one scenario, found " + std::to_string(all.size()) +
                           "; choose one with --only");
  }
  const auto chosen = options_.only.empty() ? all.begin() : std::find_if(all.begin(), all.end(), [&](const auto& s) {
    return s.name == options_.only;
  });
  if (chosen == all.end()) {
    throw base::InputError(file + ": no scenario is called '" + options_.only + "'" +
                           suggestion_or_list(options_.only, names));
  }
  scenario_ = *chosen;
  if (options_.seed) scenario_.seed = *options_.seed;
}

automata::Scenario StepModel::own_scenario() const {
  automata::Scenario scenario;
  scenario.name = "stepped";
  (void)only_plant(document(), options_.files.back());
  constexpr automata::Ticks day = automata::Ticks::of_seconds(24L * 3600);
  scenario.cycle = options_.cycle.value_or(scenario.cycle);
  scenario.duration = options_.duration.value_or(day);
  scenario.seed = options_.seed.value_or(0);
  return scenario;
}

/// What the program by hand says. The goals follow each other by a clock that runs from the start. A condition holds in
/// the cycle that begins with it, and what follows a `when` begins a cycle later: so one is a cycle ahead of the other.
/// In the first cycle the clock cannot be read yet.
std::string StepModel::program_text(const std::string& import) const {
  std::string text = "// What was asked for by hand while stepping.\n";
  if (!import.empty()) text += "import \"" + import + "\";\n";
  std::string step = entry_.empty() ? "always { }" : entry_ + "()";
  std::string body, indent = "  ", closing;
  for (const Goal& goal : goals_) {
    if (goal.from > automata::Ticks{}) {
      body.append(indent).append("do ").append(step).append(" watching (stepped-time >= ");
      body.append(automata::format_seconds(goal.from)).append(" s),\n");
      const automata::Ticks before = goal.from - scenario_.cycle;
      body += indent + (before == automata::Ticks{}
                            ? std::string("next {\n")
                            : "when (stepped-time >= " + automata::format_seconds(before) + " s) donext {\n");
      closing.insert(0, indent + "}\n");
      indent += "  ";
    }
    step = goal.text.empty() ? "always { }" : "always (" + goal.text + ")";
  }
  const std::string clock = closing.empty() ? "" : "  stepped-time = 0,\n";
  return text + "\n" + entry_by_hand + "() :: {\n" + clock + body + indent + step + "\n" + closing + "}\n";
}

void StepModel::compile_with_goals() {
  compiler::Disk disk;
  if (kind_ == Kind::program && goals_.empty()) {
    compilation_ = compiled(options_.files, options_.main, disk, common_);
    scenario_ = own_scenario();
    return;
  }
  compiler::Overlay sources(disk);
  const fs::path first = options_.files.front();
  const std::string name = (first.parent_path() / file_by_hand).string();
  sources.put(name, program_text(kind_ == Kind::program ? first.filename().string() : ""));
  compilation_ = compiled({name, options_.files.back()}, entry_by_hand, sources, common_);
  scenario_ = own_scenario();
}

std::unique_ptr<runtime::FlightSteps> StepModel::fly(std::vector<runtime::Choice> choices) const {
  runtime::ScenarioOptions options = options_.engines;
  options.interrupted = interrupted;
  return std::make_unique<runtime::FlightSteps>(document(), scenario_, std::move(options), std::move(choices));
}

void StepModel::ask_for(const std::string& goal, automata::Ticks time, std::uint64_t cycle) {
  if (kind_ == Kind::scenario) {
    throw base::InputError("goal: in a scenario the program asserts the goals; step the plant alone to assert others");
  }
  const bool source = compiler::kind_by_name(options_.files.front()) == compiler::Kind::program;
  if (kind_ == Kind::program && !source) {
    throw base::InputError("goal: " + options_.files.front() +
                           ": a compiled program cannot be continued with other goals");
  }
  if (!goal.empty()) (void)goal_option(goal, plant(), "goal", common_);
  const std::vector<Goal> before = goals_;
  std::erase_if(goals_, [&](const Goal& one) { return one.cycle >= cycle; });
  goals_.push_back({goal, time, cycle});
  std::optional<compiler::Compilation> kept = std::move(compilation_);
  const automata::Scenario scenario = scenario_;
  try {
    compile_with_goals();
  } catch (...) {
    goals_ = before;
    compilation_ = std::move(kept);
    scenario_ = scenario;
    throw;
  }
}

bool StepModel::forget_goals_after(std::uint64_t cycle) {
  const std::size_t count = std::erase_if(goals_, [&](const Goal& one) { return one.cycle > cycle; });
  if (count > 0) compile_with_goals();
  return count > 0;
}

std::optional<std::string> StepModel::asked() const {
  if (goals_.empty()) return std::nullopt;
  return goals_.back().text;
}

std::vector<std::string> StepModel::save(const std::string& path, const runtime::FlightSteps& flight) const {
  const fs::path target = path;
  if (target.extension() != ".scn") throw base::InputError("save: expected the name of a scenario, NAME.scn");
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  automata::Scenario scenario = flight.scenario();
  runtime::ScenarioPlaces places;
  std::vector<std::string> written;
  if (kind_ == Kind::scenario) {
    // The scenario's own words for its files, seen from elsewhere.
    const fs::path own = fs::path(options_.files.front()).parent_path();
    for (const compiler::File& file : compilation_->files()) {
      if (!file.scenarios) continue;
      for (const grammar::ScenarioDefinition& definition : file.scenarios->scenarios) {
        if (definition.name.text != scenario_.name) continue;
        for (const grammar::ScenarioItem& item : definition.items) {
          if (const auto* program = std::get_if<grammar::ProgramPart>(&item)) {
            places.program = seen_from(folder, (own / program->path.text).string());
            if (program->main) places.program_main = program->main->text;
          }
          if (const auto* plant = std::get_if<grammar::PlantPart>(&item)) {
            places.plant = seen_from(folder, (own / plant->path.text).string());
            if (plant->main) places.plant_main = plant->main->text;
          }
        }
      }
    }
  } else {
    scenario.name = target.stem().string();
    scenario.duration = std::max(flight.time(), scenario.cycle);
    places.plant = seen_from(folder, options_.files.back());
    if (kind_ == Kind::plant || !goals_.empty()) {
      fs::path program = target;
      program.replace_extension(".rmpl");
      const bool imports = kind_ == Kind::program;
      base::write_file(program.string(), program_text(imports ? seen_from(folder, options_.files.front()) : ""));
      written.push_back(program.string());
      places.program = program.filename().string();
      if (imports) places.program_main = entry_by_hand;
    } else {
      places.program = seen_from(folder, options_.files.front());
      places.program_main = options_.main;
    }
  }
  base::write_file(path, runtime::scenario_text(scenario, flight.plant(), places));
  written.insert(written.begin(), path);
  return written;
}

}  // namespace rmpl::tools
