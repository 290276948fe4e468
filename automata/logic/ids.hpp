// Strong indices: one type per kind of thing, so that a mode is never taken for a value.
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace rmpl::automata {

/// An index into a vector of `Tag`s. `value` is the position, from 0.
template <class Tag>
struct Id {
  std::uint32_t value = 0;
  constexpr Id() = default;
  constexpr explicit Id(std::size_t position) : value(static_cast<std::uint32_t>(position)) {}
  [[nodiscard]] constexpr std::size_t index() const { return value; }
  auto operator<=>(const Id&) const = default;
};

using VariableId = Id<struct VariableTag>;      ///< position in a `Variables` table
using ValueId = Id<struct ValueTag>;            ///< position in a variable's domain; of a mode variable: the mode
using ComponentId = Id<struct ComponentTag>;    ///< position in `Plant::components`
using ModeId = Id<struct ModeTag>;              ///< position in `Component::modes`
using TransitionId = Id<struct TransitionTag>;  ///< position in `Component::transitions`
using ClockId = Id<struct ClockTag>;            ///< position in `Program::clocks`
using LocationId = Id<struct LocationTag>;      ///< position in `Program::locations`; printed as position + 1

}  // namespace rmpl::automata

template <class Tag>
struct std::hash<rmpl::automata::Id<Tag>> {
  std::size_t operator()(const rmpl::automata::Id<Tag>& id) const noexcept {
    return std::hash<std::uint32_t>{}(id.value);
  }
};
