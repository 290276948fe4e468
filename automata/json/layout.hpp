// JSON for people to read: what fits into a line stands on one.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/json/parse.hpp"

namespace rmpl::automata {

/// The text of a value: objects and arrays that fit into a line of 120 characters stand on one, others have a member or
/// an item a line, indented by two. No newline at the end.
std::string laid_out(const Json& json);

}  // namespace rmpl::automata
