// Files of scenarios: each by itself.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/scenario_files.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/limit_error.hpp"
#include "compiler/session/files.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/program.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

ScenarioFile read_scenario_file(const std::string& path, const ScenarioMonitors& monitors, const Common& common) {
  auto compilation = std::make_shared<const compiler::Compilation>(
      load(with_monitors(path, monitors.of(path)), common, to_be_flown()));
  const automata::Document& document = compilation->document();
  if (!document.scenarios.empty()) return {path, compilation, 0, document.scenarios.size()};
  if (is_model_program(document)) {
    throw base::InputError(path +
                           ": this is a model program; give --commands, the list of commands to simulate it under");
  }
  throw base::InputError(path + ": expected a scenario, but the file has none");
}

/// The files compiled together; nothing where there is anything to say of one of them, which is said file by file.
std::vector<ScenarioFile> read_together(const std::vector<std::string>& paths,
                                        const std::vector<std::string>& monitors) {
  std::vector<std::string> inputs = paths;
  inputs.insert(inputs.end(), monitors.begin(), monitors.end());
  std::optional<compiler::Compilation> compiled;
  try {
    compiled = compiler::compile(inputs, to_be_flown());
  } catch (const base::InputError&) {
    return {};
  }
  if (!compiled->findings().diagnostics.empty()) return {};
  std::vector<std::size_t> counts;  // in the order of the paths
  for (const compiler::File& file : compiled->files()) {
    if (file.named && file.scenarios) counts.push_back(file.scenarios->scenarios.size());
  }
  if (counts.size() != paths.size()) return {};  // one file under two names
  compiled->forget_files();
  const auto shared = std::make_shared<const compiler::Compilation>(std::move(*compiled));
  std::vector<ScenarioFile> result;
  std::size_t first = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    result.push_back({paths[i], shared, first, counts[i]});
    first += counts[i];
  }
  return result;
}

/// Those of several files that can be compiled together, by path. What can be read once only is left alone, and paths
/// in a document are relative to one folder. What is wrong with the monitors of one is told where it is read alone.
std::map<std::string, ScenarioFile> read_folders(const std::vector<std::string>& paths,
                                                 const ScenarioMonitors& monitors) {
  std::map<std::pair<std::filesystem::path, std::vector<std::string>>, std::vector<std::string>> folders;
  for (const std::string& path : paths) {
    std::error_code unknown;
    const bool regular = std::filesystem::is_regular_file(path, unknown);
    if (!regular || compiler::kind_by_name(path) != compiler::Kind::scenario) continue;
    try {
      folders[{std::filesystem::path(path).parent_path(), monitors.of(path)}].push_back(path);
    } catch (const base::InputError&) {
      continue;
    }
  }
  std::map<std::string, ScenarioFile> result;
  for (const auto& [place, together] : folders) {
    if (together.size() < 2 || interrupted()) continue;
    for (ScenarioFile& file : read_together(together, place.second)) result.emplace(file.path, std::move(file));
  }
  return result;
}

bool is_asked_for(const std::string& name, const std::vector<std::string>& only) {
  return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
}

/// An unknown name is an error where all names are known: a file that was not read may have it.
void check_names(const std::vector<ScenarioFile>& files, const FlightOptions& options) {
  std::vector<std::string_view> names;
  for (const ScenarioFile& file : files) {
    if (!file.compilation) return;
    for (const automata::Scenario& scenario : file.scenarios()) names.push_back(scenario.name);
  }
  for (const std::string& name : options.only) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string where = files.size() == 1 ? files.front().path : std::to_string(files.size()) + " files";
    std::string message = where;
    message.append(": no scenario is called '").append(name).append("'").append(suggestion_or_list(name, names));
    throw base::InputError(message);
  }
}

}  // namespace

std::vector<ScenarioFile> read_scenarios(const std::vector<std::string>& paths, const ScenarioMonitors& monitors,
                                         const Common& common) {
  std::vector<ScenarioFile> files;
  std::map<std::string, ScenarioFile> read = read_folders(paths, monitors);
  for (const std::string& path : paths) {
    files.push_back({path});
    if (interrupted()) continue;
    if (const auto known = read.find(path); known != read.end()) {
      files.back() = known->second;
      continue;
    }
    try {
      files.back() = read_scenario_file(path, monitors, common);
    } catch (const base::LimitError&) {
      if (!interrupted()) throw;
    } catch (const Rejected& rejected) {
      if (paths.size() == 1) throw;
      files.back().wrong = rejected.text;
    } catch (const base::InputError& error) {
      if (paths.size() == 1) throw;
      tell(error.what());
      files.back().wrong = error.what() + std::string("\n");
    }
  }
  return files;
}

std::vector<Task> tasks_of(const std::vector<ScenarioFile>& files, const FlightOptions& options) {
  check_names(files, options);
  std::vector<Task> result;
  // What reconfiguration computes beforehand, once for each plant.
  std::map<const automata::Plant*, std::shared_ptr<const runtime::NominalGraph>> graphs;
  for (const ScenarioFile& file : files) {
    if (!file.compilation) continue;
    const automata::Document& document = file.compilation->document();
    for (const automata::Scenario& scenario : file.scenarios()) {
      if (!is_asked_for(scenario.name, options.only)) continue;
      std::shared_ptr<const runtime::NominalGraph> graph;
      if (!interrupted()) {
        const automata::Plant& plant = document.plants[scenario.plant];
        auto& known = graphs[&plant];
        if (!known) known = runtime::reconfiguration_graph(plant);
        graph = known;
      }
      result.push_back({file.path, &document, &scenario, graph});
    }
  }
  for (const auto& [option, path] : {std::pair{"--trace", &options.trace}, std::pair{"--vcd", &options.vcd},
                                     std::pair{"--csv", &options.csv}, std::pair{"--mcap", &options.mcap}}) {
    if (result.size() <= 1 || path->empty()) continue;
    const bool one = files.size() == 1;
    throw base::InputError(std::string(option) + " writes one scenario, but " +
                           (one ? files.front().path + " has " : std::to_string(files.size()) + " files have ") +
                           std::to_string(result.size()) + "; choose one with --only");
  }
  return result;
}

}  // namespace rmpl::tools
