// Places to and from bytes, by the line table of the source.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/positions.hpp"

namespace rmpl::tools {

Json position_of(const grammar::SourceFile& source, std::uint32_t offset) {
  const grammar::Place place = source.place_utf16(offset);
  return {{"line", place.line - 1}, {"character", place.column - 1}};
}

Json range_of(const grammar::SourceFile& source, std::uint32_t begin, std::uint32_t end) {
  return {{"start", position_of(source, begin)}, {"end", position_of(source, end)}};
}

std::uint32_t offset_of(const grammar::SourceFile& source, const Json& position) {
  return source.offset_utf16({number_member(position, "line") + 1, number_member(position, "character") + 1});
}

}  // namespace rmpl::tools
