// Clauses of a circuit, with constants folded.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/encoding.hpp"

#include <algorithm>

namespace rmpl::runtime {

using automata::Literal;

Encoding::Encoding(const Circuit& circuit, const Sections& sections, const Known& known,
                   const std::vector<Word>& nominal, const std::vector<bool>& suspects)
    : circuit_(circuit),
      sections_(sections),
      known_(known),
      nominal_(nominal),
      suspects_(suspects),
      true_(sat.fresh()),
      nets_(circuit.nets, 0),
      added_(circuit.gates.size(), 0) {
  sat.prefer_true();
  sat.add({true_});
  for (std::size_t n = 0; n < circuit.nets; ++n) {
    if (known[n]) nets_[n] = *known[n] ? true_ : -true_;
  }
}

void Encoding::include(NetId observed) {
  cone_.clear();
  const auto visit = [&](std::size_t gate) {
    if (added_[gate] != 0) return;
    added_[gate] = 1;
    cone_.push_back(gate);
  };
  visit(*circuit_.driver[observed]);
  for (std::size_t next = 0; next < cone_.size(); ++next) {
    for (const NetId input : circuit_.gates[cone_[next]].inputs) {
      if (!known_[input]) visit(*circuit_.driver[input]);
    }
  }
  std::sort(cone_.begin(), cone_.end());
  for (const std::size_t gate : cone_) add(gate);
}

void Encoding::add(std::size_t g) {
  const CircuitGate& gate = circuit_.gates[g];
  function(gate);
  Literal& output = nets_[gate.output];
  const bool may_fail = *sections_.top[g] == g && faults_ && (suspects_.empty() || suspects_[g]);
  if (!may_fail && output == 0) {
    output = settle();
    return;
  }
  if (operation_ == Operation::none && stack_.back() == output) return;
  if (!may_fail) {
    const Literal value = settle();
    sat.add({output == true_ ? value : -value});
    return;
  }
  if (output == 0) output = fresh(nominal_[gate.output] != 0);
  const Literal works = sat.fresh();
  define(works, output);
  tops.push_back(g);
  healthy.push_back(works);
}

/// Clauses that a gate that works gives its function, straight from the last operation: it needs no literal of its own.
void Encoding::define(Literal works, Literal output) {
  switch (operation_) {
    case Operation::none:
      clause({-works, -output, stack_.back()});
      clause({-works, output, -stack_.back()});
      break;
    case Operation::conjunction: {
      const Literal all = negated_ ? -output : output;
      closing_.assign({-works, all});
      for (const Literal operand : operands_) {
        clause({-works, -all, operand});
        closing_.push_back(-operand);
      }
      clause(closing_);
      break;
    }
    case Operation::equivalence: {
      const Literal a = operands_[0];
      const Literal b = operands_[1];
      const Literal same = negated_ ? -output : output;
      clause({-works, -same, -a, b});
      clause({-works, -same, a, -b});
      clause({-works, same, a, b});
      clause({-works, same, -a, -b});
      break;
    }
  }
}

void Encoding::clause(std::span<const Literal> literals) {
  folded_.clear();
  for (const Literal literal : literals) {
    if (literal == true_) return;
    if (literal != -true_) folded_.push_back(literal);
  }
  sat.add(folded_);
}

/// The last operation as a literal.
Literal Encoding::settle() {
  if (operation_ == Operation::none) return stack_.back();
  Literal result = 0;
  if (operation_ == Operation::conjunction) {
    result = fresh(std::all_of(operands_.begin(), operands_.end(), [](Literal operand) { return operand > 0; }));
    closing_.assign(1, result);
    for (const Literal operand : operands_) {
      sat.add({-result, operand});
      closing_.push_back(-operand);
    }
    sat.add(closing_);
  } else {
    const Literal a = operands_[0];
    const Literal b = operands_[1];
    result = fresh((a > 0) == (b > 0));
    sat.add({-result, -a, b});
    sat.add({-result, a, -b});
    sat.add({result, a, b});
    sat.add({result, -a, -b});
  }
  operation_ = Operation::none;
  return stack_.back() = negated_ ? -result : result;
}

/// Of the literals on the stack from `from` on, which it takes off.
void Encoding::conjunction(std::size_t from) {
  operands_.assign(stack_.begin() + static_cast<std::ptrdiff_t>(from), stack_.end());
  stack_.resize(from);
  std::sort(operands_.begin(), operands_.end());
  operands_.erase(std::unique(operands_.begin(), operands_.end()), operands_.end());
  std::erase(operands_, true_);
  const bool refuted = std::any_of(operands_.begin(), operands_.end(), [this](Literal operand) {
    return operand == -true_ || std::binary_search(operands_.begin(), operands_.end(), -operand);
  });
  if (refuted || operands_.size() < 2) {
    stack_.push_back(refuted ? -true_ : operands_.empty() ? true_ : operands_.front());
    return;
  }
  stack_.push_back(0);
  operation_ = Operation::conjunction;
  negated_ = false;
}

/// Of the two literals on top of the stack, which it takes off.
void Encoding::equivalence() {
  const Literal b = stack_.back();
  stack_.pop_back();
  const Literal a = stack_.back();
  if (a == true_ || a == -true_) {
    stack_.back() = a == true_ ? b : -b;
  } else if (b == true_ || b == -true_) {
    stack_.back() = b == true_ ? a : -a;
  } else if (a == b || a == -b) {
    stack_.back() = a == b ? true_ : -true_;
  } else {
    operands_.assign({a, b});
    operation_ = Operation::equivalence;
    negated_ = false;
  }
}

/// Leaves the value on the stack, or as the operation that gives it.
void Encoding::function(const CircuitGate& gate) {
  stack_.clear();
  operation_ = Operation::none;
  for (const GateStep& step : gate.function) {
    if (step.kind == GateStep::Kind::negation) {
      negate();
      continue;
    }
    if (operation_ != Operation::none) settle();
    switch (step.kind) {
      case GateStep::Kind::net:
        stack_.push_back(nets_[step.net]);
        break;
      case GateStep::Kind::constant:
        stack_.push_back(step.truth ? true_ : -true_);
        break;
      case GateStep::Kind::negation:
        break;
      case GateStep::Kind::conjunction:
        conjunction(stack_.size() - step.count);
        break;
      case GateStep::Kind::disjunction: {
        // The negation of the conjunction of the negations.
        const std::size_t from = stack_.size() - step.count;
        for (std::size_t i = from; i < stack_.size(); ++i) stack_[i] = -stack_[i];
        conjunction(from);
        negate();
        break;
      }
      case GateStep::Kind::equivalence:
        for (std::size_t i = 1; i < step.count; ++i) {
          if (operation_ != Operation::none) settle();
          equivalence();
        }
        break;
    }
  }
}

void Encoding::negate() {
  if (operation_ == Operation::none) {
    stack_.back() = -stack_.back();
  } else {
    negated_ = !negated_;
  }
}

}  // namespace rmpl::runtime
