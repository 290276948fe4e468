// One word each, in traces, reports and answers.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/outcome.hpp"

namespace rmpl::runtime {

std::string_view name_of(Reconfiguration::Outcome outcome) {
  switch (outcome) {
    case Reconfiguration::Outcome::command:
      return "command";
    case Reconfiguration::Outcome::wait:
      return "wait";
    case Reconfiguration::Outcome::no_plan:
      return "no-plan";
    case Reconfiguration::Outcome::nothing_to_do:
      return "nothing-to-do";
  }
  return {};
}

}  // namespace rmpl::runtime
