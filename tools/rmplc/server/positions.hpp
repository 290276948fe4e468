// Places as the protocol has them: line and UTF-16 unit, both from 0; and bytes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "grammar/source/source_file.hpp"
#include "tools/rmplc/server/message.hpp"

namespace rmpl::tools {

/// A byte offset as {line, character}.
Json position_of(const grammar::SourceFile& source, std::uint32_t offset);
/// Bytes [begin, end) as {start, end}.
Json range_of(const grammar::SourceFile& source, std::uint32_t begin, std::uint32_t end);
inline Json range_of(const grammar::SourceFile& source, grammar::Span span) {
  return range_of(source, span.begin, span.end);
}
/// The byte of {line, character}; beyond the end of a line or of the text, that end. Throws RpcError where it is none.
std::uint32_t offset_of(const grammar::SourceFile& source, const Json& position);

}  // namespace rmpl::tools
