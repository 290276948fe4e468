// Names of events.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/event.hpp"

#include "base/check.hpp"

namespace rmpl::runtime {

std::string_view name_of(Event::Kind kind) {
  switch (kind) {
    case Event::Kind::goal_conflict:
      return "goal-conflict";
    case Event::Kind::no_plan:
      return "no-plan";
    case Event::Kind::irreversible:
      return "irreversible";
    case Event::Kind::inconsistent:
      return "inconsistent";
    case Event::Kind::cut:
      return "cut";
    case Event::Kind::forced:
      return "forced";
    case Event::Kind::commanded:
      return "commanded";
    case Event::Kind::connected:
      return "connected";
    case Event::Kind::gone:
      return "gone";
    case Event::Kind::refused:
      return "refused";
    case Event::Kind::late:
      return "late";
    case Event::Kind::flood:
      return "flood";
    case Event::Kind::unacknowledged:
      return "unacknowledged";
  }
  CHECK(false && "every kind of event has a name");
  return {};
}

}  // namespace rmpl::runtime
