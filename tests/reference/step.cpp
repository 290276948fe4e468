// One step of a plant with its probabilities, word by word from semantics 3.
// SPDX-License-Identifier: MIT
#include "tests/reference/step.hpp"

#include <cmath>
#include <numeric>

namespace rmpl::reference {

using automata::Ticks;
using automata::Timing;
using automata::Transition;
using automata::Weight;

namespace {

/// The untruncated probability of taking longer than t seconds.
double upper_tail(const automata::Density& density, double t) {
  switch (density.kind) {
    case automata::Density::Kind::uniform:
      return -t;  // any falling line: truncation scales it
    case automata::Density::Kind::exponential:
      return std::exp(-t / density.mean);
    case automata::Density::Kind::weibull:
      return std::exp(-std::pow(t / density.scale, density.shape));
    case automata::Density::Kind::erlang: {
      const double x = t * density.shape / density.mean;
      double term = 1, sum = 1;
      for (double i = 1; i < density.shape; ++i) sum += term *= x / i;
      return std::exp(-x) * sum;
    }
    case automata::Density::Kind::normal:
      return 0.5 * std::erfc((t - density.mean) / (density.standard_deviation * std::sqrt(2.0)));
  }
  return 0;
}

/// Timed transitions that were written as one: one risk, several outcomes.
struct Risk {
  std::vector<const Transition*> outcomes;
  double survival = 1;
};

double weight_of(const Transition& transition) {
  return transition.weight.kind == Weight::Kind::none ? 1 : transition.weight.value;
}

double total_weight(const std::vector<const Transition*>& transitions) {
  return std::accumulate(transitions.begin(), transitions.end(), 0.0,
                         [](double sum, const Transition* t) { return sum + weight_of(*t); });
}

void share(double probability, const std::vector<const Transition*>& among, std::vector<double>& result) {
  for (const Transition* t : among) result[t->to.index()] += probability * weight_of(*t) / total_weight(among);
}

/// Several enabled timed transitions compete as independent risks; what they leave stays.
void compete(double probability, const std::vector<Risk>& risks, std::size_t stay, std::vector<double>& result) {
  double nothing_fires = 1;
  double hazards = 0;
  double certain = 0;
  for (const Risk& risk : risks) {
    nothing_fires *= risk.survival;
    if (risk.survival > 0)
      hazards += -std::log(risk.survival);
    else
      ++certain;
  }
  result[stay] += probability * nothing_fires;
  for (const Risk& risk : risks) {
    double part = 0;
    if (certain > 0)
      part = risk.survival > 0 ? 0 : 1 / certain;
    else if (hazards > 0)
      part = -std::log(risk.survival) / hazards;
    share(probability * (1 - nothing_fires) * part, risk.outcomes, result);
  }
}

}  // namespace

double survival(const Timing& timing, Ticks t) {
  if (t >= timing.upper) return 0;
  if (t <= timing.lower) return 1;
  const double at = upper_tail(timing.density, t.seconds());
  const double at_lower = upper_tail(timing.density, timing.lower.seconds());
  const double at_upper = timing.upper.is_infinite() ? 0 : upper_tail(timing.density, timing.upper.seconds());
  return (at - at_upper) / (at_lower - at_upper);
}

bool Step::possible(const automata::Modes& modes) const { return models_.consistent(assumptions_of(plant_, modes)); }

bool Step::enabled(const Transition& transition, const automata::Modes& modes,
                   const automata::ControlAction& action) const {
  return models_.entails(assumptions_of(plant_, modes, action), transition.guard);
}

std::vector<double> Step::distribution(std::size_t component, const automata::SystemState& state,
                                       const automata::ControlAction& action, Ticks before, Ticks now) const {
  const automata::Component& automaton = plant_.components[component];
  const automata::ModeId mode = state.modes[component];
  const Ticks a = before - state.clock_starts[component];
  const Ticks b = now - state.clock_starts[component];
  std::vector<double> result(automaton.modes.size(), 0.0);

  double nominal_share = 1;
  std::vector<const Transition*> untimed;
  std::vector<std::pair<std::uint32_t, Risk>> risks;
  for (const Transition& transition : automaton.transitions) {
    if (transition.from != mode || !enabled(transition, state.modes, action)) continue;
    if (automaton.is_fault(transition)) {
      if (transition.timing && (b < transition.timing->lower || b > transition.timing->upper)) continue;
      const double probability = transition.weight.kind == Weight::Kind::rate
                                     ? 1 - std::exp(-transition.weight.value * (now - before).seconds())
                                     : transition.weight.value;
      result[transition.to.index()] += probability;
      nominal_share -= probability;
    } else if (!transition.timing) {
      if (weight_of(transition) > 0) untimed.push_back(&transition);
    } else {
      if (risks.empty() || risks.back().first != transition.branch) {
        const double before_it = survival(*transition.timing, a);
        const double after_it = survival(*transition.timing, b);
        risks.push_back({transition.branch, {{}, before_it > 0 ? after_it / before_it : 0}});
      }
      risks.back().second.outcomes.push_back(&transition);
    }
  }

  if (nominal_share <= 0) {
    for (double& probability : result) probability /= 1 - nominal_share;
    return result;
  }
  if (!untimed.empty()) {
    share(nominal_share, untimed, result);
  } else {
    std::vector<Risk> competing;
    competing.reserve(risks.size());
    for (auto& [branch, risk] : risks) competing.push_back(std::move(risk));
    compete(nominal_share, competing, mode.index(), result);
  }
  return result;
}

double Step::observation_factor(const automata::Modes& modes, const automata::Observation& observation) const {
  if (!explains(modes, observation)) return 0;
  const auto state = assumptions_of(plant_, modes);
  double factor = 1;
  for (automata::Assignment seen : observation) {
    const automata::Formula said = automata::is(seen.variable, seen.value);
    if (!models_.allows(state, said)) return 0;
    if (!models_.entails(state, said)) factor /= static_cast<double>(plant_.variables[seen.variable].values.size());
  }
  return factor;
}

bool Step::explains(const automata::Modes& modes, const automata::Observation& observation) const {
  auto assumptions = assumptions_of(plant_, modes);
  assumptions.insert(assumptions.end(), observation.begin(), observation.end());
  return models_.consistent(assumptions);
}

bool Step::restarts(std::size_t component, const automata::Modes& modes, const automata::ControlAction& action) const {
  const auto& transitions = plant_.components[component].transitions;
  return std::any_of(transitions.begin(), transitions.end(), [&](const Transition& t) {
    return t.restart && t.from == modes[component] && weight_of(t) > 0 && enabled(t, modes, action);
  });
}

automata::SystemState Step::advance(const automata::SystemState& state, const automata::ControlAction& action,
                                    const automata::Modes& next, Ticks now) const {
  automata::SystemState result = {next, state.clock_starts};
  for (std::size_t i = 0; i < next.size(); ++i)
    if (next[i] != state.modes[i] || restarts(i, state.modes, action)) result.clock_starts[i] = now;
  return result;
}

}  // namespace rmpl::reference
