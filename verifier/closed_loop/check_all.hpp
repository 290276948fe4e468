// Properties of a plant and of a program that controls it, at once: those that leave the same things free are decided
// together.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "verifier/slice/slices.hpp"
#include "verifier/verdict/answer.hpp"
#include "verifier/verdict/subject.hpp"

namespace rmpl::verifier {

/// The answers, in the order of the questions, each as if it were the only one. Limits are for all together. A question
/// about a program needs one in `subject`; `slices` are of its plant. Throws base::InputError as `check` does.
std::vector<Answer> check_all(const Subject& subject, Slices& slices, const std::vector<Question>& questions,
                              const Limits& limits);

}  // namespace rmpl::verifier
