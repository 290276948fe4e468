// The nearest name to a misspelled one, for "did you mean".
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rmpl::base {

/// The number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b` (optimal string
/// alignment), or `limit + 1` where it is more than `limit`. O(|a| |b|).
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

/// The candidate nearest to `name` that is within a third of its length (at least one edit), as clang judges typing
/// errors; the first of equals; nothing where none is near. A candidate that differs in case only always counts.
std::optional<std::string> nearest(std::string_view name, const std::vector<std::string_view>& candidates);
std::optional<std::string> nearest(std::string_view name, const std::vector<std::string>& candidates);

/// `; did you mean 'engine'?` for the nearest candidate, to end a message with; empty where none is near.
std::string suggestion(std::string_view name, const std::vector<std::string_view>& candidates);
std::string suggestion(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace rmpl::base
