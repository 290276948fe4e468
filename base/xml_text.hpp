// Text from outside in XML 1.0, which has no way to write most control characters: a name must not break a document.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rmpl::base {

/// The text with control characters but the end of a line as in `printable`, and likewise, byte by byte, what is no
/// UTF-8 or no character of XML.
std::string xml_text(std::string_view text);

}  // namespace rmpl::base
