// Markings that nothing tells apart: what they tell is the same, now and in all that follows.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "automata/phca.hpp"
#include "automata/software/threads.hpp"

namespace rmpl::automata {

/// Leaves one of the markings of a thread that are in the same definitions, tell the same and, under the same
/// conditions, lead to like ones by draws of the same probability and rarity: the first of them. By marking that stays,
/// all that it stands for, in their order.
std::vector<std::vector<Marking>> merge_like(const ModelProgram& program, Thread& thread);

}  // namespace rmpl::automata
