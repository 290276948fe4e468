// Beliefs: their order, their sum, the plant state that they favour, and which clocks they keep.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "base/function_ref.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime {

/// Puts a belief into the order that `Belief` promises: ties in order of state.
void put_in_order(Belief& belief);

/// The sum of the probabilities, in order.
double total(const Belief& belief);

/// Divides by the total, where that is positive.
void normalise(Belief& belief);

/// The most likely plant state, summed over clocks, with its share of the belief: `modes` and `probability` of an
/// estimate. Ties go to the state first in declaration order; an empty belief leaves the estimate as it is. `go_on` is
/// called often, and may throw: a belief of millions takes seconds to sort.
void tell_most_likely(const Belief& belief, Estimate& estimate, base::FunctionRef<void()> go_on);
inline void tell_most_likely(const Belief& belief, Estimate& estimate) {
  tell_most_likely(belief, estimate, [] {});
}

/// The likeliest initial mode of each component, taken by itself: what an estimate says where no initial state is
/// possible.
automata::Modes likeliest_initial_modes(const automata::Plant& plant);

/// When the clock of a component starts anew, and whether it is kept at all.
class Clocks {
 public:
  /// With `live_only`, the clock start of a component in a mode that needs no clock (clock_use.hpp) is 0 whatever
  /// happened.
  Clocks(const automata::Plant& plant, bool live_only);

  /// The clock start of `component` after the step that ends at `now` and takes it from a mode entered at `start` to
  /// `to`: PlantStep::advance for one component, without what is to be forgotten. `restarted`: by a restart (see
  /// PlantStep::restarted).
  [[nodiscard]] automata::Ticks advance(std::size_t component, automata::ModeId from, automata::Ticks start,
                                        automata::ModeId to, automata::Ticks now, bool restarted) const {
    if (from == to && !restarted) return start;
    return live_only_ && !live(component, to) ? automata::Ticks{} : now;
  }
  /// Makes `result` the components whose clocks are kept in the modes, ascending. The others have clock starts of 0.
  void kept(const automata::Modes& modes, std::vector<std::size_t>& result) const {
    result.clear();
    for (std::size_t c = 0; c < modes.size(); ++c) {
      if (!live_only_ || live(c, modes[c])) result.push_back(c);
    }
  }
  /// Whether the clock makes a difference in the mode.
  [[nodiscard]] bool live(std::size_t component, automata::ModeId mode) const { return live_[component][mode.index()]; }

 private:
  std::vector<std::vector<bool>> live_;  ///< per component, per mode
  bool live_only_;
};

struct SystemStateHash {
  std::size_t operator()(const automata::SystemState& state) const noexcept;
};

}  // namespace rmpl::runtime
