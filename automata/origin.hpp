// Where in the source something came from; carried into the automata so that run-time reports can name lines.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace rmpl::automata {

/// A place in a source file. `line` and `column` count from 1; line 0 means that there is no source.
struct Origin {
  std::string file;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  bool operator==(const Origin&) const = default;
};

/// `file:line:column`.
std::string to_text(const Origin& origin);

/// ` (file:line:column)`, to stand behind what came from there; nothing where there is no source.
std::string in_brackets(const Origin& origin);

}  // namespace rmpl::automata
