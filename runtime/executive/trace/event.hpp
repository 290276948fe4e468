// What the executive reports beside its regular flow: conflicts, dead ends, contradictions.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "automata/logic/ids.hpp"

namespace rmpl::runtime {

/// Something in one cycle that a reader of the trace should not have to infer.
struct Event {
  enum class Kind {
    goal_conflict,  ///< two locations assert different modes of one component; the command is idle (semantics 2)
    no_plan,        ///< no commands lead to the goal; the command is idle (semantics 5)
    irreversible,   ///< the command leads where no nominal sequence leads back from
    inconsistent,   ///< readings that nothing explains were set aside (semantics 4); the sequencer does not see them
    cut,            ///< estimation ended early, by a deadline or its limit of candidates
    forced,         ///< the scenario forced a mode in the simulated plant
    commanded,      ///< the scenario commanded in place of the executive, which is told
    // Of a plant outside the process (docs/execute.md):
    connected,      ///< it is there, or there again
    gone,           ///< it ended, broke the connection or was replaced
    refused,        ///< something that it sent is no answer, or a sample that no monitor reads
    late,           ///< it answered an earlier cycle
    flood,          ///< it sent far more than one answer in a cycle
    unacknowledged  ///< it did not answer the command of this cycle while the cycle lasted
  };
  Kind kind = Kind::inconsistent;
  std::string message;                                                             ///< for people; may be empty
  std::optional<automata::ComponentId> component;                                  ///< the one to blame
  std::optional<std::pair<automata::LocationId, automata::LocationId>> locations;  ///< of a goal conflict
  bool operator==(const Event&) const = default;
};

/// The name in traces: `goal-conflict`, `no-plan`, `irreversible`, `inconsistent`, `cut`, `forced`, `commanded`,
/// `connected`, `gone`, `refused`, `late`, `flood`, `unacknowledged`.
std::string_view name_of(Event::Kind kind);

}  // namespace rmpl::runtime
