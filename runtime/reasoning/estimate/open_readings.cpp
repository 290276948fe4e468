// Readings that are left open, by small quantified questions that are answered by trying.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/open_readings.hpp"

#include <algorithm>

#include "automata/dependencies/constraints.hpp"
#include "base/partition.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"

namespace rmpl::runtime {

using automata::Assignment;
using automata::ComponentId;
using automata::Formula;
using automata::ModeId;
using automata::Modes;
using automata::ValueId;
using automata::VariableId;

namespace {

/// Assignments that may be tried for one reading; beyond, nothing is known of it.
constexpr std::size_t most_work = 1u << 13;
/// Lemmas of one reading; beyond, all are forgotten.
constexpr std::size_t most_lemmas = 256;
/// Choices of modes that are looked at for one that implies a reading; beyond, there may be one.
constexpr std::size_t most_choices = 256;

/// A reading, as a key.
std::uint64_t key(Assignment reading) { return std::uint64_t{reading.variable.value} << 32 | reading.value.value; }

template <class Item>
void sort_unique(std::vector<Item>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace

void OpenReadings::look_at_plant() {
  if (!owner_.empty()) return;
  owner_.resize(plant_.variables.size());
  for (std::size_t c = 0; c < plant_.components.size(); ++c) {
    owner_[plant_.components[c].mode.index()] = ComponentId(c);
  }
  merge_equals();
  index_readers();
  value_.resize(plant_.variables.size());
}

/// Attributes that an interconnection makes equal, always, count as one.
void OpenReadings::merge_equals() {
  base::Partition partition(plant_.variables.size());
  for (const automata::Constraint& constraint : automata::constraints_of(plant_)) {
    const Formula& formula = constraint.formula;
    const bool equates = !constraint.under && formula.kind == Formula::Kind::equality &&
                         !owner_[formula.variable.index()] && !owner_[formula.other.index()];
    if (equates) {
      partition.join(formula.variable.index(), formula.other.index());
    } else {
      told_.push_back({constraint.under, formula, {}, {}});
    }
  }
  for (std::size_t v = 0; v < plant_.variables.size(); ++v) {
    equal_.push_back(static_cast<Attribute>(partition.root(v)));
  }
}

void OpenReadings::index_readers() {
  readers_.resize(plant_.variables.size());
  for (std::uint32_t t = 0; t < told_.size(); ++t) {
    Told& told = told_[t];
    if (told.under) told.components.push_back(*owner_[told.under->variable.index()]);
    for (const VariableId v : variables_of(told.formula)) {
      if (const auto component = owner_[v.index()]) {
        told.components.push_back(*component);
      } else {
        told.attributes.push_back(equal_[v.index()]);
      }
    }
    sort_unique(told.attributes);
    sort_unique(told.components);
    for (const Attribute a : told.attributes) readers_[a].push_back(t);
  }
}

const std::vector<ComponentId>* OpenReadings::components(const Modes& modes, Assignment reading) {
  look_at_plant();
  std::vector<Lemma>& known = lemmas_[key(reading)];
  for (const Lemma& lemma : known) {
    bool holds = true;
    for (std::size_t i = 0; holds && i < lemma.components.size(); ++i) {
      holds = modes[lemma.components[i].index()] == lemma.modes[i];
    }
    if (holds) return lemma.open ? &lemma.components : nullptr;
  }
  if (known.size() >= most_lemmas) known.clear();
  const Lemma& lemma = known.emplace_back(work_out(modes, reading));
  return lemma.open ? &lemma.components : nullptr;
}

bool OpenReadings::may_be_implied(Assignment reading) {
  const auto known = implied_.find(key(reading));
  if (known != implied_.end()) return known->second;
  return implied_.emplace(key(reading), look_for_modes_that_imply(reading)).first->second;
}

/// Choices of modes are looked at one by one; each that leaves the reading open, or does not allow it, rules out all
/// that agree with it on what that rests on.
bool OpenReadings::look_for_modes_that_imply(Assignment reading) {
  if (implied_by(Modes(plant_.components.size()), reading)) return true;
  OptimalSearch::Costs costs;
  for (const automata::Component& component : plant_.components) costs.emplace_back(component.modes.size(), 0.0);
  OptimalSearch search(costs);
  search.set_budget(most_choices);
  const auto outcome = search.next([&](std::span<const std::uint32_t> choice) -> std::optional<Conflict> {
    const Modes modes(choice.begin(), choice.end());
    std::vector<Assignment> store = assignments_of(plant_, modes);
    store.push_back(reading);
    Conflict conflict;
    const auto rule_out = [&](ComponentId c) { conflict.push_back({c.value, choice[c.index()]}); };
    if (!step_.theory().consistent(store)) {
      look_at_plant();
      for (const Assignment& needed : step_.theory().conflict()) {
        if (const auto component = owner_[needed.variable.index()]) rule_out(*component);
      }
    } else {
      const std::vector<ComponentId>* rests_on = components(modes, reading);
      if (rests_on == nullptr) return std::nullopt;
      for (const ComponentId c : *rests_on) rule_out(c);
    }
    std::sort(conflict.begin(), conflict.end());
    return conflict;
  });
  return outcome != OptimalSearch::Outcome::exhausted;
}

OpenReadings::Patch OpenReadings::patch(std::vector<Attribute> inside, const Modes& modes) const {
  Patch patch;
  patch.inside = std::move(inside);
  for (const Attribute a : patch.inside) {
    for (const std::uint32_t t : readers_[a]) {
      const Told& told = told_[t];
      // Even a constraint that is not in force: whether it is depends on the mode.
      patch.components.insert(patch.components.end(), told.components.begin(), told.components.end());
      const bool in_force =
          !told.under || modes[owner_[told.under->variable.index()]->index()].index() == told.under->value.index();
      if (in_force) patch.told.push_back(t);
    }
  }
  sort_unique(patch.told);
  sort_unique(patch.components);
  for (const std::uint32_t t : patch.told) {
    for (const Attribute a : told_[t].attributes) {
      if (std::find(patch.inside.begin(), patch.inside.end(), a) == patch.inside.end()) patch.border.push_back(a);
    }
  }
  sort_unique(patch.border);
  return patch;
}

OpenReadings::Lemma OpenReadings::work_out(const Modes& modes, Assignment reading) {
  Lemma lemma{{}, {}, false};
  if (openings().opened_by(modes, reading, lemma.components)) {
    lemma.open = true;
  } else if (!leaves_open(modes, reading)) {
    lemma.components.clear();
    if (possible_) implied_.insert_or_assign(key(reading), true);
    for (const Assignment& needed : step_.theory().conflict()) {
      lemma.components.push_back(*owner_[needed.variable.index()]);
    }
  } else if (auto patch = open_patch(modes, reading)) {
    lemma.open = true;
    lemma.components = std::move(patch->components);
  } else {
    for (std::size_t c = 0; c < modes.size(); ++c) lemma.components.emplace_back(c);
  }
  for (const ComponentId c : lemma.components) lemma.modes.push_back(modes[c.index()]);
  return lemma;
}

/// Whether the store of the modes allows another value. Many readings are asked about under the same modes on end, and
/// one question to the theory serves them as long as nobody else asks one.
bool OpenReadings::leaves_open(const Modes& modes, Assignment reading) {
  automata::Theory& theory = step_.theory();
  if (theory.questions() != questions_ || modes != told_modes_) {
    store_ = assignments_of(plant_, modes);
    told_modes_ = modes;
    possible_ = theory.consistent(store_);
    questions_ = theory.questions();
  }
  return possible_ && theory.leaves_open(store_, reading);
}

bool OpenReadings::implied_by(const Modes& modes, Assignment reading) {
  return !leaves_open(modes, reading) && possible_;
}

/// Of a reading that is open, if that shows within the limits.
std::optional<OpenReadings::Patch> OpenReadings::open_patch(const Modes& modes, Assignment reading) {
  modes_ = &modes;
  read_ = equal_[reading.variable.index()];
  seen_ = reading.value;
  work_ = most_work;
  Patch now = patch({read_}, modes);
  Finding finding = judge(now);
  while (finding == Finding::implied) {
    const std::vector<Attribute> rests_on = blame(now);
    if (rests_on.empty() || work_ == 0) return std::nullopt;
    // To spoil the counterexample one of them is enough: the one that brings in the fewest others.
    std::optional<Patch> next;
    for (const Attribute a : rests_on) {
      std::vector<Attribute> inside = now.inside;
      inside.push_back(a);
      Patch larger = patch(std::move(inside), modes);
      if (!next || larger.border.size() < next->border.size()) next = std::move(larger);
    }
    now = std::move(*next);
    finding = judge(now);
  }
  if (finding == Finding::unknown) return std::nullopt;
  for (std::size_t i = 1; i < now.inside.size();) {
    std::vector<Attribute> less = now.inside;
    less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
    Patch smaller = patch(std::move(less), modes);
    if (judge(smaller) == Finding::open) {
      now = std::move(smaller);
    } else {
      ++i;
    }
  }
  return now;
}

OpenReadings::Finding OpenReadings::judge(const Patch& patch) {
  for (const Attribute a : patch.border) value_[a].reset();
  prepare(patch, patch.inside);
  const bool open = every_border(patch, 0);
  if (work_ == 0) return Finding::unknown;
  return open ? Finding::open : Finding::implied;
}

bool OpenReadings::every_border(const Patch& patch, std::size_t depth) {
  if (depth == patch.border.size()) return solvable(true) || !solvable(false);
  const Attribute a = patch.border[depth];
  const std::size_t values = plant_.variables[VariableId(a)].values.size();
  for (std::size_t v = 0; v < values; ++v) {
    value_[a] = ValueId(v);
    if (!every_border(patch, depth + 1)) return false;  // the border keeps the values of the counterexample
    if (work_ == 0) return false;
  }
  value_[a].reset();
  return true;
}

std::vector<OpenReadings::Attribute> OpenReadings::blame(const Patch& patch) {
  std::vector<Attribute> rests_on = patch.border;
  std::vector<Attribute> free = patch.inside;
  for (std::size_t i = 0; i < rests_on.size();) {
    const auto value = value_[rests_on[i]];
    free.push_back(rests_on[i]);
    prepare(patch, free);
    if (solvable(true)) {
      value_[rests_on[i]] = value;
      free.pop_back();
      ++i;
    } else {
      rests_on.erase(rests_on.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  return rests_on;
}

void OpenReadings::prepare(const Patch& patch, const std::vector<Attribute>& free) {
  order_ = free;
  due_.assign(order_.size() + 1, {});
  for (const Attribute a : order_) value_[a].reset();
  for (const std::uint32_t t : patch.told) {
    std::size_t depth = 0;
    for (const Attribute a : told_[t].attributes) {
      const auto at = std::find(order_.begin(), order_.end(), a);
      if (at != order_.end()) depth = std::max(depth, static_cast<std::size_t>(at - order_.begin()) + 1);
    }
    due_[depth].push_back(t);
  }
}

bool OpenReadings::solvable(bool other) {
  other_ = other;
  const bool result = assign(0);
  for (const Attribute a : order_) value_[a].reset();
  return result;
}

/// What is due holds, and the attributes from `depth` on can be assigned.
bool OpenReadings::assign(std::size_t depth) {
  const std::function<ValueId(VariableId)> value_of = [this](VariableId v) {
    if (const auto component = owner_[v.index()]) return ValueId((*modes_)[component->index()].index());
    return *value_[equal_[v.index()]];
  };
  for (const std::uint32_t t : due_[depth]) {
    if (!evaluate(told_[t].formula, value_of)) return false;
  }
  if (depth == order_.size()) return true;
  const Attribute a = order_[depth];
  const std::size_t values = plant_.variables[VariableId(a)].values.size();
  for (std::size_t v = 0; v < values; ++v) {
    if (other_ && a == read_ && ValueId(v) == seen_) continue;
    if (work_ == 0) return false;
    --work_;
    value_[a] = ValueId(v);
    if (assign(depth + 1)) return true;
  }
  value_[a].reset();
  return false;
}

}  // namespace rmpl::runtime
