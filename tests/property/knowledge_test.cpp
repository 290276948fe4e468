// What an executive knows against the whole joint belief, and goals that are asked for by themselves against a table of
// which of them have a plan together.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "automata/dependencies/dependencies.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/insight.hpp"
#include "runtime/reasoning/reconfigure/several_goals.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/models.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::property {
namespace {

using automata::Formula;
using automata::Knowing;

constexpr double hair = 1e-6;

RC_GTEST_PROP(Knowledge, LikelyIsASumOverTheJointBelief, ()) {
  const Model model = *models({.open = chance(50)});
  const Log log = *logs(model.plant, 5);
  automata::PlantStep step(model.plant), joint_step(model.plant);
  const auto estimator = runtime::make_exact_estimator(step, {});
  const auto joint = runtime::make_exact_estimator(joint_step, {.factored = false});
  const reference::Models entailment(model.plant);
  std::vector<Formula> atoms;
  for (int i = 0; i < 4; ++i) {
    const double least = pick<double>({0.001, 0.05, 0.3, 0.5, 0.8, 0.95, 1.0});
    atoms.push_back(automata::knowledge(chance(50) ? Knowing::likely : Knowing::possible,
                                        *formulas(model.plant.variables, all_variables(model.plant), 1), least));
  }
  runtime::Insight insight(model.plant, atoms);
  for (const LogLine& line : log.lines) {
    const bool consistent = estimator->update(line.action, line.observation, line.time).consistent;
    joint->update(line.action, line.observation, line.time);
    if (!consistent || !joint->estimate().consistent) RC_DISCARD("what is set aside may differ");
    for (const Formula& atom : atoms) {
      std::map<automata::Modes, double> shares;
      for (const runtime::BeliefEntry& entry : joint->belief()) shares[entry.state.modes] += entry.probability;
      double entailed = 0, allowed = 0, greatest = 0;
      for (const auto& [modes, share] : shares) {
        std::vector<automata::Assignment> known = reference::assumptions_of(model.plant, modes);
        known.insert(known.end(), line.observation.begin(), line.observation.end());
        if (entailment.entails(known, atom.operands[0])) entailed += share;
        if (!entailment.allows(known, atom.operands[0])) continue;
        allowed += share;
        greatest = std::max(greatest, share);
      }
      const bool answer = insight.answer(atom, *estimator, line.observation);
      RC_LOG() << automata::to_text(atom, model.plant.variables) << ": " << entailed << ", " << allowed << std::endl;
      if (atom.knowing == Knowing::likely) {
        if (std::abs(entailed - atom.probability) > hair) RC_ASSERT(answer == (entailed > atom.probability));
        RC_TAG(answer ? "likely" : "not likely");
      } else {
        // A state of all components is no likelier than its part in the groups that are asked about.
        if (greatest > atom.probability + hair) RC_ASSERT(answer);
        if (allowed < hair) RC_ASSERT(!answer);
        RC_TAG(answer ? "possible" : "not possible");
      }
    }
  }
}

RC_GTEST_PROP(Knowledge, ASurpriseIsOfTheGroupsOfWhatWasSetAside, ()) {
  const Model model = *models({.open = chance(50)});
  const Log log = *logs(model.plant, 5);
  automata::PlantStep step(model.plant);
  const auto estimator = runtime::make_exact_estimator(step, {});
  const automata::Classes groups = automata::Dependencies(model.plant).groups();
  runtime::Insight insight(model.plant, {});
  Formula surprise = automata::knowledge(Knowing::surprise);
  for (const LogLine& line : log.lines) {
    const runtime::Estimate& estimate = estimator->update(line.action, line.observation, line.time);
    RC_ASSERT(insight.answer(surprise, *estimator, line.observation) == !estimate.consistent);
    for (const automata::Component& component : model.plant.components) {
      const bool expected = std::any_of(
          estimate.set_aside.begin(), estimate.set_aside.end(),
          [&](const automata::Assignment& reading) { return groups[reading.variable] == groups[component.mode]; });
      const Formula of_one = automata::knowledge(Knowing::surprise, component.mode);
      const bool found = insight.answer(of_one, *estimator, line.observation);
      RC_ASSERT(found || !expected);
      // Groups that a command joins are surprised together.
      RC_ASSERT(!found || !estimate.set_aside.empty());
      RC_TAG(expected ? "a surprise" : "none");
    }
  }
}

/// Has a plan for the sets of goals that a table says.
class Table final : public runtime::Reconfigurer {
 public:
  explicit Table(std::set<std::set<automata::Assignment>> planned) : planned_(std::move(planned)) {}
  runtime::Reconfiguration next(const automata::Modes&, const Formula& goal) override {
    std::set<automata::Assignment> asked;
    for (const Formula& conjunct : conjuncts_of(goal)) {
      if (!conjunct.is_true()) asked.insert({conjunct.variable, conjunct.values.front()});
    }
    runtime::Reconfiguration answer;
    answer.outcome = asked.empty() || planned_.contains(asked) ? runtime::Reconfiguration::Outcome::command
                                                               : runtime::Reconfiguration::Outcome::no_plan;
    answer.checked = 1;
    return answer;
  }

 private:
  std::set<std::set<automata::Assignment>> planned_;
};

RC_GTEST_PROP(Knowledge, GoalsAreLeftOutInTheOrderOfTheProgram, ()) {
  const std::size_t count = up_to(1, 4);
  std::vector<automata::Goals> goals;
  for (std::size_t g = 0; g < count; ++g) {
    goals.push_back({{{automata::VariableId(g), automata::ValueId(std::size_t{0})}}, {automata::LocationId(g)}, {}});
  }
  std::set<std::set<automata::Assignment>> planned;
  for (std::size_t set = 1; set < std::size_t{1} << count; ++set) {
    if (!chance(60)) continue;
    std::set<automata::Assignment> asked;
    for (std::size_t g = 0; g < count; ++g)
      if ((set >> g & 1) != 0) asked.insert(goals[g].goal.front());
    planned.insert(asked);
  }
  Table table(planned);
  const automata::Modes modes;
  const runtime::Pursued found = runtime::pursue(table, {&modes, 1}, goals);

  std::set<automata::Assignment> all, pursued;
  for (const automata::Goals& goal : goals) all.insert(goal.goal.front());
  std::vector<std::size_t> left_out;
  if (planned.contains(all)) {
    pursued = all;
  } else {
    for (std::size_t g = 0; g < count; ++g) {
      std::set<automata::Assignment> tried = pursued;
      tried.insert(goals[g].goal.front());
      if (planned.contains(tried)) {
        pursued = tried;
      } else {
        left_out.push_back(g);
      }
    }
  }
  const bool none = pursued.empty();
  if (none) {
    pursued.insert(goals.front().goal.front());
    left_out.erase(left_out.begin());
  }
  RC_ASSERT((found.answer.outcome == runtime::Reconfiguration::Outcome::no_plan) == none);
  RC_ASSERT(std::set<automata::Assignment>(found.goals.goal.begin(), found.goals.goal.end()) == pursued);
  RC_ASSERT(found.left_out.size() == left_out.size());
  for (std::size_t i = 0; i < left_out.size(); ++i) RC_ASSERT(found.left_out[i].goals == goals[left_out[i]]);
  RC_ASSERT(found.answer.checked <= 2 * count + 1);
  RC_TAG(none ? "none" : left_out.empty() ? "all" : "some");
}

}  // namespace
}  // namespace rmpl::property
