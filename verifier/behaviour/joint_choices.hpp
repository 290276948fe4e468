// What all components do at once, whatever their stores say of it: choices multiplied out.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "base/product.hpp"
#include "verifier/behaviour/choices.hpp"

namespace rmpl::verifier {

/// An interval for the clock of one component, which is live.
struct ClockBound {
  automata::ComponentId component;
  Interval clock;
  Sharp sharp = {};  ///< see `Choice`
  auto operator<=>(const ClockBound&) const = default;
};

/// A box: all of its bounds hold. Sorted by component, trivial bounds left out.
using Box = std::vector<ClockBound>;

/// One choice of every component.
struct JointChoice {
  automata::Modes modes;
  unsigned faults = 0;
  Box bounds;
  auto operator<=>(const JointChoice&) const = default;
};

/// `visit(joint)` for every joint choice with no more faults than that, depth first in declaration order.
template <class Visit>
void for_each_joint(const std::vector<std::vector<Choice>>& choices, unsigned faults, const Visit& visit) {
  JointChoice joint;
  base::multiply_out(
      choices,
      [&](std::size_t c, std::size_t i) {
        const Choice& choice = choices[c][i];
        if (joint.faults + choice.faults > faults) return false;
        joint.modes.push_back(choice.mode);
        joint.faults += choice.faults;
        if (!choice.clock.is_trivial()) joint.bounds.push_back({automata::ComponentId(c), choice.clock, choice.sharp});
        return true;
      },
      [&](std::size_t c, std::size_t i) {
        const Choice& choice = choices[c][i];
        joint.modes.pop_back();
        joint.faults -= choice.faults;
        if (!choice.clock.is_trivial()) joint.bounds.pop_back();
      },
      [&] {
        visit(static_cast<const JointChoice&>(joint));
        return false;
      });
}

}  // namespace rmpl::verifier
