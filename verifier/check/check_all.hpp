// Several properties at once: what is free in the same way is explored together.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "verifier/slice/slices.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

/// Positions of the questions that are explored together: those with the same cone of influence, asked under the same
/// options. Responses, fastest witnesses and entailed formulas (a disjunction may be entailed where no part is) are
/// alone. In the order of their first.
std::vector<std::vector<std::size_t>> explored_together(Slices& slices, const std::vector<Question>& questions);

/// The answers, in the order of the questions: verdicts, and how many steps witnesses have, are those of `check` for
/// each by itself (where several have fewest steps, it may be another one). Limits are for all together; each search is
/// held to what the ones before it have left.
///
/// What is explored together is looked for as one, the disjunction. A search that ends without a witness has decided
/// all of them; one that finds a state decides those that hold there: no target can be reached in fewer steps. What is
/// left is looked for again. So all that cannot be reached costs one search, and each of the others costs one that ends
/// at its witness.
std::vector<Answer> check_all(Slices& slices, const std::vector<Question>& questions, const Limits& limits);

}  // namespace rmpl::verifier
