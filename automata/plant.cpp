// The plant model: look-ups.
// SPDX-License-Identifier: MIT
#include "automata/plant.hpp"

#include <algorithm>
#include <cmath>

namespace rmpl::automata {

double Weight::fault_probability(Ticks step) const {
  switch (kind) {
    case Kind::none:
      return 0;
    case Kind::probability:
      return value;
    case Kind::rate:
      return -std::expm1(-value * step.seconds());
  }
  return 0;
}

std::optional<ComponentId> Plant::find_component(std::string_view component) const {
  const auto at =
      std::find_if(components.begin(), components.end(), [&](const auto& c) { return c.name == component; });
  if (at == components.end()) return std::nullopt;
  return ComponentId(static_cast<std::size_t>(at - components.begin()));
}

std::optional<ComponentId> Plant::component_of(VariableId variable) const {
  const auto at = std::find_if(components.begin(), components.end(), [&](const auto& c) { return c.mode == variable; });
  if (at == components.end()) return std::nullopt;
  return ComponentId(static_cast<std::size_t>(at - components.begin()));
}

bool Plant::has_timed_exit(ComponentId component, ModeId mode) const {
  const auto& transitions = (*this)[component].transitions;
  return std::any_of(transitions.begin(), transitions.end(),
                     [&](const Transition& t) { return t.from == mode && t.timing.has_value(); });
}

}  // namespace rmpl::automata
