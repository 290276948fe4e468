// SPDX-License-Identifier: MIT
#include "automata/store/commanded_island.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::automata {

CommandedIsland::CommandedIsland(const Plant& plant, const PlantIndex& index, const Island& island, bool excludes)
    : theory_(plant, island), verdicts_(plant, island.support) {
  if (excludes) consistent_.emplace(plant, index, island, Locality::Commanded::yes);
}

bool CommandedIsland::consistent(const Modes& modes, const ControlAction& action) {
  if (!consistent_) return true;
  return consistent_->find(modes, action, [&] { return theory_().consistent(theory_.assumptions(modes, action)); });
}

CommandedIsland::Verdicts& CommandedIsland::verdicts(const Modes& modes, const ControlAction& action) {
  return verdicts_.find(modes, action, [&] {
    Theory& theory = theory_();
    Verdicts result{theory.consistent(theory_.assumptions(modes, action)), {}};
    if (!result.consistent) return result;
    result.truths.reserve(theory_.watched().size());
    for (const Theory::Handle handle : theory_.watched()) {
      result.truths.push_back(!theory.holds(handle)            ? Truth::refuted
                              : theory.known_to_follow(handle) ? Truth::implied
                                                               : Truth::open);
    }
    return result;
  });
}

bool CommandedIsland::implies(std::size_t watched, Verdicts& known, const Modes& modes, const ControlAction& action) {
  if (!known.consistent) return true;
  Truth& truth = known.truths[watched];
  if (truth == Truth::open) {
    const bool implied = theory_().entails(theory_.assumptions(modes, action), theory_.watched()[watched]);
    truth = implied ? Truth::implied : Truth::refuted;
  }
  return truth == Truth::implied;
}

std::optional<Reason> CommandedIsland::reason(std::size_t watched, const Modes& modes, const ControlAction& action,
                                              const std::vector<ComponentId>& unknown) {
  Theory& theory = theory_();
  const auto& components = theory_.island().support.components;
  std::vector<Assignment> assumed = theory_.assumptions(modes, action);
  std::erase_if(assumed, [&](const Assignment& a) {
    return a.variable.index() < components.size() &&
           std::binary_search(unknown.begin(), unknown.end(), components[a.variable.index()]);
  });
  const Theory::Handle handle = theory_.watched()[watched];
  const bool implied = theory.entails(assumed, handle);
  if (!implied && theory.allows(assumed, handle)) return std::nullopt;
  Reason result{implied, {}};
  for (const Assignment& a : theory.conflict()) {
    result.assumptions.push_back({theory_.of_plant(a.variable), a.value});
  }
  return result;
}

std::optional<bool> CommandedIsland::decided(std::size_t watched, std::span<const Assignment> assumptions) {
  Theory& theory = theory_();
  std::vector<Assignment> assumed;
  for (const Assignment& a : assumptions) {
    if (const auto own = theory_.own(a.variable)) assumed.push_back({*own, a.value});
  }
  if (assumed.empty()) return std::nullopt;
  [[maybe_unused]] const bool consistent = theory.consistent(assumed);
  CHECK(consistent && "what contradicts itself enables everything");
  const Theory::Handle handle = theory_.watched()[watched];
  if (theory.known_to_follow(handle)) return true;
  if (theory.known_to_fail(handle)) return false;
  return std::nullopt;
}

}  // namespace rmpl::automata
