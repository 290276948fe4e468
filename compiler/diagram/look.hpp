// What the locations of a picture have beside the automaton of every program: what they tell, and what they draw.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "automata/phca.hpp"

namespace rmpl::compiler {

/// One function of a choice: a dot of its own in the picture.
struct DrawnFunction {
  std::string probability;
  std::vector<automata::GuardedArc> arcs;       ///< from the dot
  std::vector<automata::LocationId> beginning;  ///< locations that count as started, and are in the picture
  bool before_start = false;                    ///< drawn before time 0: what begins is marked
};

/// Of a control program all is empty.
struct Look {
  std::vector<std::string> told;                                       ///< per location, or of none
  std::map<automata::LocationId, std::vector<DrawnFunction>> choices;  ///< per `choose`
  std::vector<bool> hidden;  ///< per location, or of none: its arcs begin at the dots of a choice, and it is not drawn
};

}  // namespace rmpl::compiler
