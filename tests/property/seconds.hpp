// Plants as engineers draw them, part by part, and how they go on from second to second.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "automata/step/plant_step.hpp"

namespace rmpl::property {

constexpr std::int64_t most_seconds = 5;

/// Bounds of a second at least, `most_seconds` at most, that are not one. Only where single draws are allowed.
automata::Timing some_seconds();

automata::Transition move(std::size_t from, std::size_t to, automata::Formula guard,
                          std::optional<automata::Timing> timing = {});

/// A component with these modes, the first of them initial, a reward on one of them now and then. The reference lasts
/// until the next one is added.
automata::Component& add_part(automata::Plant& plant, const std::string& name, const std::vector<std::string>& modes);

/// Modes, and for how many whole seconds each has been there, at most `most_seconds`.
struct Moment {
  automata::Modes modes;
  std::vector<std::int64_t> seconds;

  friend auto operator<=>(const Moment&, const Moment&) = default;
};

/// Every component in its first mode, since now.
Moment at_rest(const automata::Plant& plant);

/// One cycle of a second: each component takes what needs no time at once, what is timed after its upper bound.
void go_on(automata::PlantStep& step, Moment& moment, const automata::ControlAction& action);

}  // namespace rmpl::property
