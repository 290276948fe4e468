// Value iteration, word by word from semantics 3 and 7.
// SPDX-License-Identifier: MIT
#include "tests/reference/probability.hpp"

#include <boost/math/special_functions/erf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <map>
#include <tuple>

#include "base/product.hpp"

namespace rmpl::reference {

using automata::ControlAction;
using automata::ModeId;
using automata::SystemState;
using automata::Ticks;
using automata::Timing;
using automata::Transition;
using automata::Weight;
using Real = boost::multiprecision::cpp_bin_float_50;

namespace {

Rational rational(double value) { return Rational(value); }
Rational seconds(Ticks time) { return Rational(time.count, Ticks::per_second); }
Real real(const Rational& value) { return Real(numerator(value)) / Real(denominator(value)); }
Rational digits(const Real& value) { return Rational(value); }

/// 1 - G, of a density that is not uniform.
Real tail(const automata::Density& density, const Rational& at) {
  const Real t = real(at);
  if (density.kind == automata::Density::Kind::exponential) return exp(-t / Real(density.mean));
  if (density.kind == automata::Density::Kind::weibull) return exp(-pow(t / Real(density.scale), Real(density.shape)));
  if (density.kind == automata::Density::Kind::erlang) {
    const Real x = t * Real(density.shape) / Real(density.mean);
    Real term = 1, sum = 1;
    for (int i = 1; i < density.shape; ++i) sum += term *= x / i;
    return exp(-x) * sum;
  }
  return boost::math::erfc((t - Real(density.mean)) / (Real(density.standard_deviation) * sqrt(Real(2)))) / 2;
}

/// The probability of not firing until the clock is at `to`, where it was at `from` and nothing had fired.
Rational stays(const Timing& timing, Ticks from, Ticks to) {
  if (to >= timing.upper) return 0;
  if (to <= timing.lower || to <= from) return 1;
  const Ticks begin = std::max(from, timing.lower);
  if (timing.density.kind == automata::Density::Kind::uniform) {
    return seconds(timing.upper - to) / seconds(timing.upper - begin);
  }
  const Real end = timing.upper.is_infinite() ? Real(0) : tail(timing.density, seconds(timing.upper));
  return digits((tail(timing.density, seconds(to)) - end) / (tail(timing.density, seconds(begin)) - end));
}

Rational weight_of(const Transition& t) {
  return t.weight.kind == Weight::Kind::none ? Rational(1) : rational(t.weight.value);
}

struct Risk {
  std::vector<const Transition*> outcomes;
  Rational survival;
};

void share(const Rational& probability, const std::vector<const Transition*>& among, std::vector<Rational>& result) {
  Rational total = 0;
  for (const Transition* t : among) total += weight_of(*t);
  for (const Transition* t : among) result[t->to.index()] += probability * weight_of(*t) / total;
}

void compete(const Rational& probability, const std::vector<Risk>& risks, std::size_t stay,
             std::vector<Rational>& result) {
  Rational nothing = 1;
  std::size_t certain = 0;
  std::size_t open = 0;
  Real hazards = 0;
  for (const Risk& risk : risks) {
    nothing *= risk.survival;
    if (risk.survival == 0) {
      ++certain;
    } else if (risk.survival < 1) {
      ++open;
      hazards -= log(real(risk.survival));
    }
  }
  result[stay] += probability * nothing;
  for (const Risk& risk : risks) {
    Rational part = 0;
    if (certain > 0) {
      if (risk.survival == 0) part = Rational(1, certain);
    } else if (risk.survival < 1) {
      part = open == 1 ? Rational(1) : digits(-log(real(risk.survival)) / hazards);
    }
    if (part > 0) share(probability * (1 - nothing) * part, risk.outcomes, result);
  }
}

class Iteration {
 public:
  Iteration(const Step& step, const Question& question, Ticks period)
      : step_(step), plant_(step.plant()), question_(question), period_(period) {
    add_actions({}, 0);
  }

  Probabilities run(std::size_t steps) {
    std::vector<std::vector<ModeId>> lists;
    for (const automata::Component& component : plant_.components) {
      auto& modes = lists.emplace_back();
      for (std::size_t m = 0; m < component.modes.size(); ++m) {
        if (component.initial[m] > 0) modes.emplace_back(m);
      }
    }
    Rational all = 0;
    Probabilities sum;
    base::for_each_combination(lists, [&](const automata::Modes& modes) {
      if (!step_.possible(modes)) return;
      Rational weight = 1;
      for (std::size_t c = 0; c < modes.size(); ++c) {
        if (lists[c].size() > 1) weight *= rational(plant_.components[c].initial[modes[c].index()]);
      }
      const Probabilities own = from(modes, std::vector<std::int64_t>(modes.size(), 0), steps);
      all += weight;
      sum.least += weight * own.least;
      sum.greatest += weight * own.greatest;
    });
    if (all == 0) return {};
    return {sum.least / all, sum.greatest / all};
  }

