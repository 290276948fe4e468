// The constraint store: finite domains in clauses, formulas by Tseitin's encoding.
// SPDX-License-Identifier: MIT
#include "automata/logic/theory.hpp"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "base/check.hpp"
#include "base/hash.hpp"

namespace rmpl::automata {

namespace {

/// Of up to so many literals, a clause for each pair says that at most one holds.
constexpr std::size_t most_in_pairs = 32;

/// Clauses of "at most one of these". More than a few literals stand in a square. Each implies its row and its column,
/// of which at most one holds: 2n clauses and few more in place of n^2 / 2, and what one literal refutes follows in as
/// few steps (J. Chen: A New SAT Encoding of the At-Most-One Constraint, 2010).
template <class Fresh, class Add>
void exclude_each_other(std::vector<Literal> literals, const Fresh& fresh, const Add& add) {
  while (literals.size() > most_in_pairs) {
    std::size_t side = 1;
    while (side * side < literals.size()) ++side;
    std::vector<Literal> rows, columns;
    for (std::size_t row = 0; row * side < literals.size(); ++row) rows.push_back(fresh());
    for (std::size_t column = 0; column < side; ++column) columns.push_back(fresh());
    for (std::size_t v = 0; v < literals.size(); ++v) {
      add({-literals[v], rows[v / side]});
      add({-literals[v], columns[v % side]});
    }
    exclude_each_other(std::move(rows), fresh, add);
    literals = std::move(columns);
  }
  for (std::size_t v = 0; v < literals.size(); ++v) {
    for (std::size_t w = v + 1; w < literals.size(); ++w) add({-literals[v], -literals[w]});
  }
}

}  // namespace

Theory::Theory(const Variables& variables, Upkeep upkeep) {
  if (upkeep == Upkeep::maintained) maintenance_.emplace();
  true_ = fresh();
  add({true_});
  literals_.reserve(variables.size());
  for (const Variable& variable : variables) {
    // Two values need one literal; more get one each, exactly one of which holds. An empty domain has no model.
    std::vector<Literal> values;
    if (variable.values.size() == 1) {
      values = {true_};
    } else if (variable.values.size() == 2) {
      const Literal first = fresh();
      values = {first, -first};
    } else {
      for (std::size_t v = 0; v < variable.values.size(); ++v) values.push_back(fresh());
      add(values);
      exclude_each_other(
          values, [this] { return fresh(); }, [this](std::initializer_list<Literal> clause) { add(clause); });
    }
    literals_.push_back(std::move(values));
  }
}

Literal Theory::literal(Assignment assignment) const {
  return literals_[assignment.variable.index()][assignment.value.index()];
}

namespace {

/// Clauses of `unless or formula`, where the outermost operation needs no literal of its own: most constraints are told
/// for good, and questions propagate through what is left out here again and again.
template <class Add, class Encode>
void require(Literal unless, const Formula& formula, const std::vector<std::vector<Literal>>& literals, const Add& add,
             const Encode& encode) {
  switch (formula.kind) {
    case Formula::Kind::conjunction:
      for (const Formula& operand : formula.operands) require(unless, operand, literals, add, encode);
      return;
    case Formula::Kind::disjunction: {
      std::vector<Literal> clause{unless};
      for (const Formula& operand : formula.operands) clause.push_back(encode(operand));
      add(clause);
      return;
    }
    case Formula::Kind::implication: {
      const Literal premise = encode(formula.operands[0]);
      add({unless, -premise, encode(formula.operands[1])});
      return;
    }
    case Formula::Kind::equivalence: {
      const Literal left = encode(formula.operands[0]);
      const Literal right = encode(formula.operands[1]);
      add({unless, -left, right});
      add({unless, left, -right});
      return;
    }
    case Formula::Kind::equality: {
      const auto& left = literals[formula.variable.index()];
      const auto& right = literals[formula.other.index()];
      CHECK(left.size() == right.size() && "an equality compares variables of one domain");
      for (std::size_t v = 0; v < left.size(); ++v) {
        add({unless, -left[v], right[v]});
        // Of two values the other one says this already.
        if (left.size() > 2) add({unless, left[v], -right[v]});
      }
      return;
    }
    case Formula::Kind::constant:
    case Formula::Kind::member:
    case Formula::Kind::clock:
    case Formula::Kind::knowledge:
    case Formula::Kind::negation:
      add({unless, encode(formula)});
      return;
  }
}

std::size_t hash_of(const Formula& formula) {
  std::uint64_t hash = base::mix(base::hash_seed, static_cast<std::uint64_t>(formula.kind) * 2 + formula.truth);
  hash = base::mix(hash, std::uint64_t{formula.variable.value} << 32 | formula.other.value);
  for (const ValueId value : formula.values) hash = base::mix(hash, value.value);
  for (const Formula& operand : formula.operands) hash = base::mix(hash, hash_of(operand));
  return hash;
}

}  // namespace

void Theory::tell(const Formula& formula) {
  require(
      -true_, formula, literals_, [this](const std::vector<Literal>& clause) { add(clause); },
      [this](const Formula& part) { return encode_anew(part).literal; });
}

void Theory::tell_if(Assignment condition, const Formula& formula) {
  require(
      -literal(condition), formula, literals_, [this](const std::vector<Literal>& clause) { add(clause); },
      [this](const Formula& part) { return encode_anew(part).literal; });
}

Literal Theory::encode_gate(const Formula& formula, bool conjunctive) {
  // A disjunction is the negation of the conjunction of the negations: one gate serves both.
  const int sign = conjunctive ? 1 : -1;
  const Literal gate = fresh();
  std::vector<Literal> closing{gate};
  for (const Formula& operand : formula.operands) {
    const Literal input = sign * encode_anew(operand).literal;
    add({-gate, input});
    closing.push_back(-input);
  }
  add(closing);
  return sign * gate;
}

Theory::Handle Theory::encode(const Formula& formula) {
  auto& known = encoded_[hash_of(formula)];
  for (const auto& [asked, handle] : known) {
    if (asked == formula) return handle;
  }
  const Handle handle = encode_anew(formula);
  known.emplace_back(formula, handle);
  return handle;
}

Theory::Handle Theory::encode_anew(const Formula& formula) {
  switch (formula.kind) {
    case Formula::Kind::constant:
      return {formula.truth ? true_ : -true_};
    case Formula::Kind::member: {
      const auto& values = literals_[formula.variable.index()];
      if (formula.values.empty()) return {-true_};
      if (formula.values.size() == values.size()) return {true_};
      if (formula.values.size() == 1) return {values[formula.values[0].index()]};
      const Literal gate = fresh();
      std::vector<Literal> closing{-gate};
      for (const ValueId v : formula.values) {
        add({-values[v.index()], gate});
        closing.push_back(values[v.index()]);
      }
      add(closing);
      return {gate};
    }
    case Formula::Kind::equality: {
      const auto& left = literals_[formula.variable.index()];
      const auto& right = literals_[formula.other.index()];
      CHECK(left.size() == right.size() && "an equality compares variables of one domain");
      const Literal gate = fresh();
      for (std::size_t v = 0; v < left.size(); ++v) {
        add({-gate, -left[v], right[v]});
        add({gate, -left[v], -right[v]});
      }
      return {gate};
    }
    case Formula::Kind::clock:
    case Formula::Kind::knowledge:
      CHECK(false && "atoms of clocks and knowledge are replaced before encoding");
      return {-true_};
    case Formula::Kind::negation:
      return {-encode_anew(formula.operands[0]).literal};
    case Formula::Kind::conjunction:
      return {encode_gate(formula, true)};
    case Formula::Kind::disjunction:
      return {encode_gate(formula, false)};
    case Formula::Kind::implication: {
      const Literal premise = encode_anew(formula.operands[0]).literal;
      const Literal conclusion = encode_anew(formula.operands[1]).literal;
      const Literal gate = fresh();
      add({-gate, -premise, conclusion});
      add({gate, premise});
      add({gate, -conclusion});
      return {gate};
    }
    case Formula::Kind::equivalence: {
      const Literal left = encode_anew(formula.operands[0]).literal;
      const Literal right = encode_anew(formula.operands[1]).literal;
      const Literal gate = fresh();
      add({-gate, -left, right});
      add({-gate, left, -right});
      add({gate, left, right});
      add({gate, -left, -right});
      return {gate};
    }
  }
  return {true_};
}

Literal Theory::fresh() {
  ++last_;
  if (maintenance_) maintenance_->reserve(static_cast<std::uint32_t>(last_));
  return last_;
}

void Theory::add(std::span<const Literal> clause) {
  untold_.insert(untold_.end(), clause.begin(), clause.end());
  untold_.push_back(0);
  if (maintenance_) maintenance_->add(clause);
}

Sat& Theory::sat() {
  if (!sat_) sat_.emplace();
  for (auto begin = untold_.begin(); begin != untold_.end();) {
    const auto end = std::find(begin, untold_.end(), 0);
    sat_->add(std::span(begin, end));
    begin = end + 1;
  }
  untold_.clear();
  return *sat_;
}

/// Takes from a reasoner, which was asked of `assumed_`, what it blames.
template <class Reasoner>
void Theory::blame(std::span<const Assignment> assumptions, const Reasoner& reasoner) {
  for (std::size_t i = 0; i < assumptions.size(); ++i) {
    if (reasoner.failed(assumed_[i])) conflict_.push_back(assumptions[i]);
  }
}

bool Theory::solve(std::span<const Assignment> assumptions, Literal extra) {
  ++questions_;
  assumed_.clear();
  for (const Assignment& a : assumptions) assumed_.push_back(literal(a));
  assumed_.push_back(extra);
  conflict_.clear();
  if (maintenance_) {
    switch (maintenance_->ask(assumed_)) {
      case TruthMaintenance::Answer::consistent:
        return true;
      case TruthMaintenance::Answer::inconsistent:
        blame(assumptions, *maintenance_);
        return false;
      case TruthMaintenance::Answer::open:
        break;
    }
  }
  Sat& solver = sat();
  if (!solver.solve(assumed_)) {
    blame(assumptions, solver);
    return false;
  }
  if (maintenance_) maintenance_->adopt(assumed_, solver);
  return true;
}

bool Theory::consistent(std::span<const Assignment> assumptions) { return solve(assumptions, true_); }

bool Theory::allows(std::span<const Assignment> assumptions, Handle formula) {
  return solve(assumptions, formula.literal);
}

bool Theory::allows_other(std::span<const Assignment> assumptions, Assignment assignment) {
  return solve(assumptions, -literal(assignment));
}

bool Theory::leaves_open(std::span<const Assignment> assumptions, Assignment assignment) {
  const Literal read = literal(assignment);
  if (!value(read)) return true;
  return !derived(assumptions, read) && allows_other(assumptions, assignment);
}

bool Theory::derived(std::span<const Assignment> assumptions, Literal conclusion) {
  if (!maintenance_ || !maintenance_->follows(conclusion)) return false;
  conflict_.clear();
  maintenance_->explain(conclusion);
  blame(assumptions, *maintenance_);
  return true;
}

std::vector<Assignment> Theory::minimal_conflict(std::vector<Assignment> conflict, Handle formula) {
  for (std::size_t i = 0; i < conflict.size();) {
    std::vector<Assignment> less = conflict;
    less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
    if (allows(less, formula)) {
      ++i;
    } else {
      // What was found to be needed is in every proof from the rest; the new proof often needs less of it yet.
      conflict = conflict_;
    }
  }
  return conflict;
}

std::vector<Assignment> Theory::minimal_conflict(std::vector<Assignment> conflict) {
  return minimal_conflict(std::move(conflict), {true_});
}

bool Theory::entails(std::span<const Assignment> assumptions, Handle formula) {
  const Literal conclusion = formula.literal;
  if (maintenance_) {
    // A model at hand refutes most that is not implied, and propagation derives most that is.
    if (!solve(assumptions, true_)) return true;
    if (!value(conclusion)) return false;
    if (derived(assumptions, conclusion)) return true;
  }
  return !solve(assumptions, -conclusion);
}

ValueId Theory::value(VariableId variable) const {
  const auto& values = literals_[variable.index()];
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (value(values[v])) return ValueId(v);
  }
  CHECK(false && "each variable has a value in a model");
  return {};
}

}  // namespace rmpl::automata
