// A structure function: which events make a top event true, as a graph of gates; and the order in which a diagram is to
// test the events.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "verifier/safety/decision_diagram.hpp"

namespace rmpl::verifier {

/// A node of `Structure`.
using GateId = std::uint32_t;

/// Gates over events and gates. Equal ones are one.
class Structure {
 public:
  static constexpr GateId zero = 0;  ///< false
  static constexpr GateId one = 1;   ///< true

  Structure();

  /// Events are numbers.
  GateId event(std::uint32_t number) { return gate(Kind::event, {number}); }
  GateId negation(GateId f);
  GateId conjunction(std::vector<GateId> inputs) { return junction(Kind::conjunction, std::move(inputs)); }
  GateId disjunction(std::vector<GateId> inputs) { return junction(Kind::disjunction, std::move(inputs)); }
  GateId equivalence(GateId f, GateId g);

  /// The same function in fewer gates: beside an event in a disjunction, gates are simplified by its absence, in a
  /// conjunction by its presence (I. Niemela: On simplification of large fault trees, 1994). At a cost of few visits a
  /// gate.
  GateId simplified(GateId top);

  /// The events below a gate, each once, in an order that keeps its diagram small: depth first, so that what belongs
  /// together is tested together; of a gate's inputs gates first, and those that most others read.
  [[nodiscard]] std::vector<std::uint32_t> order(GateId top) const;

  /// The diagram of a gate, in which an event is tested as this variable.
  NodeId diagram(GateId top, const std::vector<std::uint32_t>& variables, Diagrams& diagrams) const;

 private:
  enum class Kind : std::uint8_t { constant, event, negation, conjunction, disjunction, equivalence };
  struct Gate {
    Kind kind;
    std::vector<GateId> inputs;  ///< of an event its number
    auto operator<=>(const Gate&) const = default;
  };

  class Simplifier;

  GateId gate(Kind kind, std::vector<GateId> inputs);
  GateId junction(Kind kind, std::vector<GateId> inputs);
  /// By gate up to this one: whether it is that one, or below it.
  [[nodiscard]] std::vector<bool> below(GateId top) const;

  std::vector<const Gate*> gates_;  ///< each after its inputs
  std::map<Gate, GateId> numbers_;
};

}  // namespace rmpl::verifier
