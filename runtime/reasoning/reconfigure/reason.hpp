// Why a command is given, why the plant is waited for, why there is no plan: as data, and in words.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "automata/logic/formula.hpp"
#include "automata/plant.hpp"

namespace rmpl::runtime {

/// A transition of a component of the plant.
struct TransitionOf {
  automata::ComponentId component;
  automata::TransitionId transition;
  bool operator==(const TransitionOf&) const = default;
};

/// The reason of one answer of a reconfigurer. Small, and a function of the question: it can be kept with every answer.
struct Reason {
  /// What the answer serves.
  enum class Purpose : std::uint8_t {
    none,    ///< there is nothing to do
    goal,    ///< `conjunct`
    reward,  ///< the goal is entailed, or waits for something else: housekeeping
    model    ///< all controls idle would contradict the model
  };
  /// With no plan: what bars the way.
  enum class Obstacle : std::uint8_t {
    none,
    missing,      ///< no nominal transitions lead `component` to `aim`
    forbidden,    ///< `step` would lead on, cannot be undone, and is on no way to a mode that the goal names
    unsupported,  ///< `step` would lead on, and nothing brings its guard about
    side_effect,  ///< what brings `step` about undoes what is achieved, or takes or risks a forbidden step
    excluded,     ///< the modes that are left exclude the goal, or each other
    not_found     ///< the search was given up, or went in a circle, or `step` is overtaken by what takes no time
  };
  Purpose purpose = Purpose::none;
  Obstacle obstacle = Obstacle::none;
  /// Which conjunct of the goal is not achieved yet, by its position in `conjuncts_of(goal)`; with `Purpose::goal`.
  std::optional<std::uint32_t> conjunct = std::nullopt;
  /// The component on whose way the answer lies, and the mode that it is to come to.
  std::optional<automata::ComponentId> component = std::nullopt;
  std::optional<automata::ModeId> aim = std::nullopt;
  /// The next step of that way, of `component` or of one that it depends on: what the command brings about, what is
  /// waited for, or what is barred.
  std::optional<TransitionOf> step = std::nullopt;
  /// Of a command or a wait: all others were looked at (semantics 5, "Groups").
  bool proved_best = true;
  bool operator==(const Reason&) const = default;
};

/// Where the model states what the reason is about: the step's transition, else the component's aim; line 0 where there
/// is no such place.
automata::Origin origin_of(const automata::Plant& plant, const Reason& reason);

/// In words, as part of a sentence: `for engine = firing: 'pde' goes from 'off' to 'on' (propulsion.tcca:40)`; empty
/// where there is nothing to do. `goal` is the one that was asked.
std::string to_text(const Reason& reason, const automata::Plant& plant, const automata::Formula& goal);

/// With an obstacle: what in the model or in the goal would permit a plan, in words; else empty.
std::string remedy(const Reason& reason, const automata::Plant& plant);

}  // namespace rmpl::runtime
