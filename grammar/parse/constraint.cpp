// Constraints and assignments (language.md "Constraints").
// SPDX-License-Identifier: MIT
#include "grammar/parse/rules.hpp"

namespace rmpl::grammar {
namespace {

/// Operands of one connective, side by side: one operand alone is itself, several are one `Node`.
template <class Node, class Operand, class Sign>
struct Chain : x3::parser<Chain<Node, Operand, Sign>> {
  using attribute_type = Constraint;
  static constexpr bool has_attribute = true;
  Operand operand;
  Sign sign;
  constexpr Chain(Operand o, Sign s) : operand(o), sign(s) {}
  [[nodiscard]] std::string describe() const { return "a constraint"; }

  template <class C, class R>
  bool parse(Iterator& first, const Iterator& last, const C& context, R& unused, Constraint& all) const {
    if (!operand.parse(first, last, context, unused, all)) return false;
    if (!sign.scan(first, state_of(context))) return true;
    Node node;
    node.operands.push_back(std::move(all));
    do {
      Constraint next;
      x3::expect[operand].parse(first, last, context, unused, next);
      node.operands.push_back(std::move(next));
    } while (sign.scan(first, state_of(context)));
    all.span = join(node.operands.front().span, node.operands.back().span);
    all.node = std::move(node);
    return true;
  }
};

/// `c <-> d <-> e`: to the left, two at a time, and so deeper with each.
template <class Operand>
struct EquivalenceChain : x3::parser<EquivalenceChain<Operand>> {
  using attribute_type = Constraint;
  static constexpr bool has_attribute = true;
  Operand operand;
  constexpr explicit EquivalenceChain(Operand o) : operand(o) {}
  [[nodiscard]] std::string describe() const { return "a constraint"; }

  template <class C, class R>
  bool parse(Iterator& first, const Iterator& last, const C& context, R& unused, Constraint& all) const {
    if (!operand.parse(first, last, context, unused, all)) return false;
    for (std::size_t levels = 1; iff_sign.scan(first, state_of(context)); ++levels) {
      state_of(context).check_depth(first, levels);
      Equivalence node;
      node.operands.resize(2);
      node.operands[0] = std::move(all);
      x3::expect[operand].parse(first, last, context, unused, node.operands[1]);
      all.span = join(node.operands[0].span, node.operands[1].span);
      all.node = std::move(node);
    }
    return true;
  }
};

/// A constraint between parentheses: its place grows by them.
template <class Subject>
struct Parenthesised : x3::parser<Parenthesised<Subject>> {
  using attribute_type = Constraint;
  static constexpr bool has_attribute = true;
  Subject subject;
  constexpr explicit Parenthesised(Subject s) : subject(s) {}

  template <class C, class R>
  bool parse(Iterator& first, const Iterator& last, const C& context, R& unused, Constraint& all) const {
    const Iterator start = skip_blank(first, last);
    if (!open_paren.scan(first, state_of(context))) return false;
    x3::expect[subject].parse(first, last, context, unused, all);
    x3::expect[close_paren].parse(first, last, context, unused, x3::unused);
    all.span = state_of(context).span(start, first);
    return true;
  }
};

const Rule<struct TruthId, Truth> truth{"`true` or `false`"};
const Rule<struct ComparisonId, Comparison> comparison{"a comparison"};
const Rule<struct MembershipId, Membership> membership{"a comparison"};
const Rule<struct ClockBoundId, ClockBound> clock_bound{"a comparison"};
const Rule<struct KnowledgeId, KnowledgeAtom> knowledge{"what is known"};
const Rule<struct ReferenceId, Reference> reference{"a name"};
const Rule<struct NegationId, Negation> negation{"a negation"};
const Rule<struct NegatedId, Constraint> negated{"a negation"};
const Rule<struct AtomId, Constraint> atom{"a constraint"};
const Rule<struct UnaryId, Constraint> unary{"a constraint"};
const Rule<struct ImplicationId, Constraint> implication{"a constraint"};

const auto truth_def = record[set<&Truth::value, true>[Keyword("true")] | set<&Truth::value, false>[Keyword("false")]];

const auto comparison_def = record[field<&Comparison::left>[name] >>
                                   (set<&Comparison::equal, true>[equals] | set<&Comparison::equal, false>[differs]) >
                                   field<&Comparison::right>[value]];

// `x in [30, 60]` after a guard is a time bound: only a brace makes it a membership.
const auto membership_def =
    record[field<&Membership::variable>[name] >> Keyword("in") >> open_brace > append<&Membership::values>[value] >
           *(comma > append<&Membership::values>[value]) > named("`,` or `}`", close_brace)];

const auto clock_bound_def =
    record[field<&ClockBound::clock>[name] >> (set<&ClockBound::relation, ClockRelation::at_most>[at_most] |
                                               set<&ClockBound::relation, ClockRelation::at_least>[at_least] |
                                               set<&ClockBound::relation, ClockRelation::less>[less] |
                                               set<&ClockBound::relation, ClockRelation::greater>[greater]) >
           field<&ClockBound::bound>[duration]];

// `surprise` and `noplan` stand alone or have a component; before a relation they are names, as any keyword is.
constexpr auto knows = &KnowledgeAtom::kind;
using Knows = KnowledgeAtom::Kind;
const auto about_component = open_paren > field<&KnowledgeAtom::component>[name] > close_paren;
const auto about_formula = append<&KnowledgeAtom::operands>[nested[constraint]];
const auto with_probability = comma > field<&KnowledgeAtom::probability>[signed_number];
const auto knowledge_def = record[(set<knows, Knows::possible>[Keyword("possible") >> open_paren] > about_formula >>
                                   -with_probability > named("`,` and a probability, or `)`", close_paren)) |
                                  (set<knows, Knows::likely>[Keyword("likely") >> open_paren] > about_formula >
                                   named("`,` and a probability", with_probability) > close_paren) |
                                  ((set<knows, Knows::surprise>[Keyword("surprise") >> !relation] |
                                    set<knows, Knows::no_plan>[Keyword("noplan") >> !relation]) >>
                                   -about_component)];

/// Never there: what a name in the place of a constraint lacks, clocks where the language has them.
struct RelationMissing : x3::parser<RelationMissing> {
  using attribute_type = x3::unused_type;
  [[maybe_unused]] static constexpr bool has_attribute = false;

