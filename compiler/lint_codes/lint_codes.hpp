// The codes that lint finds, and what a user has to say of them. Programs that read settings know these; only those
// that lint know the passes. SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "automata/time/time.hpp"
#include "grammar/source/codes.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// What a finding is about; groups have levels, too.
enum class LintGroup {
  impossible,     ///< it can never be, hold or happen
  suspicious,     ///< it is most likely meant otherwise
  unused,         ///< it is there for nothing
  observability,  ///< nothing tells it from something else
  timing,         ///< it does not fit the time there is
  style,          ///< it is easily misread
  allowance       ///< of the `lint: allow` comments themselves
};
/// `impossible`, ….
const char* to_string(LintGroup group);

/// A code that lint finds, with its group and the level that it has where nothing else is said.
struct LintCode {
  grammar::Code code;
  LintGroup group;
  grammar::Severity level;
};

/// All codes that lint finds, by number. Warnings of the compiler are among them.
std::vector<LintCode> lint_codes();
/// The entry of a code; null where lint does not find it.
const LintCode* find_lint_code(grammar::Code code);

/// What a user has to say of lint as a whole.
struct LintSettings {
  std::map<grammar::Code, std::optional<grammar::Severity>> levels;  ///< where not their own; nothing: not to be told
  automata::Ticks cycle{automata::Ticks::per_second / 2};            ///< of the executive, where no scenario says it
};

}  // namespace rmpl::compiler
