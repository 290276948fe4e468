// What a file says of lint: levels by code and by group, and the cycle.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/lint_codes/lint_codes.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::tools {

/// Keys and values as in the section `lint` of rmpl.ini and the table `lint` of rmpl.toml. What is taken later counts.
class LintLevels {
 public:
  /// Takes a value; false where there is no such key. Throws BadValue where the key has no such value: what
  /// the key is, to go on with behind its name.
  bool take(const std::string& key, const std::string& value);
  /// What it comes to. A code has the last word over its group.
  [[nodiscard]] compiler::LintSettings settings() const;
  /// The least severe findings that count, where it is said.
  [[nodiscard]] std::optional<grammar::Severity> level() const { return level_; }
  /// All keys that there are.
  static std::vector<std::string> keys();

 private:
  using Level = std::optional<grammar::Severity>;  ///< nothing: not to be told

  compiler::LintSettings by_code_;
  std::map<compiler::LintGroup, Level> by_group_;
  std::optional<grammar::Severity> level_;
};

}  // namespace rmpl::tools