 private:
  void add_actions(ControlAction so_far, std::size_t off) {
    if (so_far.size() == plant_.controls.size()) {
      actions_.push_back(so_far);
      return;
    }
    const automata::Control& control = plant_.controls[so_far.size()];
    for (std::size_t v = 0; v < plant_.variables[control.variable].values.size(); ++v) {
      const bool idle = control.idle.index() == v;
      const std::size_t now = off + (idle ? 0 : 1);
      if (question_.commands == Question::Commands::none && now > 0) continue;
      if (question_.commands == Question::Commands::one && now > 1) continue;
      ControlAction longer = so_far;
      longer.emplace_back(v);
      add_actions(longer, now);
    }
  }

  bool holds(const automata::Modes& modes) const {
    const auto state = assumptions_of(plant_, modes);
    return question_.entailed ? step_.models().entails(state, question_.target)
                              : step_.models().allows(state, question_.target);
  }

  Probabilities from(const automata::Modes& modes, const std::vector<std::int64_t>& ages, std::size_t steps) {
    if (holds(modes)) return {1, 1};
    if (steps == 0) return {0, 0};
    const auto key = std::make_tuple(modes, ages, steps);
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    std::optional<Probabilities> best;
    for (const ControlAction& action : actions_) {
      if (!step_.models().consistent(assumptions_of(plant_, modes, action))) continue;
      const auto value = after(modes, ages, action, steps);
      if (!value) continue;
      if (!best) best = value;
      best->least = std::min(best->least, value->least);
      best->greatest = std::max(best->greatest, value->greatest);
    }
    return known_[key] = best.value_or(Probabilities{0, 0});
  }

  /// Nothing where nothing can follow.
  std::optional<Probabilities> after(const automata::Modes& modes, const std::vector<std::int64_t>& ages,
                                     const ControlAction& action, std::size_t steps) {
    SystemState state{modes, {}};
    for (const std::int64_t age : ages) state.clock_starts.push_back(Ticks{-age * period_.count});
    std::vector<std::vector<Rational>> distributions;
    std::vector<std::vector<ModeId>> lists;
    for (std::size_t c = 0; c < modes.size(); ++c) {
      distributions.push_back(exact_distribution(step_, c, state, action, Ticks{0}, period_));
      auto& possible = lists.emplace_back();
      for (std::size_t m = 0; m < distributions.back().size(); ++m) {
        if (distributions.back()[m] > 0) possible.emplace_back(m);
      }
    }
    Rational all = 0;
    Probabilities sum;
    base::for_each_combination(lists, [&](const automata::Modes& next) {
      if (!step_.possible(next)) return;
      Rational weight = 1;
      std::vector<std::int64_t> older;
      for (std::size_t c = 0; c < next.size(); ++c) {
        weight *= distributions[c][next[c].index()];
        older.push_back(next[c] == modes[c] && !step_.restarts(c, modes, action) ? ages[c] + 1 : 0);
      }
      const Probabilities own = from(next, older, steps - 1);
      all += weight;
      sum.least += weight * own.least;
      sum.greatest += weight * own.greatest;
    });
    if (all == 0) return std::nullopt;
    return Probabilities{sum.least / all, sum.greatest / all};
  }

  const Step& step_;
  const automata::Plant& plant_;
  const Question& question_;
  Ticks period_;
  std::vector<ControlAction> actions_;
  std::map<std::tuple<automata::Modes, std::vector<std::int64_t>, std::size_t>, Probabilities> known_;
};

}  // namespace

std::vector<Rational> exact_distribution(const Step& step, std::size_t component, const SystemState& state,
                                         const ControlAction& action, Ticks before, Ticks now) {
  const automata::Component& automaton = step.plant().components[component];
  const ModeId mode = state.modes[component];
  const Ticks a = before - state.clock_starts[component];
  const Ticks b = now - state.clock_starts[component];
  std::vector<Rational> result(automaton.modes.size());
  Rational faulty = 0;
  std::vector<const Transition*> untimed;
  std::vector<std::pair<std::uint32_t, Risk>> risks;
  for (const Transition& t : automaton.transitions) {
    if (t.from != mode || !step.enabled(t, state.modes, action)) continue;
    if (automaton.is_fault(t)) {
      if (t.timing && (b < t.timing->lower || b > t.timing->upper)) continue;
      const Rational p = t.weight.kind == Weight::Kind::rate
                             ? digits(-expm1(-Real(t.weight.value) * real(seconds(now - before))))
                             : rational(t.weight.value);
      result[t.to.index()] += p;
      faulty += p;
    } else if (!t.timing) {
      if (weight_of(t) > 0) untimed.push_back(&t);
    } else if (weight_of(t) > 0) {
      if (risks.empty() || risks.back().first != t.branch) risks.push_back({t.branch, {{}, stays(*t.timing, a, b)}});
      risks.back().second.outcomes.push_back(&t);
    }
  }
  if (faulty >= 1) {
    for (Rational& p : result) p /= faulty;
    return result;
  }
  if (!untimed.empty()) {
    share(1 - faulty, untimed, result);
  } else {
    std::vector<Risk> competing;
    for (auto& [branch, risk] : risks) competing.push_back(std::move(risk));
    compete(1 - faulty, competing, mode.index(), result);
  }
  return result;
}

Probabilities probabilities(const Step& step, const Question& question, Ticks period, std::size_t steps) {
  return Iteration(step, question, period).run(steps);
}

}  // namespace rmpl::reference
