// The two readings of time.
// SPDX-License-Identifier: MIT
#include "verifier/zone/time_model.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "automata/software/software_in.hpp"
#include "base/check.hpp"
#include "base/error.hpp"

namespace rmpl::verifier {

using automata::Ticks;

namespace {

/// Sums of a few bounds stay far from the end of the range.
constexpr Units longest = unbounded / 16;

std::vector<Ticks> finite_bounds(const automata::Plant& plant) {
  std::vector<Ticks> bounds;
  for (const automata::Component& component : plant.components) {
    for (const automata::Transition& t : component.transitions) {
      if (!t.timing) continue;
      bounds.push_back(t.timing->lower);
      if (!t.timing->upper.is_infinite()) bounds.push_back(t.timing->upper);
    }
  }
  return bounds;
}

}  // namespace

std::optional<Ticks> usual_period(const automata::Plant& plant) {
  const auto is_timed = [](const automata::Component& component) {
    return std::any_of(component.transitions.begin(), component.transitions.end(),
                       [](const automata::Transition& t) { return t.timing.has_value(); });
  };
  const auto& all = plant.components;
  if (automata::software_in(plant) == nullptr || std::any_of(all.begin(), all.end(), is_timed)) return std::nullopt;
  return Ticks::of_seconds(1);
}

void refuse_dense_time(const automata::Plant& plant) {
  const automata::Component* const software = automata::software_in(plant);
  if (software == nullptr) return;
  throw base::InputError(
      "'" + software->name +
      "' is software, which takes a step a cycle: dense time has no cycles; give their length, as in --time 1s");
}

TimeModel TimeModel::dense(const automata::Plant& plant, std::span<const Ticks> others) {
  refuse_dense_time(plant);
  std::vector<Ticks> bounds = finite_bounds(plant);
  bounds.insert(bounds.end(), others.begin(), others.end());
  Units unit = 0;
  Units greatest = 0;
  for (const Ticks bound : bounds) {
    unit = std::gcd(unit, bound.count);
    greatest = std::max(greatest, bound.count);
  }
  if (unit == 0) unit = Ticks::per_second;
  if (greatest / unit > longest) {
    throw base::InputError("time bounds up to " + automata::format_seconds(Ticks{greatest}) + " s in steps of " +
                           automata::format_seconds(Ticks{unit}) +
                           " s are beyond what can be checked; expected coarser or shorter bounds");
  }
  return {true, Ticks{unit}};
}

TimeModel TimeModel::sampled(Ticks period) {
  CHECK(period > Ticks{0} && !period.is_infinite());
  return {false, period};
}

TimeModel TimeModel::of(std::optional<Ticks> period, const automata::Plant& plant, std::span<const Ticks> others) {
  if (period) return sampled(*period);
  TimeModel result = dense(plant, others);
  if (result.unit_.count % 2 == 0) {
    result.unit_.count /= 2;
    result.grain_ = 2;
  }
  return result;
}

Units TimeModel::at_least(Ticks time) const {
  if (time.is_infinite()) return unbounded;
  return time.count / unit_.count + (time.count % unit_.count == 0 ? 0 : 1);
}

Units TimeModel::at_most(Ticks time) const { return time.is_infinite() ? unbounded : time.count / unit_.count; }

Ticks TimeModel::ticks(Units units) const {
  if (units > (unbounded - 1) / unit_.count) {
    throw base::InputError("a witness takes longer than the 292 years that can be told; expected shorter bounds");
  }
  return {units * unit_.count};
}

}  // namespace rmpl::verifier
