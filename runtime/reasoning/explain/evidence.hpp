// The evidence of a diagnosis: why the most likely story without the fault does not hold.
//
// The story is a plant state; it is refuted by a conflict in the sense of livingstone, between readings, modes and
// interconnections. It is made minimal by deletion (J. Marques-Silva: Minimal Unsatisfiability, 2010), readings first,
// so that few of them remain.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::runtime {

struct Evidence {
  enum class Kind {
    refuted,     ///< what is listed contradicts itself, and nothing of it can be spared
    outweighed,  ///< the story allows what is seen: it was less likely, or left open the readings that are listed
    unavoidable  ///< there is no story: every step from what was believed ends in the fault
  };
  automata::ComponentId component;
  automata::ModeId fault;  ///< which the component is believed to be in
  automata::Modes story;   ///< the most likely modes without that; empty where the fault is unavoidable
  Kind kind = Kind::outweighed;
  std::vector<automata::Assignment> readings;  ///< in order of variable
  std::vector<automata::ComponentId> modes;    ///< whose modes in the story take part, with their constraints
  std::vector<std::size_t> interconnections;   ///< that take part, by position in the plant
  /// How many times more probable the estimate is than the story, of an outweighed one that is still believed; else 0.
  double ratio = 0;
  bool operator==(const Evidence&) const = default;
};

/// Explains diagnoses of one plant, to which it keeps a reference.
class Evidences {
 public:
  explicit Evidences(const automata::Plant& plant);

  /// Why `component`, in an `estimate`, is in a fault mode: `story` are the most likely modes without it
  /// (`Estimator::likeliest_without`) and `observation` what was seen. A question to the solver for each that is
  /// listed.
  Evidence of(automata::ComponentId component, const automata::Modes& estimate, const automata::Modes& story,
              const automata::Observation& observation);

 private:
  void outweigh(Evidence& evidence, const automata::Modes& estimate, const automata::Observation& observation);
  [[nodiscard]] std::vector<automata::Assignment> store(const automata::Modes& modes) const;
  bool entails(const std::vector<automata::Assignment>& store, automata::Assignment reading);

  const automata::Plant& plant_;
  /// Over the plant's variables, then one for each component, which of its modes is told, and one for each
  /// interconnection, whether it is: what is not told says nothing.
  automata::Theory theory_;
};

}  // namespace rmpl::runtime
