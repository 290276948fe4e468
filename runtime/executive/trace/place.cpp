// File and line.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/place.hpp"

namespace rmpl::runtime {

void write_place(JsonLine& line, const automata::Origin& origin) {
  if (origin.line > 0) line.key("file").string(origin.file).key("line").number(origin.line);
}

}  // namespace rmpl::runtime
