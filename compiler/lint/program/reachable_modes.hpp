// The modes that components can get into: more than that is out of reach, whatever is commanded and whatever fails.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/plant.hpp"
#include "automata/scenario.hpp"

namespace rmpl::compiler {

/// What may happen beside nominal transitions.
struct MayHappen {
  bool faults = true;
  bool commands = true;  ///< else all controls are idle
};

/// Per component and mode, whether it may be reached: from the modes that have a probability at the start and those
/// in `also`, by transitions whose guards can hold while every component is in one of its reached modes. What is not
/// reached by this is never reached; what is reached may still not be, as commands and times are taken to be free.
class ReachableModes {
 public:
  /// Refers to the plant.
  ReachableModes(const automata::Plant& plant, const std::vector<automata::Assignment>& also, MayHappen may = {});

  [[nodiscard]] bool reached(automata::Assignment mode) const;
  /// All components in one of their reached modes.
  [[nodiscard]] automata::Formula formula() const;

  /// What is so at the start, at the end of the first cycle, in which a component takes one transition at most, and
  /// then for ever: each as `formula`.
  static std::vector<automata::Formula> by_cycle(const automata::Plant& plant,
                                                 const std::vector<automata::Assignment>& also);

 private:
  explicit ReachableModes(const automata::Plant& plant) : plant_(plant) {}
  void start(const std::vector<automata::Assignment>& also);
  /// By one transition of each component. Whether anything is new.
  bool grow();

  const automata::Plant& plant_;
  MayHappen may_;
  std::vector<std::vector<bool>> reached_;
};

/// The modes that a scenario starts in or forces, besides what the plant says.
std::vector<automata::Assignment> added_modes(const automata::Scenario& scenario, const automata::Plant& plant);

}  // namespace rmpl::compiler
