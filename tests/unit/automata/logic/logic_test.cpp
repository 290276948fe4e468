// Formulas and the constraint store.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>

#include "automata/logic/formula.hpp"
#include "automata/logic/theory.hpp"

namespace rmpl::automata {
namespace {

class Logic : public testing::Test {
 protected:
  Variables variables;
  VariableId x = variables.add({"x", {"a", "b", "c"}});
  VariableId y = variables.add({"y", {"a", "b", "c"}});
  VariableId p = variables.add({"p", {"no", "yes"}});
  static constexpr ValueId v(std::size_t i) { return ValueId(i); }
};

TEST_F(Logic, TextHasNoMoreParenthesesThanNeeded) {
  const std::vector<std::string> clocks{"t1"};
  const auto text = [&](const Formula& f) { return to_text(f, variables, clocks); };
  EXPECT_EQ(text(is(x, v(1))), "x = b");
  EXPECT_EQ(text(member(x, {v(0), v(2)})), "x != b");
  EXPECT_EQ(text(member(x, {})), "x in {}");
  EXPECT_EQ(text(equality(x, y)), "x = y");
  EXPECT_EQ(text(negation(conjunction({is(x, v(0)), is(p, v(1))}))), "!(x = a & p = yes)");
  EXPECT_EQ(text(disjunction({conjunction({is(x, v(0)), is(p, v(1))}), is(y, v(2))})), "x = a & p = yes | y = c");
  EXPECT_EQ(text(implication(implication(is(p, v(0)), is(p, v(1))), is(x, v(0)))), "(p = no -> p = yes) -> x = a");
  EXPECT_EQ(text(clock_bound(ClockId(0), Comparison::at_least, Ticks::of_seconds(16200))), "t1 >= 16200 s");
}

TEST_F(Logic, ClockAtomsOfInactiveClocksAreFalse) {
  const Formula late = clock_bound(ClockId(0), Comparison::less, Ticks::of_seconds(5));
  const Formula either = disjunction({late, is(x, v(0))});
  EXPECT_EQ(with_clocks(either, [](ClockId) { return nullptr; }), is(x, v(0)));
  const Ticks now = Ticks::of_seconds(4);
  EXPECT_TRUE(with_clocks(either, [&](ClockId) { return &now; }).is_true());
  EXPECT_TRUE(with_clocks(negation(late), [](ClockId) { return nullptr; }).is_true());
}

/// Domains of any size, in pairs and in squares: exactly one value holds, and each can.
TEST_F(Logic, OneOfManyValuesHolds) {
  for (const std::size_t size : std::array<std::size_t, 7>{3, 32, 33, 34, 100, 1025, 1100}) {
    std::vector<std::string> values;
    for (std::size_t i = 0; i < size; ++i) values.push_back("v" + std::to_string(i));
    Variables many;
    const VariableId z = many.add({"z", values});
    Theory theory(many);
    for (std::size_t i = 0; i < size; i += 7) {
      const std::array one{Assignment{z, v(i)}};
      EXPECT_TRUE(theory.consistent(one));
      EXPECT_EQ(theory.value(z), v(i));
      EXPECT_FALSE(theory.allows_other(one, {z, v(i)}));
      for (const std::size_t j : {std::size_t{0}, i / 2, (i + 1) % size, size - 1}) {
        if (j == i) continue;
        const std::array both{Assignment{z, v(i)}, Assignment{z, v(j)}};
        EXPECT_FALSE(theory.consistent(both)) << size << ": " << i << " and " << j;
        EXPECT_EQ(theory.conflict().size(), 2u);
      }
    }
    std::vector<ValueId> others;
    for (std::size_t i = 1; i < size; ++i) others.push_back(v(i));
    EXPECT_TRUE(theory.entails(std::array{Assignment{z, v(size - 1)}}, theory.encode(member(z, others))));
    theory.tell(negation(member(z, others)));
    EXPECT_TRUE(theory.entails({}, theory.encode(is(z, v(0)))));
  }
}

TEST_F(Logic, StoreEntailsWhatEveryModelHas) {
  Theory theory(variables);
  theory.tell(implication(is(p, v(1)), equality(x, y)));
  theory.tell_if({p, v(0)}, is(x, v(2)));
  const std::array yes{Assignment{p, v(1)}, Assignment{x, v(0)}};
  EXPECT_FALSE(theory.allows_other(yes, {y, v(0)}));
  EXPECT_TRUE(theory.allows_other(std::array{Assignment{p, v(1)}}, {y, v(0)}));
  EXPECT_TRUE(theory.entails(std::array{Assignment{p, v(0)}}, theory.encode(negation(is(x, v(0))))));
  // Non-entailment is not entailment of the negation.
  const auto question = theory.encode(is(y, v(1)));
  const auto opposite = theory.encode(negation(is(y, v(1))));
  EXPECT_FALSE(theory.entails({}, question));
  EXPECT_FALSE(theory.entails({}, opposite));
}

TEST_F(Logic, ConflictNamesAssumptionsThatContradictTheStore) {
  Theory theory(variables);
  theory.tell(implication(is(p, v(1)), is(x, v(0))));
  const std::array assumptions{Assignment{y, v(1)}, Assignment{p, v(1)}, Assignment{x, v(2)}};
  ASSERT_FALSE(theory.consistent(assumptions));
  EXPECT_EQ(theory.conflict(), (std::vector<Assignment>{{p, v(1)}, {x, v(2)}}));
  EXPECT_TRUE(theory.consistent(std::array{Assignment{y, v(1)}}));
  EXPECT_EQ(theory.value(y), v(1));
}

TEST_F(Logic, EncodingAgreesWithEvaluationOnEveryAssignment) {
  const std::vector<Formula> formulas{
      equivalence(is(x, v(0)), negation(member(y, {v(1), v(2)}))),
      disjunction({conjunction({is(x, v(1)), is(p, v(0))}), equality(x, y), constant(false)}),
      implication(equality(x, y), conjunction({is(p, v(1)), member(x, {v(0), v(1), v(2)})})),
      negation(equivalence(is(p, v(0)), implication(is(x, v(2)), is(y, v(2)))))};
  for (const Formula& formula : formulas) {
    Theory theory(variables);
    const auto handle = theory.encode(formula);
    for (std::size_t i = 0; i < 18; ++i) {
      const std::array all{Assignment{x, v(i % 3)}, Assignment{y, v(i / 3 % 3)}, Assignment{p, v(i / 9)}};
      const bool truth = evaluate(formula, [&](VariableId id) { return all[id.index()].value; });
      EXPECT_EQ(theory.entails(all, handle), truth) << to_text(formula, variables) << " at " << i;
      EXPECT_EQ(theory.allows(all, handle), truth);
    }
  }
}

}  // namespace
}  // namespace rmpl::automata
