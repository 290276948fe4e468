// What the steps out of a state depend on where no clock matters: a key to remember them by.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "automata/state.hpp"
#include "automata/time/time.hpp"

namespace rmpl::runtime {

struct SourceKey {
  automata::Modes modes;
  automata::ControlAction action;
  automata::Ticks step;
  bool operator==(const SourceKey&) const = default;
};

struct SourceKeyHash {
  std::size_t operator()(const SourceKey& key) const noexcept {
    std::size_t hash = automata::ModesHash{}(key.modes);
    const auto combine = [&hash](std::size_t value) { hash = (hash ^ value) * 0x100000001b3u; };
    for (const automata::ValueId value : key.action) combine(value.value);
    combine(static_cast<std::size_t>(key.step.count));
    return hash ^ (hash >> 32);
  }
};

}  // namespace rmpl::runtime
