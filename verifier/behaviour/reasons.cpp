// Reasons.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/reasons.hpp"

#include <algorithm>
#include <utility>

#include "automata/controls.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::ComponentId;
using automata::ControlAction;
using automata::Modes;
using Part = automata::ConstraintStore::Part;

namespace {

/// Why a guard is implied, or cannot hold, beside what is assumed already. Nothing where neither is so.
std::optional<std::vector<Assignment>> reason_of(automata::ConstraintStore& store, const std::vector<Part>& guard,
                                                 const Modes& modes, const ControlAction& action,
                                                 const std::vector<ComponentId>& unknown,
                                                 const std::vector<Assignment>& assumed) {
  std::vector<Assignment> all;
  bool open = false;
  for (const Part& part : guard) {
    // What decides one guard mostly decides others as well.
    if (const auto decided = store.decided(part, assumed)) {
      if (!*decided) return std::vector<Assignment>();
      continue;
    }
    auto why = store.reason(part, modes, action, unknown);
    if (!why) {
      open = true;
    } else if (!why->implied) {
      return std::move(why->assumptions);
    } else {
      all.insert(all.end(), why->assumptions.begin(), why->assumptions.end());
    }
  }
  return open ? std::nullopt : std::optional(std::move(all));
}

}  // namespace

std::optional<std::vector<Premise>> reason(automata::PlantStep& step, ComponentId component, const Modes& modes,
                                           const ControlAction& action, const std::vector<ComponentId>& unknown) {
  const automata::Plant& plant = step.plant();
  std::vector<Assignment> all;
  for (const automata::PlantStep::Exit& exit : step.exits(component, modes[component.index()])) {
    const auto why = reason_of(step.store(), exit.parts, modes, action, unknown, all);
    if (!why) return std::nullopt;
    all.insert(all.end(), why->begin(), why->end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }

  // Controls first: what a command is not meant for is mostly decided by that alone.
  std::vector<Premise> result;
  std::vector<Premise> others;
  for (const Assignment& a : all) {
    if (const auto c = plant.component_of(a.variable)) {
      // Its own mode is what the answers are filed under.
      if (*c != component) others.push_back({c->value, a.value.value});
      continue;
    }
    const std::size_t position = plant.components.size() + *automata::control_of(plant, a.variable);
    result.push_back({static_cast<std::uint32_t>(position), a.value.value});
  }
  result.insert(result.end(), others.begin(), others.end());
  return result;
}

}  // namespace rmpl::verifier
