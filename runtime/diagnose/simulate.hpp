// Sixty-four evaluations of a circuit at a time: bit i of every word belongs to the i-th.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/diagnose/circuit.hpp"

namespace runtime {

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

}  // namespace runtime
