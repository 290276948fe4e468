// The constraint store behind a diagnosis.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/snapshot.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "automata/store/model.hpp"
#include "base/check.hpp"

namespace rmpl::runtime {
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

/// Per mode the probability of the likeliest way to it by fault transitions and their consequences, from any nominal
/// mode; 1 for these. Consequences are free.
std::vector<double> ways_to_faults(const Component& component) {
  std::vector<double> way(component.modes.size(), 0.0);
  for (std::size_t m = 0; m < way.size(); ++m) way[m] = component.modes[m].fault ? 0.0 : 1.0;
  // A way goes through each fault once, so that after as many rounds none is found that is likelier.
  for (bool changed = true; changed;) {
    changed = false;
    for (const Transition& t : component.transitions) {
      if (t.from == t.to || !(component.is_fault(t) || t.consequence)) continue;
      const double own = t.consequence ? 1 : t.weight.fault_probability(automata::Ticks::of_seconds(1));
      const double longer = way[t.from.index()] * own;
      if (longer <= way[t.to.index()]) continue;
      way[t.to.index()] = longer;
      changed = true;
    }
    // Modes of one marking are one fault, or none.
    for (std::size_t m = 0; m < way.size(); ++m) {
      const std::optional<ModeId> usual = component.modes[m].usual;
      if (!usual || way[m] <= way[usual->index()]) continue;
      way[usual->index()] = way[m];
      changed = true;
    }
  }
  return way;
}

}  // namespace

Statuses statuses_of(const Component& component) {
  Statuses statuses;
  for (std::size_t m = 0; m < component.modes.size(); ++m) {
    if (component.modes[m].usual) continue;
    (component.modes[m].fault ? statuses.faults : statuses.nominals).emplace_back(m);
  }
  double faulty_at_first = 0;
  for (const ModeId fault : statuses.faults) faulty_at_first += component.initial[fault.index()];
  statuses.priors.push_back(0);
  double faulty = 0;
  const std::vector<double> ways = ways_to_faults(component);
  for (const ModeId fault : statuses.faults) {
    const double entered = std::max(0.0, 1 - faulty_at_first) * ways[fault.index()];
    statuses.priors.push_back(component.initial[fault.index()] + entered);
    faulty += statuses.priors.back();
  }
  // Each fault was taken on the way that makes it likeliest, so that together they may exceed 1.
  statuses.priors[0] = statuses.nominals.empty() ? 0.0 : std::max(0.0, 1 - faulty);
  const double sum = statuses.priors[0] + faulty;
  for (double& prior : statuses.priors) prior = sum > 0 ? prior / sum : 0.0;
  return statuses;
}

Snapshot::Snapshot(const Plant& plant, const automata::Observation& observation, std::size_t counted)
    : theory_(extend(plant, counted),
              counted == 0 ? automata::Theory::Upkeep::maintained : automata::Theory::Upkeep::searched) {
  automata::tell_model(theory_, plant);
  for (const Assignment& reading : observation) theory_.tell(automata::is(reading.variable, reading.value));
  tell_statuses(plant);
  tell_counter();
}

/// Status variables follow the plant's own, one after the other; no name of a plant holds a space.
automata::Variables Snapshot::extend(const Plant& plant, std::size_t counted) {
  automata::Variables variables = plant.variables;
  for (const Component& component : plant.components) {
    Statuses statuses = statuses_of(component);
    if (statuses.nominals.size() == 1 && statuses.faults.size() + 1 == component.modes.size()) {
      statuses.variable = component.mode;
      statuses.values.emplace_back(statuses.nominals.front().index());
      for (const ModeId fault : statuses.faults) statuses.values.emplace_back(fault.index());
    } else {
      std::vector<std::string> values{"nominal"};
      for (const ModeId fault : statuses.faults) values.push_back("fault " + component.modes[fault.index()].name);
      for (std::size_t v = 0; v < values.size(); ++v) statuses.values.emplace_back(v);
      statuses.variable = variables.add({component.name + " status", std::move(values)});
    }
    statuses_.push_back(std::move(statuses));
  }
  for (const Component& component : plant.components) {
    auto& row = more_than_.emplace_back();
    for (std::size_t j = 0; j < counted; ++j) {
      row.push_back(variables.add({component.name + " more than " + std::to_string(j), {"no", "yes"}}));
    }
  }
  component_of_.resize(variables.size());
  for (std::uint32_t c = 0; c < statuses_.size(); ++c) component_of_[statuses_[c].variable.index()] = c;
  return variables;
}

