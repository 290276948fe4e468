// The nearest name to a misspelled one, for "did you mean".
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rmpl::grammar {

/// The number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b` (optimal string
/// alignment), or `limit + 1` where it is more than `limit`. O(|a| |b|).
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

/// The candidate nearest to `name` that is within a third of its length (at least one edit), as clang judges typing
/// errors; the first of equals; nothing where none is near. A candidate that differs in case only always counts.
std::optional<std::string> nearest(std::string_view name, std::span<const std::string> candidates);

}  // namespace rmpl::grammar
