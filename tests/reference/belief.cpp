// Mode estimation by summing over everything.
// SPDX-License-Identifier: MIT
#include "tests/reference/belief.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/reference/set_aside.hpp"

namespace rmpl::reference {

using automata::Modes;
using automata::SystemState;
using automata::Ticks;

namespace {

constexpr double hair = 1e-9;  // relative; far above rounding, far below any difference that a model states

/// Calls `visit` for each choice of one mode a component, with the product of their probabilities where positive.
void for_each_choice(const std::vector<std::vector<double>>& distributions,
                     const std::function<void(const Modes&, double)>& visit) {
  std::vector<std::size_t> sizes;
  for (const auto& distribution : distributions) sizes.push_back(distribution.size());
  for (const auto& tuple : tuples(sizes)) {
    Modes modes;
    double probability = 1;
    for (std::size_t i = 0; i < tuple.size(); ++i) {
      modes.emplace_back(tuple[i]);
      probability *= distributions[i][tuple[i]];
    }
    if (probability > 0) visit(modes, probability);
  }
}

/// `scaled`: what is possible of the outcomes of each state sums to 1.
void for_each_trajectory(const Step& step, const Belief& belief, const automata::ControlAction& action, Ticks before,
                         Ticks now, bool scaled, const std::function<void(const SystemState&, double)>& visit) {
  for (const auto& [state, weight] : belief) {
    std::vector<std::vector<double>> distributions;
    for (std::size_t i = 0; i < state.modes.size(); ++i)
      distributions.push_back(step.distribution(i, state, action, before, now));
    double possible = 0;
    for_each_choice(distributions, [&](const Modes& modes, double probability) {
      if (step.possible(modes)) possible += probability;
    });
    const double mass = scaled ? weight / possible : weight;
    for_each_choice(distributions, [&, &source = state](const Modes& modes, double probability) {
      if (step.possible(modes)) visit(step.advance(source, action, modes, now), mass * probability);
    });
  }
}

double total(const Belief& belief) {
  double sum = 0;
  for (const auto& [state, probability] : belief) sum += probability;
  return sum;
}

void normalise(Belief& belief) {
  const double sum = total(belief);
  for (auto& [state, probability] : belief) probability /= sum;
}

}  // namespace

Belief initial_belief(const Step& step) {
  std::vector<std::vector<double>> distributions;
  for (const automata::Component& component : step.plant().components) distributions.push_back(component.initial);
  Belief belief;
  for_each_choice(distributions, [&](const Modes& modes, double probability) {
    if (step.possible(modes)) belief[{modes, std::vector<Ticks>(modes.size())}] = probability;
  });
  return belief;
}

Belief predicted(const Step& step, const Belief& belief, const automata::ControlAction& action, Ticks before,
                 Ticks now) {
  Belief result;
  for_each_trajectory(step, belief, action, before, now, true,
                      [&](const SystemState& target, double probability) { result[target] += probability; });
  return result;
}

Update belief_update(const Step& step, const Belief& belief, const automata::ControlAction& action,
                     const automata::Observation& observation, Ticks before, Ticks now) {
  const Belief prior = predicted(step, belief, action, before, now);
  const auto weighed = [&](const automata::Observation& readings) {
    Belief posterior;
    for (const auto& [state, probability] : prior) {
      const double worth = probability * step.observation_factor(state.modes, readings);
      if (worth > 0) posterior[state] = worth;
    }
    return posterior;
  };
  const auto counted =
      set_aside(observation, [&](const automata::Observation& rest) { return !weighed(rest).empty(); });
  if (!counted) return {belief, observation, false};
  Update update{weighed(counted->rest), counted->aside, true};
  normalise(update.belief);
  return update;
}

MostLikely most_likely(const Belief& belief) {
  std::map<Modes, double> sums;
  for (const auto& [state, probability] : belief) sums[state.modes] += probability;
  MostLikely result;
  for (const auto& [modes, probability] : sums)
    if (probability > result.probability * (1 + hair)) result = {modes, probability, true};
  for (const auto& [modes, probability] : sums)
    if (modes != result.modes && probability > result.probability * (1 - hair)) result.unique = false;
  return result;
}

Belief timed_me(const Step& step, const Belief& belief, const automata::ControlAction& action,
                const automata::Observation& observation, Ticks before, Ticks now) {
  Belief result;
  for_each_trajectory(step, belief, action, before, now, false, [&](const SystemState& target, double probability) {
    if (!step.explains(target.modes, observation)) return;
    double& known = result[target];
    known = std::max(known, probability);
  });
  return result;
}

namespace {

/// Calls `visit` for each choice of one mode a component, with the sum of their ranks.
void for_each_ranked(const std::vector<std::vector<double>>& distributions,
                     const std::function<void(const Modes&, std::uint64_t)>& visit) {
  for_each_choice(distributions, [&](const Modes& modes, double) {
    std::uint64_t rank = 0;
    for (std::size_t i = 0; i < modes.size(); ++i) {
      rank += static_cast<std::uint64_t>(std::llround(-std::log10(distributions[i][modes[i].index()])));
    }
    visit(modes, rank);
  });
}

void keep_least(Ranks& ranks, const SystemState& state, std::uint64_t rank) {
  const auto [known, fresh] = ranks.try_emplace(state, rank);
  if (!fresh) known->second = std::min(known->second, rank);
}

}  // namespace

Ranks initial_ranks(const Step& step) {
  std::vector<std::vector<double>> distributions;
  for (const automata::Component& component : step.plant().components) distributions.push_back(component.initial);
  Ranks result;
  for_each_ranked(distributions, [&](const Modes& modes, std::uint64_t rank) {
    if (step.possible(modes)) keep_least(result, {modes, std::vector<Ticks>(modes.size())}, rank);
  });
  return result;
}

Ranks ranked(const Step& step, const Ranks& ranks, const automata::ControlAction& action,
             const automata::Observation& observation, Ticks before, Ticks now) {
  Ranks result;
  for (const auto& entry : ranks) {
    const SystemState& state = entry.first;
    std::vector<std::vector<double>> distributions;
    for (std::size_t i = 0; i < state.modes.size(); ++i) {
      distributions.push_back(step.distribution(i, state, action, before, now));
    }
    for_each_ranked(distributions, [&](const Modes& modes, std::uint64_t rank) {
      if (!step.possible(modes) || !step.explains(modes, observation)) return;
      keep_least(result, step.advance(state, action, modes, now), entry.second + rank);
    });
  }
  return result;
}

Ranks best(const Ranks& ranks, std::size_t k) {
  std::vector<std::uint64_t> all;
  for (const auto& [state, rank] : ranks) all.push_back(rank);
  std::sort(all.begin(), all.end());
  Ranks result = ranks;
  if (all.size() > k) std::erase_if(result, [&](const auto& entry) { return entry.second > all[k - 1]; });
  return result;
}

Best best(const Belief& belief, std::size_t k) {
  std::vector<std::pair<SystemState, double>> entries(belief.begin(), belief.end());
  std::stable_sort(entries.begin(), entries.end(), [](const auto& x, const auto& y) { return x.second > y.second; });
  Best result;
  if (entries.size() > k) {
    result.clear = entries[k].second < entries[k - 1].second * (1 - hair);
    entries.resize(k);
  }
  result.belief = Belief(entries.begin(), entries.end());
  return result;
}

}  // namespace rmpl::reference
