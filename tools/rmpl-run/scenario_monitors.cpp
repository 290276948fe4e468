// By the command line, or by the sets of the project.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/scenario_monitors.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "base/error.hpp"

namespace rmpl::tools {
namespace {

std::string canonical(const std::string& path) {
  std::error_code error;
  const auto whole = std::filesystem::weakly_canonical(path, error);
  return error ? path : whole.string();
}

}  // namespace

ScenarioMonitors::ScenarioMonitors(std::vector<std::string> given, const std::optional<Manifest>& manifest)
    : given_(std::move(given)) {
  if (!given_.empty() || !manifest) return;
  manifest_ = manifest->path;
  for (const ManifestSet& set : manifest->sets) {
    if (set.monitors.empty() || set.scenarios.empty()) continue;
    SetFiles files;
    try {
      files = files_of(*manifest, set);
    } catch (const base::InputError&) {
      continue;
    }
    for (const std::string& scenarios : files.scenarios) {
      const auto [known, fresh] = sets_.emplace(canonical(scenarios), InSets{set.name, files.monitors, {}});
      if (!fresh && known->second.monitors != files.monitors) known->second.other = set.name;
    }
  }
}

std::vector<std::string> ScenarioMonitors::of(const std::string& scenarios) const {
  if (!given_.empty() || sets_.empty()) return given_;
  const auto found = sets_.find(canonical(scenarios));
  if (found == sets_.end()) return {};
  if (!found->second.other.empty()) {
    throw base::InputError(scenarios + ": the sets '" + found->second.set + "' and '" + found->second.other + "' of " +
                           manifest_ + " contain it, with different monitors; choose with --monitors");
  }
  return found->second.monitors;
}

void add_monitors(Command& command, std::vector<std::string>& monitors) {
  command
      .add_option("--monitors", monitors,
                  "monitors that turn samples of channels into readings; may be given several times\n(default: those "
                  "of the scenario's set in rmpl.toml)")
      .option_text("FILE.mon")
      .repeatable();
}

std::vector<std::string> with_monitors(const std::string& scenarios, const std::vector<std::string>& monitors) {
  std::vector<std::string> paths{scenarios};
  paths.insert(paths.end(), monitors.begin(), monitors.end());
  return paths;
}

}  // namespace rmpl::tools
