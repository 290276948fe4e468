// Like modes: those of one component that say the same to the rest of the plant.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::verifier {

/// Of modes of a component with the same constraint, which no formula of the plant tells apart by name, the store
/// cannot tell which it is in: what it allows and implies of anything but that mode variable is the same. (A process
/// that waits, whatever for.) Answers about the others are therefore known for all of them once they are for the first.
class LikeModes {
 public:
  explicit LikeModes(const automata::Plant& plant);

  /// The modes with the first of its like for each. `result` may have any size.
  void read(const automata::Modes& modes, automata::Modes& result) const;

 private:
  std::vector<std::vector<automata::ModeId>> first_;  ///< per component, per mode
};

}  // namespace rmpl::verifier
