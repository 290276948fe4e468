// Truth maintenance: counters per clause, reasons per variable.
//
// Invariant between operations: `not_false_` counts under the present values, and a clause with one literal left that
// is not yet true is in `units_`, one with none in `violated_`. Counters, unlike watched literals, stay right when
// values are taken back in any order.
// SPDX-License-Identifier: MIT
#include "automata/logic/truth_maintenance.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::automata {
namespace {

/// Guesses taken back in vain before a solver is asked; each new assumption grants one more.
constexpr std::size_t least_patience = 32;

}  // namespace

std::vector<TruthMaintenance::Clause>& TruthMaintenance::occurrences(Literal literal) {
  return occurrences_[2 * variable(literal) + (literal < 0 ? 1 : 0)];
}

std::span<const Literal> TruthMaintenance::literals(Clause clause) const {
  return std::span(literals_).subspan(begin_[clause], begin_[clause + 1] - begin_[clause]);
}

void TruthMaintenance::reserve(Variable last) {
  if (begin_.empty()) begin_.push_back(0);
  const std::size_t size = std::size_t{last} + 1;
  if (values_.size() >= size) return;
  for (std::size_t v = std::max<std::size_t>(values_.size(), 1); v < size; ++v) {
    unassigned_.push_back(static_cast<Variable>(v));
  }
  in_unassigned_.resize(size, 1);
  occurrences_.resize(2 * size);
  values_.resize(size, 0);
  phases_.resize(size, -1);
  reasons_.resize(size, Reason::none);
  clauses_.resize(size, 0);
  certain_.resize(size, 0);
  ages_.resize(size, 0);
  wanted_.resize(size, 0);
  traced_.resize(size, 0);
  blamed_.resize(size, 0);
}

void TruthMaintenance::add(std::span<const Literal> clause) {
  // A literal that stands twice would hide that it is the last one.
  std::vector<Literal> once(clause.begin(), clause.end());
  std::sort(once.begin(), once.end());
  once.erase(std::unique(once.begin(), once.end()), once.end());
  Variable last = 0;
  for (const Literal literal : once) last = std::max(last, variable(literal));
  reserve(last);
  const auto id = static_cast<Clause>(not_false_.size());
  std::uint32_t left = 0;
  for (const Literal literal : once) {
    literals_.push_back(literal);
    occurrences(literal).push_back(id);
    if (!is_false(literal)) ++left;
  }
  begin_.push_back(static_cast<std::uint32_t>(literals_.size()));
  not_false_.push_back(left);
  implied_.push_back(0);
  in_units_.push_back(0);
  if (left == 0) violated_.push_back(id);
  if (left == 1) note_unit(id);
}

void TruthMaintenance::assign(Literal literal, Reason reason, Clause clause, bool certain) {
  const Variable v = variable(literal);
  values_[v] = phases_[v] = sign(literal);
  reasons_[v] = reason;
  clauses_[v] = clause;
  certain_[v] = certain ? 1 : 0;
  ages_[v] = ++now_;
  if (reason == Reason::clause) implied_[clause] = v;
  for (const Clause c : occurrences(-literal)) {
    const std::uint32_t left = --not_false_[c];
    if (left == 1) note_unit(c);
    if (left == 0) violated_.push_back(c);
  }
}

/// Takes back the value of a variable and all that rests on it. What may still follow otherwise is put to work.
void TruthMaintenance::retract(Variable start) {
  stack_.assign(1, start);
  released_.clear();
  while (!stack_.empty()) {
    const Variable v = stack_.back();
    stack_.pop_back();
    if (values_[v] == 0) continue;
    const Literal literal = values_[v] * static_cast<Literal>(v);
    if (reasons_[v] == Reason::clause) implied_[clauses_[v]] = 0;
    values_[v] = 0;
    reasons_[v] = Reason::none;
    released_.push_back(v);
    for (const Clause c : occurrences(-literal)) {
      ++not_false_[c];
      if (implied_[c] != 0) stack_.push_back(implied_[c]);
    }
  }
  for (const Variable v : released_) {
    if (in_unassigned_[v] == 0) unassigned_.push_back(v);
    in_unassigned_[v] = 1;
    const auto literal = static_cast<Literal>(v);
    for (const Literal side : {literal, -literal}) {
      for (const Clause c : occurrences(side)) {
        if (not_false_[c] == 1) note_unit(c);
      }
    }
  }
}

void TruthMaintenance::note_unit(Clause clause) {
  if (in_units_[clause] == 0) units_.push_back(clause);
  in_units_[clause] = 1;
}

void TruthMaintenance::propagate() {
  // In order of arrival, so that what rests on few steps is derived by few steps.
  for (std::size_t next = 0; next < units_.size(); ++next) {
    if (!violated_.empty()) {
      units_.erase(units_.begin(), units_.begin() + static_cast<std::ptrdiff_t>(next));
      return;
    }
    const Clause c = units_[next];
    in_units_[c] = 0;
    if (not_false_[c] != 1) continue;
    Literal left = 0;
    bool certain = true;
    for (const Literal literal : literals(c)) {
      if (is_false(literal)) {
        certain = certain && certain_[variable(literal)] != 0;
      } else {
        left = literal;
      }
    }
    if (!is_true(left)) assign(left, Reason::clause, c, certain);
  }
  units_.clear();
}

