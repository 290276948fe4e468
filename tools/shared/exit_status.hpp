// How a program ends: the exit codes that scripts rely on.
// SPDX-License-Identifier: MIT
#pragma once

namespace rmpl::tools {

enum class ExitStatus : int {
  done = 0,           ///< done; the property holds; the target is reachable; all expectations are met
  violated = 1,       ///< a property is violated, a target unreachable, an expectation failed; there is no plan
  wrong_input = 2,    ///< the command line or an input is wrong; nothing was written
  undecided = 3,      ///< a limit was hit, memory ran out, or a signal came
  internal_error = 4  ///< a result failed its own check; nothing is claimed
};

}  // namespace rmpl::tools
