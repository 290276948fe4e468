// File and line.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/place.hpp"

#include <filesystem>

namespace rmpl::runtime {

void write_place(JsonLine& line, const automata::Origin& origin) {
  if (origin.line > 0) line.key("file").string(origin.file).key("line").number(origin.line);
}

std::string in_parentheses(const automata::Origin& origin) {
  if (origin.line == 0) return {};
  return " (" + std::filesystem::path(origin.file).filename().string() + ":" + std::to_string(origin.line) + ")";
}

}  // namespace rmpl::runtime
