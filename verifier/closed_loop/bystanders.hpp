// Bystanders: components that neither a program nor what is asked of it can tell from a plant without them.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/program.hpp"
#include "verifier/slice/slices.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

/// A plant without its bystanders, and the program bound to it.
struct Stage {
  Part part;
  automata::Program program;
};

/// What is left where bystanders leave: parts of the plant that no guard and no constraint connects with what the
/// program or a property reads, without controls and without rewards, each of which goes on by itself from each state
/// that it comes to. Every run of the rest is then one of the plant, with some run of theirs beside it; and what a
/// reconfigurer answers has nothing to do with them. Nothing where there are none. Throws LimitReached.
std::optional<Stage> without_bystanders(Slices& slices, const automata::Program& program,
                                        const std::vector<Property>& properties, const CheckOptions& options,
                                        Meter& meter);

/// The property in the terms of the part.
Property into(const Part& part, Property property);

}  // namespace rmpl::verifier
