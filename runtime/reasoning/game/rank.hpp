// How sure a strategy is (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace rmpl::runtime {

/// How sure a strategy is to reach its target.
enum class Rank : std::uint8_t {
  sure,   ///< on every run
  fair,   ///< on every run on which nature's branches come up some day
  hoped,  ///< on some run
  none
};

}  // namespace rmpl::runtime
