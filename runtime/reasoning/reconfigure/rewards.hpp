// The rewards of a plant's modes as whole numbers, so that sums are compared as the decimals written.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "automata/plant.hpp"

namespace rmpl::runtime {

/// Per component, per mode: the reward in units of a power of ten that makes all of them whole. A reward written with
/// so many digits that the sums would not fit into 53 bits together with what is counted beside them is rounded to the
/// finest unit that does.
using WholeRewards = std::vector<std::vector<std::int64_t>>;
WholeRewards whole_rewards(const automata::Plant& plant);

}  // namespace rmpl::runtime
