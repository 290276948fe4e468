// Properties of a plant and of a program that controls it, at once.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/check_all.hpp"

#include <algorithm>
#include <tuple>

#include "verifier/closed_loop/check.hpp"
#include "verifier/plant/check_all.hpp"

namespace rmpl::verifier {

namespace {

/// Whether two questions about a program leave the same things free.
bool alike(const Question& a, const Question& b) {
  const auto key = [](const Question& q) {
    return std::tie(q.options.period, q.options.faults, q.options.entailed, q.options.fewest_faults, q.options.cut_sets,
                    q.options.from);
  };
  return key(a) == key(b);
}

/// Those at some positions.
template <class Element>
std::vector<Element> at(const std::vector<Element>& all, const std::vector<std::size_t>& positions) {
  std::vector<Element> result;
  for (const std::size_t p : positions) result.push_back(all[p]);
  return result;
}

}  // namespace

std::vector<Answer> check_all(const Subject& subject, Slices& slices, const std::vector<Question>& questions,
                              const Limits& limits) {
  std::vector<Answer> answers(questions.size());
  const auto settle = [&](const std::vector<std::size_t>& group, std::vector<Answer> found) {
    for (std::size_t i = 0; i < group.size(); ++i) answers[group[i]] = std::move(found[i]);
  };
  std::vector<std::size_t> of_plant, of_program;
  for (std::size_t q = 0; q < questions.size(); ++q) {
    (std::holds_alternative<ProgramProperty>(questions[q].property) ? of_program : of_plant).push_back(q);
  }
  settle(of_plant, check_all(slices, at(questions, of_plant), limits));
  Progress spent;
  for (const std::size_t q : of_plant) {
    spent.seconds += answers[q].progress.seconds;
    spent.states += answers[q].progress.states;
  }
  while (!of_program.empty()) {
    const Question& first = questions[of_program.front()];
    const auto others = std::stable_partition(of_program.begin(), of_program.end(),
                                              [&](std::size_t q) { return alike(questions[q], first); });
    const std::vector<std::size_t> group(of_program.begin(), others);
    of_program.erase(of_program.begin(), others);
    std::vector<Property> asked;
    for (const std::size_t q : group) asked.push_back(questions[q].property);
    const Limits left = remaining(limits, spent);
    std::vector<Answer> found = check(*subject.program, slices.whole(), asked, first.options, left);
    spent.seconds += found.back().progress.seconds;
    spent.states += found.back().progress.states;
    // Each stands for itself: a trace that two have in common is told by both.
    for (Answer& answer : found) answer.same_as.reset();
    settle(group, std::move(found));
  }
  return answers;
}

}  // namespace rmpl::verifier
