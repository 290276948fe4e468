// Properties by turns: none starves another, and what no search was begun for says so.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/verifier/plants.hpp"
#include "verifier/closed_loop/check_all.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::verifier {
namespace {

CheckOptions sampled() {
  CheckOptions options;
  options.period = automata::Ticks::of_seconds(1);
  return options;
}

TEST(Turns, AreInTheOrderOfTheQuestions) {
  const auto b = test::engine();
  Slices slices(b.plant);
  const Property standby = Reachability{b.is("engine", "standby"), {}, false};
  const Property never_standby = Safety{b.is("engine", "standby"), {}, false};
  const std::vector<Question> questions = {{standby, {}}, {Stuck{}, {}}, {never_standby, sampled()}};
  const std::vector<Answer> all = check_all({b.plant}, slices, questions, {});
  ASSERT_EQ(all.size(), questions.size());
  for (std::size_t q = 0; q < questions.size(); ++q) {
    const Answer alone = check_all({b.plant}, slices, {questions[q]}, {}).front();
    EXPECT_EQ(all[q].verdict, alone.verdict);
    EXPECT_EQ(all[q].progress.states, alone.progress.states);
    EXPECT_FALSE(all[q].limit);
  }
}

TEST(Turns, WithoutTimeNothingIsBegun) {
  const auto b = test::engine();
  Slices slices(b.plant);
  Limits limits;
  limits.time.emplace(0);
  const Property standby = Reachability{b.is("engine", "standby"), {}, false};
  for (const Answer& answer : check_all({b.plant}, slices, {{standby, {}}, {Stuck{}, {}}}, limits)) {
    EXPECT_EQ(answer.verdict, Verdict::undecided);
    EXPECT_EQ(reason(answer), "not begun: the limit of time (--timeout) was reached before");
  }
}

TEST(Turns, StatesAreForEachSearch) {
  const auto b = test::engine();
  Slices slices(b.plant);
  const Property standby = Reachability{b.is("engine", "standby"), {}, false};
  const std::vector<Question> questions = {{standby, {}}, {standby, sampled()}};
  const std::vector<Answer> unlimited = check_all({b.plant}, slices, questions, {});
  Limits limits;
  limits.states = std::max(unlimited[0].progress.states, unlimited[1].progress.states) + 1;
  for (const Answer& answer : check_all({b.plant}, slices, questions, limits))
    EXPECT_EQ(answer.verdict, Verdict::holds);
}

}  // namespace
}  // namespace rmpl::verifier
