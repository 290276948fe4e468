// Nogoods: modes that cannot be together.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/nogoods.hpp"

#include <algorithm>

namespace rmpl::verifier {

using automata::ComponentId;
using automata::Modes;

namespace {

/// So many are learnt; those of one mode are looked through one by one.
constexpr std::size_t most_nogoods = 1u << 14;

}  // namespace

Nogoods::Nogoods(automata::PlantStep& step) : step_(step) {
  for (const automata::Component& component : step.plant().components) known_.emplace_back(component.modes.size());
}

bool Nogoods::possible(const Modes& modes) {
  if (step_.possible(modes)) return true;
  if (learnt_ == most_nogoods) return false;
  ++learnt_;
  Nogood nogood;
  for (const ComponentId c : step_.conflict(modes)) nogood.emplace_back(c, modes[c.index()]);
  for (const auto& [component, mode] : nogood) {
    auto& known = known_[component.index()][mode.index()];
    Nogood rest = nogood;
    std::erase(rest, std::pair(component, mode));
    known.push_back(std::move(rest));
  }
  return false;
}

bool Nogoods::refutes(const PartialModes& partial, ComponentId component) const {
  const auto& known = known_[component.index()][partial.modes[component.index()].index()];
  return std::any_of(known.begin(), known.end(), [&](const Nogood& nogood) {
    return std::all_of(nogood.begin(), nogood.end(), [&](const auto& premise) {
      const std::size_t c = premise.first.index();
      return partial.decided[c] && partial.modes[c] == premise.second;
    });
  });
}

}  // namespace rmpl::verifier
