// A stretch of source text: which file, and from which byte to which.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace rmpl::grammar {

/// Bytes [begin, end) of the file with index `file` in a `Sources`. Empty where begin = end: a place between two bytes.
struct Span {
  std::uint32_t file = 0;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  auto operator<=>(const Span&) const = default;
};

/// From the start of `first` to the end of `last`, both of one file.
constexpr Span join(Span first, Span last) { return {first.file, first.begin, last.end}; }

}  // namespace rmpl::grammar
