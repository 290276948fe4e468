// "did you mean": the nearest of a list of names.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rmpl::automata {

/// `; did you mean 'engine'?` for the candidate with the fewest insertions, deletions, substitutions and swaps of
/// neighbours, at most a third of the name's length (at least one) and never all of it; the first of equals. Empty
/// where none is near.
std::string suggestion(std::string_view name, const std::vector<std::string_view>& candidates);

}  // namespace rmpl::automata
