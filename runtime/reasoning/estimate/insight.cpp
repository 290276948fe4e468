// Sums of probabilities over the states that entail a formula, or allow it.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/insight.hpp"

#include <algorithm>
#include <set>

#include "automata/dependencies/dependencies.hpp"
#include "automata/store/model.hpp"
#include "base/check.hpp"

namespace rmpl::runtime {

using automata::Formula;
using automata::Knowing;

namespace {

/// A sum of probabilities that reaches the one asked for but for rounding does.
constexpr double rounding = 1e-9;

}  // namespace

std::optional<automata::ComponentId> about(const automata::Plant& plant, const Formula& atom) {
  return atom.about_one ? plant.component_of(atom.variable) : std::nullopt;
}

Insight::Insight(const automata::Plant& plant, const std::vector<Formula>& atoms) : plant_(plant) {
  std::optional<automata::Classes> groups;
  for (const Formula& atom : atoms) {
    if (atom.operands.empty()) continue;
    if (!groups) groups = automata::Dependencies(plant).groups();
    if (!theory_) theory_.emplace(automata::model_theory(plant));
    Question& made =
        questions_.emplace_back(Question{atom.operands.front(), theory_->encode(atom.operands.front()), {}});
    std::set<std::size_t> spoken_of;
    for (const automata::VariableId variable : variables_of(made.formula)) {
      if (const auto group = (*groups)[variable]) spoken_of.insert(*group);
    }
    for (std::size_t c = 0; c < plant.components.size(); ++c) {
      if (spoken_of.contains(*(*groups)[plant.components[c].mode])) made.components.emplace_back(c);
    }
  }
}

const Insight::Question& Insight::question(const Formula& formula) const {
  const auto known = std::find_if(questions_.begin(), questions_.end(),
                                  [&](const Question& question) { return question.formula == formula; });
  CHECK(known != questions_.end() && "all that is asked was told beforehand");
  return *known;
}

bool Insight::answer(const Formula& atom, const Estimator& estimator, std::span<const automata::Assignment> readings) {
  if (atom.knowing == Knowing::surprise) {
    const Estimate& estimate = estimator.estimate();
    if (!atom.about_one) return !estimate.consistent;
    const auto component = about(plant_, atom);
    CHECK(component);
    return !estimate.surprised.empty() && estimate.surprised[component->index()];
  }
  CHECK(atom.knowing != Knowing::no_plan);
  const Question& asked = question(atom.operands.front());
  const bool likely = atom.knowing == Knowing::likely;
  std::map<automata::Modes, double> shares;
  for (const BeliefEntry& entry : estimator.belief_about(asked.components)) {
    shares[entry.state.modes] += entry.probability;
  }
  double sum = 0;
  for (const auto& [modes, share] : shares) {
    if (!likely && share < atom.probability - rounding) continue;
    known_.clear();
    automata::append_known(plant_, modes, known_);
    known_.insert(known_.end(), readings.begin(), readings.end());
    if (!likely) {
      if (theory_->allows(known_, asked.handle)) return true;
    } else if (theory_->entails(known_, asked.handle)) {
      sum += share;
      if (sum >= atom.probability - rounding) return true;
    }
  }
  return false;
}

}  // namespace rmpl::runtime
