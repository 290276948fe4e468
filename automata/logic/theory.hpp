// What follows from what: a constraint store over finite domains, asked by assumptions.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/logic/sat.hpp"
#include "automata/logic/truth_maintenance.hpp"
#include "automata/logic/variables.hpp"

namespace rmpl::automata {

/// The constraint store of thesis 6.1: permanent constraints (the interconnections Q, and each mode's constraint under
/// its mode), and questions under assumptions. One incremental solver lives behind it; formulas are encoded once.
/// Every question is asked of: the permanent constraints, each variable having exactly one value, and the assumptions.
class Theory {
 public:
  /// A formula that this theory has encoded. Cheap to copy; valid for this theory only.
  struct Handle {
    Literal literal;
  };

  /// How questions are answered. Maintained: what follows from the assumptions is kept from one question to the next,
  /// and the solver is asked only where that leaves open; for many questions that differ in a few assumptions.
  /// Searched: by the solver always; for single hard questions.
  enum class Upkeep { searched, maintained };

  explicit Theory(const Variables& variables, Upkeep upkeep = Upkeep::searched);

  /// Adds a permanent constraint. No clock atoms.
  void tell(const Formula& formula);
  /// Adds `condition -> formula` as a permanent constraint.
  void tell_if(Assignment condition, const Formula& formula);
  /// Encodes a formula (equivalence with a fresh literal), once: asked again it is the same handle, so that a theory
  /// grows with the number of different formulas that it is asked, whatever the number of questions. No clock atoms.
  Handle encode(const Formula& formula);

  /// Its negation.
  [[nodiscard]] static Handle negated(Handle formula) { return {-formula.literal}; }

  /// Whether store and assumptions can hold together. On false, `conflict()` names the assumptions to blame.
  bool consistent(std::span<const Assignment> assumptions);
  /// Whether store, assumptions and the formula can hold together.
  bool allows(std::span<const Assignment> assumptions, Handle formula);
  /// Whether store and assumptions can hold together with another value of the variable.
  bool allows_other(std::span<const Assignment> assumptions, Assignment assignment);
  /// The same, where `consistent` of these assumptions was the last question and was answered by yes: the model that it
  /// found, or what is known to follow, most often tells, and no question is asked.
  bool leaves_open(std::span<const Assignment> assumptions, Assignment assignment);
  /// Has the next model differ from this where nothing decides it, as far as that comes of itself: no answer depends on
  /// it.
  void avoid(Assignment assignment) {
    if (maintenance_) maintenance_->prefer(-literal(assignment));
  }
  /// Whether store and assumptions imply the formula; an inconsistent store implies everything.
  bool entails(std::span<const Assignment> assumptions, Handle formula);

  /// After `consistent` or `allows` returned false: assumptions that contradict the store by themselves (a conflict in
  /// the sense of livingstone), in the order in which they were given; after `entails` returned true, or
  /// one of the two above false: assumptions that are enough for that. Not always minimal.
  [[nodiscard]] const std::vector<Assignment>& conflict() const { return conflict_; }
  /// Assumptions that contradict the store by themselves, none of which can be spared: from some that do, with the
  /// formula or without. A question for each.
  std::vector<Assignment> minimal_conflict(std::vector<Assignment> conflict, Handle formula);
  std::vector<Assignment> minimal_conflict(std::vector<Assignment> conflict);
  /// After `consistent` or `allows` returned true: the value of a variable in the model found.
  [[nodiscard]] ValueId value(VariableId variable) const;
  /// Then also: the truth of an encoded formula in that model, and whether it is known already to be implied by the
  /// store and the assumptions (a sufficient condition that costs nothing; searched theories never know).
  [[nodiscard]] bool holds(Handle formula) const { return value(formula.literal); }
  [[nodiscard]] bool holds(Assignment assignment) const { return value(literal(assignment)); }
  [[nodiscard]] bool known_to_follow(Handle formula) const {
    return maintenance_ && maintenance_->follows(formula.literal);
  }
  [[nodiscard]] bool known_to_fail(Handle formula) const { return known_to_follow(negated(formula)); }
  [[nodiscard]] bool known_to_follow(Assignment assignment) const {
    return maintenance_ && maintenance_->follows(literal(assignment));
  }
  /// How often the solver was asked, and how many questions there were.
  [[nodiscard]] std::size_t solver_calls() const { return sat_ ? sat_->calls() : 0; }
  [[nodiscard]] std::size_t questions() const { return questions_; }

 private:
  Literal fresh();
  void add(std::span<const Literal> clause);
  void add(std::initializer_list<Literal> clause) { add(std::span<const Literal>(clause.begin(), clause.size())); }
  bool solve(std::span<const Assignment> assumptions, Literal extra);
  template <class Reasoner>
  void blame(std::span<const Assignment> assumptions, const Reasoner& reasoner);
  /// Whether propagation has derived the literal from the assumptions asked last; if so, those to blame are known.
  bool derived(std::span<const Assignment> assumptions, Literal conclusion);
  [[nodiscard]] bool value(Literal literal) const {
    return maintenance_ ? maintenance_->value(literal) : sat_->value(literal);
  }
  Literal literal(Assignment assignment) const;
  Handle encode_anew(const Formula& formula);
  Literal encode_gate(const Formula& formula, bool conjunctive);

  /// The solver, told of all there is. A maintained theory may never need one, and makes it only then.
  Sat& sat();

  std::optional<Sat> sat_;
  std::vector<Literal> untold_;  ///< clauses that the solver was not told yet, each ended by 0
  Literal last_ = 0;             ///< the variable that was made last
  std::optional<TruthMaintenance> maintenance_;
  std::size_t questions_ = 0;
  std::vector<std::vector<Literal>> literals_;  ///< per variable, per value
  Literal true_;
  std::unordered_map<std::size_t, std::vector<std::pair<Formula, Handle>>> encoded_;  ///< by hash; never iterated
  std::vector<Literal> assumed_;
  std::vector<Assignment> conflict_;
};

}  // namespace rmpl::automata
