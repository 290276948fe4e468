// Commands for reward come to an end (semantics 5, *No thrashing*).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <unordered_map>

#include "automata/state.hpp"
#include "base/function_ref.hpp"
#include "runtime/reasoning/reconfigure/course.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

/// What is done for reward: all that is worth more; what stays worth more whatever goes on by itself; nothing.
enum class For : std::uint8_t { rewards, lasting_rewards, nothing };

/// What was answered to one goal, by state.
struct Answered {
  For reward = For::rewards;
  Reconfiguration answer;
  bool weighed = false;  ///< what it comes to in the end has been looked at
};
using Answers = std::unordered_map<automata::Modes, Answered, automata::ModesHash>;

/// Adds the answer in a state, and those along the ways that things may go from there: the goal state is chosen anew in
/// every state, by what is best from there, so that choices that are equally good, or that do not last, could lead in a
/// circle. Where they do less is done for reward, until none does. Follows up to 256 steps.
void settle(const automata::Modes& modes, Course& course, Answers& answers,
            base::FunctionRef<Reconfiguration(const automata::Modes&, For)> answer);

}  // namespace rmpl::runtime
