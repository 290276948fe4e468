// How an update of a window counts.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/state.hpp"

namespace rmpl::runtime {

/// With its readings, but for those that no history explains; or no state goes on, and every one stays as it was.
struct Counted {
  automata::Observation set_aside;
  bool stands = false;
  bool operator==(const Counted&) const = default;

  /// How many readings do not count, out of `all`.
  [[nodiscard]] std::size_t left_out(const automata::Observation& all) const {
    return stands ? all.size() : set_aside.size();
  }
};

}  // namespace rmpl::runtime
