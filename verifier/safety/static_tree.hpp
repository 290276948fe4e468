// A plant without dynamics as a fault tree: components that fail by themselves, and a formula of which have failed.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "automata/plant.hpp"
#include "verifier/property/fault.hpp"
#include "verifier/safety/decision_diagram.hpp"

namespace rmpl::verifier {

/// A basic event: a component fails, whatever all others do.
struct BasicEvent {
  Fault fault;
  automata::ModeId from;
  automata::Weight weight;  ///< of its transition
  bool once = false;        ///< it is drawn in the first step alone
  bool from_start = false;  ///< it is drawn before that
};

/// Which components have failed makes the formula true.
struct StaticTree {
  std::vector<BasicEvent> events;        ///< in the order in which the formula meets them
  std::vector<std::uint32_t> variables;  ///< by event: the variable of the diagram that it is
  NodeId top = Diagrams::zero;
  bool monotone = true;  ///< no more failures make it false
};

/// The tree of a formula, where the plant is one: each component that the formula depends on starts in one mode and can
/// leave it for one fault mode, at a rate or with a probability, for ever, or for modes that nothing leaves, or starts
/// in a nominal or a fault mode that nothing leaves; no guards, no time bounds, no constraints in modes; and each
/// constraint of the plant defines an attribute of two values by modes and others, without loops. Nothing otherwise.
/// Throws LimitReached.
std::optional<StaticTree> static_tree(const automata::Plant& plant, const automata::Formula& formula,
                                      Diagrams& diagrams);

/// The probability that an event has happened by then, from the start; none: ever. In steps of a period, or in dense
/// time, where a probability per step is drawn once or not at all.
Enclosure chance_of(const BasicEvent& event, std::optional<automata::Ticks> within,
                    std::optional<automata::Ticks> period);

}  // namespace rmpl::verifier
