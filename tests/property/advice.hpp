// What the reconfigurer says, in the terms of the twins.
// SPDX-License-Identifier: MIT
#pragma once

#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "tests/reference/executive.hpp"

namespace rmpl::property {

inline reference::Advice told(const runtime::Reconfiguration& answer) {
  const bool command = answer.outcome == runtime::Reconfiguration::Outcome::command;
  return {answer.outcome == runtime::Reconfiguration::Outcome::no_plan, answer.action,
          command && answer.why.purpose == runtime::Reason::Purpose::reward};
}

}  // namespace rmpl::property
