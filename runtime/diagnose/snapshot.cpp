// The constraint store behind a diagnosis.
// SPDX-License-Identifier: MIT
#include "runtime/diagnose/snapshot.hpp"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

namespace runtime {
namespace {

using automata::Assignment;
using automata::Component;
using automata::Formula;
using automata::ModeId;
using automata::Plant;
using automata::Transition;
using automata::ValueId;
using automata::VariableId;

constexpr ValueId no{0};
constexpr ValueId yes{1};

}  // namespace

Statuses statuses_of(const Component& component) {
  Statuses statuses;
  statuses.priors.push_back(0);
  double faulty = 0;
  for (std::size_t m = 0; m < component.modes.size(); ++m) {
    if (!component.modes[m].fault) {
      statuses.has_nominal = true;
      continue;
    }
    bool entered = false;
    double prior = 0;
    for (const Transition& t : component.transitions) {
      if (t.to != ModeId(m)) continue;
      entered = true;
      prior = std::max(prior, t.weight.fault_probability(automata::Ticks::of_seconds(1)));
    }
    if (!entered) prior = component.initial[m];
    statuses.faults.emplace_back(m);
    statuses.priors.push_back(prior);
    faulty += prior;
  }
  // Each fault was taken from the source that makes it likeliest, so that together they may exceed 1.
  statuses.priors[0] = statuses.has_nominal ? std::max(0.0, 1 - faulty) : 0.0;
  const double sum = statuses.priors[0] + faulty;
  for (double& prior : statuses.priors) prior = sum > 0 ? prior / sum : 0.0;
  return statuses;
}

Snapshot::Snapshot(const Plant& plant, const automata::Observation& observation, std::size_t counted)
    : theory_(extend(plant, counted)) {
  for (const Formula& q : plant.interconnections) theory_.tell(q);
  for (const Assignment& reading : observation) theory_.tell(automata::is(reading.variable, reading.value));
  tell_statuses(plant);
  tell_counter();
}

/// Statuses follow the plant's own variables, one after the other; no name of a plant holds a space.
automata::Variables Snapshot::extend(const Plant& plant, std::size_t counted) {
  automata::Variables variables = plant.variables;
  for (const Component& component : plant.components) {
    Statuses statuses = statuses_of(component);
    std::vector<std::string> values{"nominal"};
    for (const ModeId fault : statuses.faults) values.push_back("fault " + component.modes[fault.index()].name);
    statuses.variable = variables.add({component.name + " status", std::move(values)});
    statuses_.push_back(std::move(statuses));
  }
  for (const Component& component : plant.components) {
    auto& row = more_than_.emplace_back();
    for (std::size_t j = 0; j < counted; ++j) {
      row.push_back(variables.add({component.name + " more than " + std::to_string(j), {"no", "yes"}}));
    }
  }
  return variables;
}

void Snapshot::tell_statuses(const Plant& plant) {
  for (std::size_t c = 0; c < statuses_.size(); ++c) {
    const Component& component = plant.components[c];
    std::vector<ValueId> nominal;
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const Assignment mode{component.mode, ValueId(m)};
      if (!component.modes[m].constraint.is_true()) theory_.tell_if(mode, component.modes[m].constraint);
      if (!component.modes[m].fault) nominal.emplace_back(m);
    }
    const Statuses& statuses = statuses_[c];
    theory_.tell_if({statuses.variable, ValueId(0)}, automata::member(component.mode, nominal));
    for (std::size_t f = 0; f < statuses.faults.size(); ++f) {
      theory_.tell_if({statuses.variable, ValueId(f + 1)},
                      automata::is(component.mode, ValueId(statuses.faults[f].index())));
    }
  }
}

/// The sequential counter of Sinz (CP 2005), one direction: what holds must be counted.
void Snapshot::tell_counter() {
  for (std::size_t c = 0; c < more_than_.size(); ++c) {
    const Formula faulty = automata::negation(automata::is(statuses_[c].variable, ValueId(0)));
    for (std::size_t j = 0; j < more_than_[c].size(); ++j) {
      const Formula counted = automata::is(more_than_[c][j], yes);
      if (c > 0) theory_.tell_if({more_than_[c - 1][j], yes}, counted);
      if (j == 0) {
        theory_.tell_if({more_than_[c][0], no}, automata::is(statuses_[c].variable, ValueId(0)));
      } else if (c > 0) {
        theory_.tell_if({more_than_[c - 1][j - 1], yes}, automata::implication(faulty, counted));
      }
    }
  }
}

std::optional<Conflict> Snapshot::refute(std::span<const std::uint32_t> candidate) {
  assumptions_.clear();
  for (std::size_t c = 0; c < candidate.size(); ++c) {
    assumptions_.push_back({statuses_[c].variable, ValueId(candidate[c])});
  }
  if (theory_.consistent(assumptions_)) return std::nullopt;
  // Asked again for the core alone, last decision first, the solver most often blames fewer: such questions are cheap,
  // while leaving out one status after the other would have it find a model for each that is needed.
  std::vector<Assignment> core = theory_.conflict();
  for (std::size_t before = core.size() + 1; core.size() < before;) {
    before = core.size();
    assumptions_.assign(core.rbegin(), core.rend());
    [[maybe_unused]] const bool consistent = theory_.consistent(assumptions_);
    assert(!consistent);
    core = theory_.conflict();
  }
  Conflict conflict;
  for (const Assignment& a : core) {
    conflict.push_back({a.variable.value - statuses_.front().variable.value, a.value.value});
  }
  return conflict;
}

std::optional<std::vector<std::uint32_t>> Snapshot::at_most(std::size_t faults) {
  assumptions_.clear();
  if (!more_than_.empty()) {
    assert(faults < more_than_.back().size());
    assumptions_.push_back({more_than_.back()[faults], no});
  }
  if (!theory_.consistent(assumptions_)) return std::nullopt;
  std::vector<std::uint32_t> candidate;
  for (const Statuses& statuses : statuses_) candidate.push_back(theory_.value(statuses.variable).value);
  return candidate;
}

void Snapshot::exclude(std::span<const std::uint32_t> candidate) {
  std::vector<Formula> faults;
  for (std::size_t c = 0; c < candidate.size(); ++c) {
    if (candidate[c] > 0) faults.push_back(automata::is(statuses_[c].variable, ValueId(candidate[c])));
  }
  theory_.tell(automata::negation(automata::conjunction(std::move(faults))));
}

}  // namespace runtime
