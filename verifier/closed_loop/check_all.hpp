// Properties of a plant and of a program that controls it, at once: those that leave the same things free are decided
// together.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "verifier/slice/slices.hpp"
#include "verifier/verdict/answer.hpp"
#include "verifier/verdict/subject.hpp"

namespace rmpl::verifier {

/// The answers, in the order of the questions, each as if it were the only one. A question about a program needs one in
/// `subject`; `slices` are of its plant. Throws base::InputError as `check` does.
///
/// Searches are by turns, so that none starves another: each first gets a short time, those that are left ten times as
/// much, and so on. `limits.time` is for all together: where what is left of it does not suffice for the next turn,
/// those that are left share it evenly, and what one does not use the others get. Turns begin anew, which costs a tenth
/// more; what comes of a search is the same in any turn. `limits.states` is for each search.
///
/// So many `threads` take turns at once, with slices of their own but for the first. Answers do not depend on their
/// number, but for what a limit of time or memory leaves undecided, and what a search is told to have cost.
std::vector<Answer> check_all(const Subject& subject, Slices& slices, const std::vector<Question>& questions,
                              const Limits& limits, std::size_t threads = 1);

}  // namespace rmpl::verifier
