// How wide the parts of a stream are on one line.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/format/document.hpp"

namespace rmpl::compiler {

/// Of every event, and of the end behind them. Widths are in columns, as on one line.
struct Measures {
  std::vector<std::uint32_t> before;  ///< the width of all that stands before the event
  std::vector<std::uint32_t> ahead;   ///< from the event to the next place where a line may break
  std::vector<std::uint32_t> hard;    ///< the first hard line at or behind the event; the number of events: none

  /// The width from one event to another.
  [[nodiscard]] std::uint32_t between(std::uint32_t from, std::uint32_t to) const { return before[to] - before[from]; }
};

Measures measure(const Document& document);

/// The comments that stand on the line of a token, before it: all of those before it, or where a hard line does so,
/// those that the text has there.
std::span<const Comment> comments_beside(const Tokens& tokens, std::size_t token, bool behind_hard_line);

/// Gives the rows of tables their columns: pads of tokens. A row that would then be too long, or breaks anyway, stands
/// as it is. `measures` are those without pads.
void align_tables(Document& document, const Measures& measures);

}  // namespace rmpl::compiler