  template <class C, class R, class Attribute>
  bool parse(Iterator& first, const Iterator&, const C& context, R&, Attribute&) const {
    throw x3::expectation_failure<Iterator>(
        first, state_of(context).has_clocks() ? "`=`, `!=`, `in` or a comparison of a clock" : "`=`, `!=` or `in`");
  }
};
constexpr RelationMissing relation_missing;

// A bare name is a parameter. Where another name or number follows it, an operator is missing.
const auto reference_def = record[field<&Reference::name>[name] >> !(value | number)];

const auto atom_def =
    record[field<&Constraint::node>[truth] | field<&Constraint::node>[knowledge] |
           field<&Constraint::node>[comparison] | field<&Constraint::node>[membership] |
           field<&Constraint::node>[clock_bound] | field<&Constraint::node>[reference] | (name > relation_missing)];

const auto negation_def = record[not_sign > append<&Negation::operands>[nested[unary]]];

const auto negated_def = record[field<&Constraint::node>[negation]];
const auto unary_def = negated | Parenthesised(nested[constraint]) | atom;

const Chain<Conjunction, decltype(unary), Symbol> conjunction(unary, and_sign);
const Chain<Disjunction, decltype(conjunction), Symbol> disjunction(conjunction, or_sign);

/// `c -> d -> e`: to the right.
struct ImplicationChain : x3::parser<ImplicationChain> {
  using attribute_type = Constraint;
  [[maybe_unused]] static constexpr bool has_attribute = true;
  [[nodiscard]] std::string describe() const { return "a constraint"; }

  template <class C, class R>
  bool parse(Iterator& first, const Iterator& last, const C& context, R& unused, Constraint& all) const {
    if (!disjunction.parse(first, last, context, unused, all)) return false;
    if (!arrow.scan(first, state_of(context))) return true;
    Implication node;
    node.operands.resize(2);
    node.operands[0] = std::move(all);
    x3::expect[nested[implication]].parse(first, last, context, unused, node.operands[1]);
    all.span = join(node.operands[0].span, node.operands[1].span);
    all.node = std::move(node);
    return true;
  }
};

constexpr ImplicationChain implication_def;
const auto constraint_def = EquivalenceChain<decltype(implication)>(implication);

const auto assignment_def =
    record[field<&AssignmentText::variable>[name] > equals > field<&AssignmentText::value>[value]];

const auto more_assignments = *((comma | and_sign) > append<&AssignmentListText::assignments>[assignment]) >
                              named("`,` or `&`", end_of_text);
const auto assignment_list_def =
    record[end_of_text | (x3::expect[append<&AssignmentListText::assignments>[assignment]] > more_assignments)];

BOOST_SPIRIT_DEFINE(truth, comparison, membership, clock_bound, knowledge, reference, negation, negated, atom, unary)
BOOST_SPIRIT_DEFINE(implication)

}  // namespace

BOOST_SPIRIT_DEFINE(constraint, assignment, assignment_list)
BOOST_SPIRIT_INSTANTIATE(decltype(constraint), Iterator, Context)
BOOST_SPIRIT_INSTANTIATE(decltype(assignment), Iterator, Context)
BOOST_SPIRIT_INSTANTIATE(decltype(assignment_list), Iterator, Context)

}  // namespace rmpl::grammar
