// The rules of semantics 3 over a plain store: the step function for checks, which remembers nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/step/transition_rules.hpp"
#include "automata/store/plain_store.hpp"

namespace rmpl::automata {

/// The step function of a plant as `PlantStep` is, slower, and apart from all that the search made use of: each
/// question goes to a solver of its own. To check what a search found, make one beside it:
///   PlainStep rules(plant);
///   rules.store().possible(modes);                             // no impossible state
///   lead(rules.moves(state, action, before, now), next);       // the step can be taken (sampled time)
///   rules.enabled(modes, action)                               // per component, for the reader's own timing rules
class PlainStep {
 public:
  explicit PlainStep(const Plant& plant) : store_(plant), has_restarts_(automata::has_restarts(plant)) {}

  [[nodiscard]] const Plant& plant() const { return store_.plant(); }
  [[nodiscard]] PlainStore& store() { return store_; }
  /// Whether the modes are possible.
  bool possible(const Modes& modes) { return store_.possible(modes); }
  /// Per component, what the store of the modes and the control action enable.
  std::vector<Enabled> enabled(const Modes& modes, const ControlAction& action);
  /// Per component, whether a restart starts its clock anew in the step from there.
  std::vector<bool> restarted(const Modes& modes, const ControlAction& action);
  /// The state after moving to `next` at `now` under the action.
  SystemState advance(const SystemState& state, const ControlAction& action, const Modes& next, Ticks now);
  /// What each component may do in the step from `before` to `now`.
  std::vector<std::vector<Move>> moves(const SystemState& state, const ControlAction& action, Ticks before, Ticks now);

 private:
  PlainStore store_;
  bool has_restarts_;
};

}  // namespace rmpl::automata
