// Sixty-four evaluations of a circuit at a time: bit i of every word belongs to the i-th.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/reasoning/diagnose/circuit.hpp"

namespace rmpl::runtime {

using Word = std::uint64_t;

/// Evaluates gate functions over words. Keeps its stack between calls.
class GateEvaluator {
 public:
  /// The function of `gate`; `word_of(net)` gives the word of each input.
  template <class WordOf>
  Word operator()(const CircuitGate& gate, const WordOf& word_of) {
    stack_.clear();
    for (const GateStep& step : gate.function) {
      switch (step.kind) {
        case GateStep::Kind::net:
          stack_.push_back(word_of(step.net));
          break;
        case GateStep::Kind::constant:
          stack_.push_back(step.truth ? ~Word{0} : 0);
          break;
        case GateStep::Kind::negation:
          stack_.back() = ~stack_.back();
          break;
        case GateStep::Kind::conjunction:
          fold(step.count, [](Word a, Word b) { return a & b; });
          break;
        case GateStep::Kind::disjunction:
          fold(step.count, [](Word a, Word b) { return a | b; });
          break;
        case GateStep::Kind::equivalence:
          fold(step.count, [](Word a, Word b) { return ~(a ^ b); });
          break;
      }
    }
    return stack_.back();
  }

 private:
  template <class Operation>
  void fold(std::size_t count, const Operation& operation) {
    for (; count > 1; --count) {
      const Word last = stack_.back();
      stack_.pop_back();
      stack_.back() = operation(stack_.back(), last);
    }
  }
  std::vector<Word> stack_;
};

/// What every net is known to be: its observed value, or nothing.
using Known = std::vector<std::optional<bool>>;

/// A gate that gives a value whatever its inputs are.
struct Forced {
  std::size_t gate;
  bool value;
};

/// The circuit under an observation, where an observed net is cut: what reads it reads the observed value.
class CutSimulation {
 public:
  /// Both must outlive this object. Every net that no gate drives must be known.
  CutSimulation(const Circuit& circuit, const Known& known);

  /// The observed nets to which some gates give another value than the observed one, while all gates but the `forced`
  /// ones (in ascending order) work.
  const std::vector<NetId>& unexplained(std::span<const Forced> forced);
  /// The value of every net in the last simulation, all bits of a word alike.
  [[nodiscard]] const std::vector<Word>& values() const { return values_; }

 private:
  const Circuit& circuit_;
  const Known& known_;
  std::vector<Word> values_;
  std::vector<NetId> unexplained_;
  GateEvaluator evaluate_;
};

}  // namespace rmpl::runtime
