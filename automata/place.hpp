// Places in a source as people read them in a story: the file as it was named, and the line.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/origin.hpp"

namespace rmpl::automata {

/// `models/mars_edl.rmpl:41`.
std::string short_place(const Origin& origin);

/// ` (mars_edl.rmpl:41)`; empty where there is no source.
std::string in_parentheses(const Origin& origin);

}  // namespace rmpl::automata
