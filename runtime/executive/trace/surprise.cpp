// Lists the readings that were set aside, in words.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/surprise.hpp"

#include "automata/assignment_text.hpp"

namespace rmpl::runtime {

std::optional<Event> surprise_of(const Estimate& estimate, const automata::Variables& variables) {
  if (estimate.consistent) return std::nullopt;
  std::string text;
  if (!estimate.set_aside.empty()) {
    text = "no tracked state explains " + to_text(variables, estimate.set_aside) + ": set aside";
  }
  if (!estimate.follows) {
    text += std::string(text.empty() ? "" : "; ") + "no state can follow a tracked state: the belief stays";
  }
  return Event{Event::Kind::inconsistent, std::move(text), std::nullopt, std::nullopt};
}

}  // namespace rmpl::runtime
