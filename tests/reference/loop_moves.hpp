// What the components of a closed loop may do in a cycle, in both readings of time (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/reference/endless.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::reference {

/// Remembers what it was asked. Keeps a reference to the step.
class LoopMoves {
 public:
  /// `period`: of the cycles; none for dense time, which passes in units.
  LoopMoves(const Step& step, std::optional<automata::Ticks> period, automata::Ticks unit);

  /// The step of time.
  [[nodiscard]] automata::Ticks unit() const { return unit_; }
  /// Beyond all constants: clocks need not be told apart there.
  [[nodiscard]] automata::Ticks cap() const { return cap_; }

  /// What a component may do: a mode, and whether that is a fault. `from` and `to` are its clock around the step.
  std::vector<std::pair<automata::ModeId, bool>> choices(const automata::Modes& modes, std::size_t component,
                                                         const automata::ControlAction& action, automata::Ticks from,
                                                         automata::Ticks to);
  /// In dense time, whether a component's going to a mode at this reading is more than something of one instant, as
  /// RunEdge tells it.
  int lasts(const automata::Modes& modes, std::size_t component, const automata::ControlAction& action,
            automata::Ticks clock, automata::ModeId to);
  std::vector<const automata::Transition*> enabled(const automata::Modes& modes, std::size_t component,
                                                   const automata::ControlAction& action);
  const Exits& exits(const automata::Modes& modes, const automata::ControlAction& action);
  /// Whether a transition that could ever be taken leads there with all controls idle.
  bool idle_leads(const automata::Modes& modes, std::size_t component, automata::ModeId to);

 private:
  /// What a component may do without a fault at some reading of its clock: `late` at one beyond all bounds.
  std::set<automata::ModeId> nominal(const automata::Modes& modes, std::size_t component,
                                     const automata::ControlAction& action, bool late);

  const Step& step_;
  const automata::Plant& plant_;
  const std::optional<automata::Ticks> period_;
  const automata::Ticks unit_;
  automata::Ticks cap_;
  std::map<std::pair<automata::Modes, automata::ControlAction>, Exits> exits_;
  std::map<std::tuple<automata::Modes, std::size_t, automata::ControlAction>, std::vector<const automata::Transition*>>
      enabled_;
};

}  // namespace rmpl::reference
