// Places of programs and models, as traces and stories name them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/origin.hpp"
#include "runtime/executive/trace/json_line.hpp"

namespace rmpl::runtime {

/// The keys `file` and `line`; nothing where there is no source.
void write_place(JsonLine& line, const automata::Origin& origin);

/// ` (mars_edl.rmpl:41)`: the file without its folders; empty where there is no source.
std::string in_parentheses(const automata::Origin& origin);

}  // namespace rmpl::runtime
