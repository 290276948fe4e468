// Ranks: probabilities as powers of ten, compared as whole numbers (Kurien & Nayak 2000; Livingstone2).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/estimate/combination.hpp"

namespace rmpl::runtime {

/// The exponent of the nearest power of ten, without its sign; 0 for a probability near 1.
std::uint64_t rank_of(double probability);

/// Each probability becomes 10 to the minus of its rank.
void rank(std::vector<automata::Move>& moves);
void rank(std::vector<std::vector<automata::Move>>& moves);

/// Writes the probabilities of a belief in order anew as powers of ten, that of the best as 1; by how many powers the
/// best was below 1. Each combination has one clock.
std::uint64_t count_from_best(Combinations& belief);

}  // namespace rmpl::runtime
