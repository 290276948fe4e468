// What follows from a set of assumptions by unit propagation, kept as assumptions come and go.
//
// A logic-based truth maintenance system in the manner of Nayak and Williams, "Fast Context Switching in Real-time
// Propositional Reasoning" (AAAI 1997): each consequence knows the clause that it rests on, so that an assumption which
// goes takes along just what rested on it. From one question to the next little changes, and little is worked out.
//
// Unit propagation alone decides neither consistency nor entailment. So the literals that it leaves open are guessed,
// in the phase that they had last: what is guessed and survives propagation is a model. A conflict that rests on a
// guess takes that guess back; one that rests on assumptions alone is a refutation. After a few guesses in vain a
// solver has to be asked, whose model is then adopted.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "automata/logic/sat.hpp"

namespace rmpl::automata {

class TruthMaintenance {
 public:
  enum class Answer {
    consistent,    ///< a model was found: `value` and `follows` tell of it
    inconsistent,  ///< `failed` names the assumptions to blame
    open           ///< ask a solver, and `adopt` its model if there is one
  };

  /// Makes room for the variables up to `last`.
  void reserve(std::uint32_t last);
  /// Adds a clause over the variables 1, 2, …
  void add(std::span<const Literal> clause);
  /// Whether the clauses can hold together with the assumptions.
  Answer ask(std::span<const Literal> assumptions);
  /// What is guessed of this variable next, should it be guessed.
  void prefer(Literal literal) { phases_[variable(literal)] = sign(literal); }
  /// After `ask` left it open: takes over the model that a solver of the same clauses found under the same assumptions.
  void adopt(std::span<const Literal> assumptions, const Sat& solver);

  /// After `ask` answered consistent, or `adopt`: whether the literal is true in the model.
  [[nodiscard]] bool value(Literal literal) const { return values_[variable(literal)] == sign(literal); }
  /// Then also: whether propagation derives it from the assumptions, so that they imply it. Sufficient only.
  [[nodiscard]] bool follows(Literal literal) const { return value(literal) && certain_[variable(literal)] != 0; }
  /// Of a literal that follows: makes `failed` name the assumptions that it follows from.
  void explain(Literal literal);
  /// After `ask` answered inconsistent, or `explain`: whether the assumption takes part in the refutation.
  [[nodiscard]] bool failed(Literal assumption) const;

 private:
  using Clause = std::uint32_t;
  using Variable = std::uint32_t;
  enum class Reason : std::uint8_t { none, clause, assumption, guess };

  static Variable variable(Literal literal) { return static_cast<Variable>(literal < 0 ? -literal : literal); }
  static std::int8_t sign(Literal literal) { return literal < 0 ? std::int8_t{-1} : std::int8_t{1}; }
  [[nodiscard]] std::vector<Clause>& occurrences(Literal literal);
  [[nodiscard]] std::span<const Literal> literals(Clause clause) const;
  [[nodiscard]] bool is_true(Literal literal) const { return values_[variable(literal)] == sign(literal); }
  [[nodiscard]] bool is_false(Literal literal) const { return values_[variable(literal)] == -sign(literal); }

  void assign(Literal literal, Reason reason, Clause clause, bool certain);
  void retract(Variable variable);
  void note_unit(Clause clause);
  void propagate();
  /// What a set of assigned literals rests on: the assumptions into `support_`; returns the last guess, or 0.
  Variable trace(std::span<const Literal> from);
  void take_back(Variable guess);
  Answer assume(Literal literal);
  Answer complete();

  // Clauses, one after the other in `literals_`.
  std::vector<Literal> literals_;
  std::vector<std::uint32_t> begin_;              ///< per clause, and the end
  std::vector<std::uint32_t> not_false_;          ///< per clause: how many of its literals are not false
  std::vector<Variable> implied_;                 ///< per clause: the variable that rests on it, or 0
  std::vector<std::vector<Clause>> occurrences_;  ///< per literal
  // Variables.
  std::vector<std::int8_t> values_;  ///< 1, -1, or 0 while it has none
  std::vector<std::int8_t> phases_;  ///< the last value
  std::vector<Reason> reasons_;
  std::vector<Clause> clauses_;        ///< of the reason
  std::vector<std::uint8_t> certain_;  ///< whether no guess is behind it
  std::vector<std::uint64_t> ages_;    ///< when it was assigned
  std::vector<std::uint64_t> wanted_;  ///< the question that last assumed it, twice, plus 1 where negatively
  std::vector<std::uint64_t> traced_;  ///< the last trace that met it
  std::vector<std::uint64_t> blamed_;  ///< the question whose refutation named it, as `wanted_`
  // Work to be done, and what is assumed.
  std::vector<Literal> assumed_;
  std::vector<Clause> units_;
  std::vector<std::uint8_t> in_units_;  ///< per clause
  std::vector<Clause> violated_;
  std::vector<Variable> unassigned_;
  std::vector<std::uint8_t> in_unassigned_;  ///< per variable
  std::vector<Variable> stack_;
  std::vector<Variable> released_;
  std::vector<Variable> support_;
  std::uint64_t now_ = 0;
  std::uint64_t question_ = 0;
  std::uint64_t trace_ = 0;
  std::size_t patience_ = 0;  ///< guesses that may still be taken back
  bool refuted_ = false;      ///< the clauses alone have no model
};

}  // namespace rmpl::automata
