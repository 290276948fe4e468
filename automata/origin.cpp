// Places in a source as text.
// SPDX-License-Identifier: MIT
#include "automata/origin.hpp"

namespace rmpl::automata {

std::string to_text(const Origin& origin) {
  return origin.file + ":" + std::to_string(origin.line) + ":" + std::to_string(origin.column);
}

std::string in_brackets(const Origin& origin) { return origin.line == 0 ? "" : " (" + to_text(origin) + ")"; }

}  // namespace rmpl::automata