void Snapshot::tell_statuses(const Plant& plant) {
  for (std::size_t c = 0; c < statuses_.size(); ++c) {
    const VariableId mode = plant.components[c].mode;
    const Statuses& statuses = statuses_[c];
    if (statuses.variable == mode) continue;
    std::vector<ValueId> nominals;
    for (const ModeId nominal : statuses.nominals) nominals.emplace_back(nominal.index());
    theory_.tell_if(statuses.is(0), automata::member(mode, nominals));
    for (std::size_t f = 0; f < statuses.faults.size(); ++f) {
      theory_.tell_if(statuses.is(f + 1), automata::is(mode, ValueId(statuses.faults[f].index())));
    }
  }
}

std::uint32_t Snapshot::status_of(Assignment assignment) const {
  const std::vector<ValueId>& values = statuses_[component_of_[assignment.variable.index()]].values;
  return static_cast<std::uint32_t>(std::find(values.begin(), values.end(), assignment.value) - values.begin());
}

/// The sequential counter of Sinz (CP 2005), one direction: what holds must be counted.
void Snapshot::tell_counter() {
  for (std::size_t c = 0; c < more_than_.size(); ++c) {
    const Assignment nominal = statuses_[c].is(0);
    const Formula works = automata::is(nominal.variable, nominal.value);
    for (std::size_t j = 0; j < more_than_[c].size(); ++j) {
      const Formula counted = automata::is(more_than_[c][j], yes);
      if (c > 0) theory_.tell_if({more_than_[c - 1][j], yes}, counted);
      if (j == 0) {
        theory_.tell_if({more_than_[c][0], no}, works);
      } else if (c > 0) {
        theory_.tell_if({more_than_[c - 1][j - 1], yes}, automata::disjunction({works, counted}));
      }
    }
  }
}

std::optional<Conflict> Snapshot::refute(std::span<const std::uint32_t> candidate) {
  assumptions_.clear();
  for (std::size_t c = 0; c < candidate.size(); ++c) assumptions_.push_back(statuses_[c].is(candidate[c]));
  if (theory_.consistent(assumptions_)) return std::nullopt;
  const std::vector<Assignment>& core = theory_.conflict();
  Conflict conflict;
  for (const Assignment& a : core) conflict.push_back({component_of_[a.variable.index()], status_of(a)});
  return conflict;
}

std::optional<std::vector<std::uint32_t>> Snapshot::at_most(std::size_t faults) {
  assumptions_.clear();
  if (!more_than_.empty()) {
    CHECK(faults < more_than_.back().size());
    assumptions_.push_back({more_than_.back()[faults], no});
  }
  if (!theory_.consistent(assumptions_)) return std::nullopt;
  std::vector<std::uint32_t> candidate;
  for (const Statuses& statuses : statuses_)
    candidate.push_back(status_of({statuses.variable, theory_.value(statuses.variable)}));
  return candidate;
}

void Snapshot::exclude(std::span<const std::uint32_t> candidate) {
  std::vector<Formula> faults;
  for (std::size_t c = 0; c < candidate.size(); ++c) {
    const Assignment status = statuses_[c].is(candidate[c]);
    if (candidate[c] > 0) faults.push_back(automata::is(status.variable, status.value));
  }
  theory_.tell(automata::negation(automata::conjunction(std::move(faults))));
}

}  // namespace rmpl::runtime
