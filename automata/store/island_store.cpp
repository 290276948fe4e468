// One island of the store.
// SPDX-License-Identifier: MIT
#include "automata/store/island_store.hpp"

#include <algorithm>

#include "automata/store/totality.hpp"
#include "base/check.hpp"

namespace rmpl::automata {

IslandStore::IslandStore(const Plant& plant, const Island& island)
    : plant_(&plant),
      island_(&island),
      excludes_(!is_total(plant, island)),
      possible_(plant, {island.support.components, {}}),
      verdicts_(plant, island.support),
      factors_(plant, {island.support.components, {}}) {
  const auto& components = island.support.components;
  if (components.size() <= 1) by_mode_.resize(components.empty() ? 1 : plant[components.front()].modes.size());
}

std::size_t IslandStore::watch(const Formula& formula) {
  CHECK(!theory_);
  const auto known = std::find(watched_.begin(), watched_.end(), formula);
  if (known != watched_.end()) return static_cast<std::size_t>(known - watched_.begin());
  watched_.push_back(formula);
  return watched_.size() - 1;
}

VariableId IslandStore::own(VariableId variable) const {
  const auto& components = island_->support.components;
  const auto& attributes = island_->attributes;
  const auto at = std::lower_bound(attributes.begin(), attributes.end(), variable);
  if (at != attributes.end() && *at == variable) {
    return VariableId(components.size() + static_cast<std::size_t>(at - attributes.begin()));
  }
  const auto component =
      std::find_if(components.begin(), components.end(), [&](ComponentId c) { return (*plant_)[c].mode == variable; });
  CHECK(component != components.end() && "an island knows what its constraints read");
  return VariableId(static_cast<std::size_t>(component - components.begin()));
}

Theory& IslandStore::theory() {
  if (theory_) return *theory_;
  Variables variables;
  for (const ComponentId c : island_->support.components) variables.add(plant_->variables[(*plant_)[c].mode]);
  for (const VariableId v : island_->attributes) variables.add(plant_->variables[v]);
  const auto translated = [this](const Formula& formula) {
    return renamed(
        formula, [this](VariableId v) { return own(v); }, [](VariableId, ValueId value) { return value; });
  };
  theory_.emplace(variables, Theory::Upkeep::maintained);
  for (const Constraint& constraint : island_->constraints) {
    if (constraint.under) {
      theory_->tell_if({own(constraint.under->variable), constraint.under->value}, translated(constraint.formula));
    } else {
      theory_->tell(translated(constraint.formula));
    }
  }
  for (const Formula& formula : watched_) handles_.push_back(theory_->encode(translated(formula)));
  return *theory_;
}

std::vector<Assignment> IslandStore::assumptions(const Modes& modes) const {
  std::vector<Assignment> result;
  const auto& components = island_->support.components;
  result.reserve(components.size() + island_->support.controls.size() + readings_.size());
  for (std::size_t i = 0; i < components.size(); ++i) {
    result.push_back({VariableId(i), ValueId(modes[components[i].index()].index())});
  }
  return result;
}

std::vector<Assignment> IslandStore::assumptions(const Modes& modes, const ControlAction& action) const {
  std::vector<Assignment> result = assumptions(modes);
  for (const std::size_t i : island_->support.controls) {
    result.push_back({own(plant_->controls[i].variable), action[i]});
  }
  return result;
}

bool IslandStore::possible(const Modes& modes) {
  return possible_.find(modes, ControlAction{}, [&] { return theory().consistent(assumptions(modes)); });
}

std::vector<ComponentId> IslandStore::conflict(const Modes& modes) {
  [[maybe_unused]] const bool consistent = theory().consistent(assumptions(modes));
  CHECK(!consistent);
  std::vector<ComponentId> result;
  for (const Assignment& a : theory().minimal_conflict(theory().conflict())) {
    result.push_back(island_->support.components[a.variable.index()]);
  }
  return result;
}

IslandStore::Verdicts& IslandStore::verdicts(const Modes& modes, const ControlAction& action) {
  return verdicts_.find(modes, action, [&] {
    Theory& theory = this->theory();
    Verdicts result{theory.consistent(assumptions(modes, action)), {}};
    if (!result.consistent) return result;
    result.truths.reserve(handles_.size());
    for (const Theory::Handle handle : handles_) {
      result.truths.push_back(!theory.holds(handle)            ? Truth::refuted
                              : theory.known_to_follow(handle) ? Truth::implied
                                                               : Truth::open);
    }
    return result;
  });
}

bool IslandStore::implies(std::size_t watched, Verdicts& known, const Modes& modes, const ControlAction& action) {
  if (!known.consistent) return true;
  Truth& truth = known.truths[watched];
  if (truth == Truth::open) {
    const bool implied = theory().entails(assumptions(modes, action), handles_[watched]);
    truth = implied ? Truth::implied : Truth::refuted;
  }
  return truth == Truth::implied;
}

void IslandStore::observe(std::span<const Assignment> readings) {
  std::vector<Assignment> own_readings;
  for (const Assignment& reading : readings) own_readings.push_back({own(reading.variable), reading.value});
  if (own_readings == readings_) return;
  readings_ = std::move(own_readings);
  std::vector<std::uint64_t> key;
  key.reserve(readings_.size());
  for (const Assignment& reading : readings_) {
    key.push_back(std::uint64_t{reading.variable.value} << 32 | reading.value.value);
  }
  seen_ = seen_before_.find_or(key, [&] { return ++seen_so_far_; });
  std::fill(by_mode_.begin(), by_mode_.end(), std::nullopt);
}

double IslandStore::factor(const Modes& modes) {
  const auto ask = [&] { return factors_.find(modes, seen_, [&] { return weigh(modes); }); };
  if (by_mode_.empty()) return ask();
  const auto& components = island_->support.components;
  auto& known = by_mode_[components.empty() ? 0 : modes[components.front().index()].index()];
  if (!known || !base::caches_on()) known = ask();
  return *known;
}

/// Each model at hand shows some readings to be contingent, the first as many as it can; only for what all models so
/// far agree with is there a question. A reading that the store entails cannot contradict it: where all are, there is
/// no question at all.
double IslandStore::weigh(const Modes& modes) {
  Theory& theory = this->theory();
  const std::vector<Assignment> store = assumptions(modes);
  for (const Assignment& reading : readings_) theory.avoid(reading);
  if (!theory.consistent(store)) return 0;
  std::vector<Assignment> seen = assumptions(modes);
  std::vector<Assignment> open, contingent;
  for (const Assignment& reading : readings_) {
    if (theory.known_to_follow(reading)) continue;
    seen.push_back(reading);
    (theory.holds(reading) ? open : contingent).push_back(reading);
  }
  if (seen.size() == store.size()) return 1;
  if (!theory.consistent(seen)) return 0;
  for (std::size_t i = 0; i < open.size();) {
    if (!theory.allows_other(store, open[i])) {
      ++i;
      continue;
    }
    const auto told = std::stable_partition(open.begin() + static_cast<std::ptrdiff_t>(i), open.end(),
                                            [&](const Assignment& reading) { return theory.holds(reading); });
    contingent.insert(contingent.end(), told, open.end());
    open.erase(told, open.end());
  }
  std::sort(contingent.begin(), contingent.end());
  double factor = 1;
  for (const Assignment& reading : contingent) {
    const VariableId attribute = island_->attributes[reading.variable.index() - island_->support.components.size()];
    factor /= static_cast<double>(plant_->variables[attribute].values.size());
  }
  return factor;
}

Refutation IslandStore::refutation(const Modes& modes) {
  Refutation result;
  std::vector<Assignment> store = assumptions(modes);
  result.lasting = !theory().consistent(store);
  if (!result.lasting) {
    store.insert(store.end(), readings_.begin(), readings_.end());
    [[maybe_unused]] const bool consistent = theory().consistent(store);
    CHECK(!consistent);
  }
  const auto& components = island_->support.components;
  for (const Assignment& a : theory().conflict()) {
    if (a.variable.index() < components.size()) result.components.push_back(components[a.variable.index()]);
  }
  return result;
}

}  // namespace rmpl::automata
