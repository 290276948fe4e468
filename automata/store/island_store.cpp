// One island of the store.
// SPDX-License-Identifier: MIT
#include "automata/store/island_store.hpp"

#include <algorithm>

#include "automata/store/totality.hpp"
#include "base/check.hpp"

namespace rmpl::automata {

IslandStore::IslandStore(const Plant& plant, const PlantIndex& index, const Island& island)
    : theory_(plant, island), factors_(plant, {island.support.components, {}}) {
  if (!is_total(plant, island)) possible_.emplace(plant, index, island, Locality::Commanded::no);
  const auto& components = island.support.components;
  if (components.size() <= 1) by_mode_.resize(components.empty() ? 1 : plant[components.front()].modes.size());
}

bool IslandStore::possible(const Modes& modes) {
  if (!possible_) return true;
  return possible_->find(modes, ControlAction{}, [&] { return theory_().consistent(theory_.assumptions(modes)); });
}

std::vector<ComponentId> IslandStore::conflict(const Modes& modes) {
  if (!conflicts_) conflicts_.emplace(theory_.plant(), Support{theory_.island().support.components, {}});
  return conflicts_->find(modes, ControlAction{}, [&] {
    [[maybe_unused]] const bool consistent = theory_().consistent(theory_.assumptions(modes));
    CHECK(!consistent);
    std::vector<ComponentId> result;
    for (const Assignment& a : theory_().minimal_conflict(theory_().conflict())) {
      result.push_back(theory_.island().support.components[a.variable.index()]);
    }
    return result;
  });
}

void IslandStore::observe(std::span<const Assignment> readings) {
  std::vector<Assignment> own_readings;
  for (const Assignment& reading : readings)
    own_readings.push_back({theory_.own(reading.variable).value(), reading.value});
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
  const auto& components = theory_.island().support.components;
  auto& known = by_mode_[components.empty() ? 0 : modes[components.front().index()].index()];
  if (!known || !base::caches_on()) known = ask();
  return *known;
}

/// Each model at hand shows some readings to be contingent, the first as many as it can; only for what all models so
/// far agree with is there a question. A reading that the store entails cannot contradict it: where all are, there is
/// no question at all.
double IslandStore::weigh(const Modes& modes) {
  Theory& theory = theory_();
  const std::vector<Assignment> store = theory_.assumptions(modes);
  for (const Assignment& reading : readings_) theory.avoid(reading);
  if (!theory.consistent(store)) return 0;
  std::vector<Assignment> seen = theory_.assumptions(modes);
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
    const VariableId attribute =
        theory_.island().attributes[reading.variable.index() - theory_.island().support.components.size()];
    factor /= static_cast<double>(theory_.plant().variables[attribute].values.size());
  }
  return factor;
}

Refutation IslandStore::refutation(const Modes& modes) {
  Refutation result;
  std::vector<Assignment> store = theory_.assumptions(modes);
  result.lasting = !theory_().consistent(store);
  if (!result.lasting) {
    store.insert(store.end(), readings_.begin(), readings_.end());
    [[maybe_unused]] const bool consistent = theory_().consistent(store);
    CHECK(!consistent);
  }
  const auto& components = theory_.island().support.components;
  for (const Assignment& a : theory_().conflict()) {
    if (a.variable.index() < components.size()) result.components.push_back(components[a.variable.index()]);
  }
  return result;
}

}  // namespace rmpl::automata
