// Levels by code and group.
// SPDX-License-Identifier: MIT
#include "tools/shared/lint_levels.hpp"

#include <array>

#include "tools/shared/command.hpp"

namespace rmpl::tools {
namespace {

using compiler::LintGroup;
using grammar::Severity;

constexpr std::array groups = {LintGroup::impossible,    LintGroup::suspicious, LintGroup::unused,
                               LintGroup::observability, LintGroup::timing,     LintGroup::style,
                               LintGroup::allowance};

std::optional<Severity> level_of(const std::string& value) {
  if (value == "off") return std::nullopt;
  for (const Severity severity : {Severity::note, Severity::warning, Severity::error}) {
    if (value == grammar::to_string(severity)) return severity;
  }
  throw BadValue("is off, note, warning or error, not '" + value + "'");
}

automata::Ticks cycle_of(const std::string& value) {
  const auto cycle = automata::parse_duration(value);
  if (cycle && !cycle->is_infinite() && *cycle > automata::Ticks{0}) return *cycle;
  throw BadValue("is a finite duration above 0, as in 0.5 s, not '" + value + "'");
}

}  // namespace

bool LintLevels::take(const std::string& key, const std::string& value) {
  if (key == "level") {
    const Level level = level_of(value);
    if (!level) throw BadValue("is note, warning or error");
    level_ = level;
    return true;
  }
  if (key == "cycle") {
    by_code_.cycle = cycle_of(value);
    return true;
  }
  for (const LintGroup group : groups) {
    if (key != compiler::to_string(group)) continue;
    by_group_[group] = level_of(value);
    return true;
  }
  const auto code = key.starts_with("RMPL") ? grammar::find_code(key) : std::nullopt;
  if (!code || compiler::find_lint_code(*code) == nullptr) return false;
  by_code_.levels[*code] = level_of(value);
  return true;
}

compiler::LintSettings LintLevels::settings() const {
  compiler::LintSettings result = by_code_;
  for (const auto& [group, level] : by_group_) {
    for (const compiler::LintCode& code : compiler::lint_codes()) {
      if (code.group == group) result.levels.emplace(code.code, level);
    }
  }
  return result;
}

std::vector<std::string> LintLevels::keys() {
  std::vector<std::string> names = {"level", "cycle"};
  for (const LintGroup group : groups) names.emplace_back(compiler::to_string(group));
  for (const compiler::LintCode& code : compiler::lint_codes()) names.push_back(to_string(code.code));
  return names;
}

}  // namespace rmpl::tools
