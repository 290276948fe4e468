// Places of programs and models, as traces name them.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/origin.hpp"
#include "runtime/executive/trace/json_line.hpp"

namespace rmpl::runtime {

/// The keys `file` and `line`; nothing where there is no source.
void write_place(JsonLine& line, const automata::Origin& origin);

}  // namespace rmpl::runtime