TruthMaintenance::Variable TruthMaintenance::trace(std::span<const Literal> from) {
  ++trace_;
  support_.clear();
  stack_.clear();
  const auto meet = [&](Variable v) {
    if (traced_[v] == trace_) return;
    traced_[v] = trace_;
    stack_.push_back(v);
  };
  for (const Literal literal : from) meet(variable(literal));
  Variable guess = 0;
  while (!stack_.empty()) {
    const Variable v = stack_.back();
    stack_.pop_back();
    switch (reasons_[v]) {
      case Reason::assumption:
        support_.push_back(v);
        break;
      case Reason::guess:
        if (guess == 0 || ages_[v] > ages_[guess]) guess = v;
        break;
      case Reason::clause:
        for (const Literal literal : literals(clauses_[v])) meet(variable(literal));
        break;
      case Reason::none:
        CHECK(false && "a value has a reason");
    }
  }
  return guess;
}

void TruthMaintenance::take_back(Variable guess) {
  const std::int8_t opposite = static_cast<std::int8_t>(-values_[guess]);
  retract(guess);
  phases_[guess] = opposite;
  --patience_;
}

/// Makes an assumption; consistent means that it is made.
TruthMaintenance::Answer TruthMaintenance::assume(Literal literal) {
  const Variable v = variable(literal);
  while (is_false(literal)) {
    const Literal opposite[] = {-literal};
    const Variable guess = trace(opposite);
    if (guess == 0) {
      for (const Variable blamed : support_) blamed_[blamed] = wanted_[blamed];
      blamed_[v] = wanted_[v];
      return Answer::inconsistent;
    }
    if (patience_ == 0) return Answer::open;
    take_back(guess);
  }
  if (is_true(literal)) {
    if (certain_[v] != 0) return Answer::consistent;
    retract(v);
  }
  assign(literal, Reason::assumption, 0, true);
  assumed_.push_back(literal);
  return Answer::consistent;
}

/// Propagates and guesses until every variable has a value.
TruthMaintenance::Answer TruthMaintenance::complete() {
  while (true) {
    propagate();
    if (!violated_.empty()) {
      const Clause c = violated_.back();
      if (not_false_[c] > 0) {
        violated_.pop_back();
        continue;
      }
      if (const Variable guess = trace(literals(c)); guess != 0) {
        if (patience_ == 0) return Answer::open;
        take_back(guess);
        continue;
      }
      if (support_.empty()) {
        refuted_ = true;
        return Answer::inconsistent;
      }
      Variable last = support_.front();
      for (const Variable blamed : support_) {
        blamed_[blamed] = wanted_[blamed];
        if (ages_[blamed] > ages_[last]) last = blamed;
      }
      retract(last);  // so that no clause is violated from here on
      return Answer::inconsistent;
    }
    if (unassigned_.empty()) return Answer::consistent;
    const Variable v = unassigned_.back();
    unassigned_.pop_back();
    in_unassigned_[v] = 0;
    if (values_[v] == 0) assign(phases_[v] * static_cast<Literal>(v), Reason::guess, 0, false);
  }
}

TruthMaintenance::Answer TruthMaintenance::ask(std::span<const Literal> assumptions) {
  ++question_;
  if (refuted_) return Answer::inconsistent;
  patience_ = least_patience;
  for (const Literal literal : assumptions) {
    const Variable v = variable(literal);
    if (v >= values_.size()) reserve(v);
    const std::uint64_t mark = 2 * question_ + (literal < 0 ? 1 : 0);
    if (wanted_[v] == (mark ^ 1)) {  // both a literal and its negation
      blamed_[v] = mark;
      return Answer::inconsistent;
    }
    wanted_[v] = mark;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < assumed_.size(); ++i) {
    const Literal literal = assumed_[i];
    const Variable v = variable(literal);
    if (reasons_[v] != Reason::assumption || !is_true(literal)) continue;
    if (wanted_[v] == 2 * question_ + (literal < 0 ? 1 : 0)) {
      assumed_[kept++] = literal;
    } else {
      retract(v);
    }
  }
  assumed_.resize(kept);
  std::erase_if(violated_, [this](Clause c) { return not_false_[c] > 0; });
  for (const Literal literal : assumptions) {
    const std::size_t before = assumed_.size();
    if (const Answer answer = assume(literal); answer != Answer::consistent) return answer;
    patience_ += assumed_.size() - before;
  }
  return complete();
}

void TruthMaintenance::adopt(std::span<const Literal> assumptions, const Sat& solver) {
  for (Variable v = 1; v < values_.size(); ++v) {
    if (reasons_[v] == Reason::guess) retract(v);
  }
  for (Variable v = 1; v < values_.size(); ++v) phases_[v] = solver.value(static_cast<Literal>(v)) ? 1 : -1;
  patience_ = 0;
  Answer answer = Answer::consistent;
  for (const Literal literal : assumptions) {
    answer = assume(literal);
    CHECK(answer == Answer::consistent && "a model contradicts no assumption");
  }
  answer = complete();
  CHECK(answer == Answer::consistent && "a model violates no clause");
}

void TruthMaintenance::explain(Literal literal) {
  const Literal from[] = {literal};
  // What an explanation under the same assumptions blamed.
  for (const Variable blamed : support_) blamed_[blamed] = 0;
  [[maybe_unused]] const Variable guess = trace(from);
  CHECK(guess == 0 && "what follows rests on no guess");
  for (const Variable blamed : support_) blamed_[blamed] = wanted_[blamed];
}

bool TruthMaintenance::failed(Literal assumption) const {
  const std::uint64_t blamed = blamed_[variable(assumption)];
  return blamed >> 1 == question_ && !refuted_;
}

}  // namespace rmpl::automata
