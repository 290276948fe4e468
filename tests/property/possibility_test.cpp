// What the verifier calls possible in sampled time has a positive probability in the estimator, and the other way
// about.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <set>
#include <vector>

#include "automata/step/transition_rules.hpp"
#include "tests/property/draw.hpp"
#include "verifier/behaviour/choices.hpp"

namespace rmpl::property {
namespace {

using automata::Component;
using automata::Density;
using automata::Enabled;
using automata::ModeId;
using automata::Ticks;
using automata::Timing;
using automata::Transition;
using automata::TransitionId;
using automata::Weight;

constexpr std::int64_t day = 86400 * Ticks::per_second;

/// Bounds and parameters of any size, so that most steps are far from where the density has its weight.
Timing draw_timing() {
  const Ticks lower{pick<std::int64_t>({0, 1, 999, Ticks::per_second, 1000 * day, 90'000 * day})};
  const Ticks upper{lower.count + pick<std::int64_t>({0, 1, 1'000'000, 3 * Ticks::per_second, day, 1000 * day})};
  switch (up_to(0, 4)) {
    case 0:
      return {lower, upper, {}};
    case 1:
      return {lower,
              chance(50) ? Ticks::infinite() : upper,
              {Density::Kind::exponential, pick<double>({1e-6, 1.0, 1e9}), 0}};
    case 2:
      return {lower,
              chance(50) ? Ticks::infinite() : upper,
              {Density::Kind::weibull, 0, 0, pick<double>({0.3, 1.5, 4.0, 40.0}), pick<double>({1e-6, 1.0, 1e9})}};
    case 3:
      return {lower,
              chance(50) ? Ticks::infinite() : upper,
              {Density::Kind::erlang, pick<double>({1e-6, 1.0, 1e9}), 0, pick<double>({2.0, 5.0, 100.0})}};
    default:
      return {lower,
              chance(50) ? Ticks::infinite() : upper,
              {Density::Kind::normal, pick<double>({0.001, 1.0, 1e6, 1e9}), pick<double>({1e-9, 0.1, 1.0, 1e6})}};
  }
}

/// Two nominal modes and two of fault, with transitions out of the first one.
Component draw_component() {
  Component component;
  component.modes.resize(4);
  component.modes[2].fault = component.modes[3].fault = true;
  const std::size_t count = up_to(0, 4);
  for (std::size_t i = 0; i < count; ++i) {
    Transition t{ModeId(0u), ModeId(up_to(0, 3)), automata::constant(true), std::nullopt, {}, 0, {}};
    t.branch = static_cast<std::uint32_t>(i);
    if (component.is_fault(t)) {
      t.weight = chance(50) ? Weight{Weight::Kind::rate, pick<double>({1e-30, 1e-6, 1.0, 1e3})}
                            : Weight{Weight::Kind::probability, pick<double>({1e-300, 0.001, 0.5, 1.0})};
      if (chance(25)) t.timing = draw_timing();
    } else if (chance(80)) {
      t.timing = draw_timing();
    }
    if (!component.is_fault(t) && chance(20)) t.weight = {Weight::Kind::probability, pick<double>({1e-300, 0.5})};
    component.transitions.push_back(t);
  }
  return component;
}

/// The end of a period: near some bound of the component, or anywhere.
Ticks draw_clock(const Component& component, Ticks period) {
  std::int64_t near = pick<std::int64_t>({0, 100 * Ticks::per_second, day, 1000 * day});
  for (const Transition& t : component.transitions) {
    if (!t.timing || chance(50)) continue;
    near = t.timing->upper.is_infinite() || chance(50) ? t.timing->lower.count : t.timing->upper.count;
  }
  const auto units = near / period.count + static_cast<std::int64_t>(up_to(0, 4)) - 2;
  return {std::max<std::int64_t>(units, 1) * period.count};
}

RC_GTEST_PROP(Possibility, IsTheSameInTheVerifierAndTheEstimator, ()) {
  const Component component = draw_component();
  const Ticks period{
      pick<std::int64_t>({1, 1000, Ticks::per_second / 2, Ticks::per_second, 60 * Ticks::per_second, day})};
  const Ticks clock = draw_clock(component, period);
  const Enabled enabled = automata::enabled_in(component, ModeId(0u), [](TransitionId) { return true; });

  std::set<ModeId> chosen;
  const auto reading = verifier::TimeModel::sampled(period);
  for (const verifier::Choice& choice : verifier::choices(component, ModeId(0u), enabled, reading)) {
    if (choice.clock.contains(clock.count / period.count)) chosen.insert(choice.mode);
  }
  std::set<ModeId> moved;
  double sum = 0;
  for (const automata::Move& move : automata::moves_of(component, ModeId(0u), enabled, clock, period)) {
    RC_ASSERT(move.probability > 0);
    moved.insert(move.mode);
    sum += move.probability;
  }
  RC_ASSERT(moved == chosen);
  // Faults that fill more than the whole leave nothing to the others, and are normalised away later.
  if (automata::nominal_share(component, enabled, clock, period) > 0) RC_ASSERT(std::abs(sum - 1) < 1e-12);
}

}  // namespace
}  // namespace rmpl::property
