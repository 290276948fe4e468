// The monitors that scenarios are flown with.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/session/compiler.hpp"
#include "tools/shared/manifest.hpp"
#include "tools/shared/options.hpp"

namespace rmpl::tools {

/// Files of monitors: those that the command line names, else those of the project's set that has the scenarios.
class ScenarioMonitors {
 public:
  /// Sets that name what there is not are passed over: `rmplc test` tells of them.
  ScenarioMonitors(std::vector<std::string> given, const std::optional<Manifest>& manifest);

  /// Those of a file of scenarios. Throws base::InputError where sets of the project disagree.
  [[nodiscard]] std::vector<std::string> of(const std::string& scenarios) const;

 private:
  struct InSets {
    std::string set;
    std::vector<std::string> monitors;
    std::string other;  ///< a set that has others; empty: none
  };

  std::vector<std::string> given_;
  std::string manifest_;
  std::map<std::string, InSets> sets_;  ///< by the canonical path of a file of scenarios
};

/// `--monitors`, which may be given several times.
void add_monitors(Command& command, std::vector<std::string>& monitors);

/// What is compiled together to fly a file of scenarios, and how.
std::vector<std::string> with_monitors(const std::string& scenarios, const std::vector<std::string>& monitors);
inline compiler::Options to_be_flown() { return {.main = "", .monitors = true, .flown = true}; }

}  // namespace rmpl::tools
