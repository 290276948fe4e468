// The ways out of modes that chance takes at last: those of one step, as choices and joint choices tell them.
// SPDX-License-Identifier: MIT
#pragma once

#include "verifier/behaviour/joint_choices.hpp"
#include "verifier/search/lasso.hpp"

namespace rmpl::verifier {

/// Adds the next component, in `mode`: what it may do, without a fault and however late it is, tells what is enabled.
void add_enabled(Exits& exits, const std::vector<Choice>& choices, automata::ModeId mode);

/// Notes the exits that a joint step without a fault to a possible state takes, whatever the other clocks read.
void add_open(Exits& exits, const automata::Modes& from, const automata::Modes& to, const Box& bounds,
              const TimeModel& time);

}  // namespace rmpl::verifier
