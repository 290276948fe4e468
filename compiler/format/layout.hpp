// From the stream to the text.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "compiler/format/document.hpp"

namespace rmpl::compiler {

/// The text of a document with all its tokens, in lines of `line_width` where they can be.
std::string lay_out(Document& document);

}  // namespace rmpl::compiler
