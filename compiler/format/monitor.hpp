// Monitors in the one style.
// SPDX-License-Identifier: MIT
#pragma once

#include "compiler/format/document.hpp"
#include "grammar/ast/monitor.hpp"

namespace rmpl::compiler {

/// Takes the tokens of a whole file, with the end of the text.
void write(Document& document, const grammar::MonitorFile& file);

}  // namespace rmpl::compiler
