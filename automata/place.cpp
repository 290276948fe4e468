// File and line.
// SPDX-License-Identifier: MIT
#include "automata/place.hpp"

namespace rmpl::automata {

std::string short_place(const Origin& origin) { return origin.file + ":" + std::to_string(origin.line); }

std::string in_parentheses(const Origin& origin) { return origin.line == 0 ? "" : " (" + short_place(origin) + ")"; }

}  // namespace rmpl::automata
