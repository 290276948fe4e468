// Why something cannot be: interconnections, modes and missing modes that exclude it, none of which can be spared.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "compiler/lint/plant/questions.hpp"

namespace rmpl::compiler {

/// What contradicts. All of it together does, and nothing less.
struct Contradiction {
  std::vector<std::size_t> interconnections;  ///< positions in the plant
  std::vector<automata::Assignment> assumed;  ///< of what was assumed; a mode stands for its constraint
  std::vector<automata::Assignment> never;    ///< modes that components are not kept to
  [[nodiscard]] bool empty() const { return interconnections.empty() && assumed.empty() && never.empty(); }
};

/// Keeps a reference to the plant. A theory in which each interconnection can be told or not; made for the few
/// questions that were answered with no.
class Blame {
 public:
  /// Components are kept to these modes.
  Blame(const automata::Plant& plant, const ModeSets& modes);

  /// Why the assumptions cannot hold together with the formula. Empty where they can. A component whose mode is assumed
  /// may be in it.
  Contradiction of(std::span<const automata::Assignment> assumptions, const automata::Formula& formula);

 private:
  const automata::Plant& plant_;
  automata::Theory theory_;
  std::vector<automata::Assignment> told_;      ///< by interconnection
  std::vector<automata::Assignment> excluded_;  ///< in the order of `never_`
  std::vector<automata::Assignment> never_;
};

}  // namespace rmpl::compiler
