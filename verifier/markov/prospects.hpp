// At most how likely it is to come to a target, told by the few components that decide it.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "automata/plant.hpp"
#include "verifier/markov/process.hpp"
#include "verifier/property/commands.hpp"
#include "verifier/search/limits.hpp"

namespace rmpl::verifier {

/// What the target reads, and all that decides the steps of these, is a plant of its own, whose commands are free. Of
/// its modes m there is a bound V(m, n) = once + n * each_step of coming to the target within n steps: whatever
/// is commanded and whatever clocks read, one step leads to a mean of V(., n - 1) that is no more than V(m, n), which
/// is checked (H. Kushner: Stochastic stability and control, 1967). What a program commands is one way to command, and
/// what other components do is independent of these.
class Prospects {
 public:
  struct Question {
    const automata::Formula& target;
    bool entailed;
    Commands commands;
    const std::vector<automata::Assignment>& from;
    automata::Ticks period;
    Units steps;
  };

  /// Tells nothing where the components have too many modes together. Throws LimitReached.
  Prospects(const automata::Plant& plant, const Question& question, Meter& meter);

  [[nodiscard]] Prospect of(const automata::Modes& modes) const;

 private:
  std::vector<automata::ComponentId> cone_;
  std::map<automata::Modes, Prospect> known_;  ///< by modes of the cone
};

}  // namespace rmpl::verifier
