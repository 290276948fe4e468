// What is wrong with a netlist, bounded.
// SPDX-License-Identifier: MIT
#include "compiler/import/netlist.hpp"

namespace rmpl::compiler {

grammar::Diagnostic* NetlistErrors::report(grammar::Code code, grammar::Span span, std::string message) {
  if (too_many()) return nullptr;
  ++count_;
  if (!too_many()) return &diagnostics_.error(code, span, std::move(message));
  diagnostics_.error(grammar::Code::too_many_errors, span, "too many errors: the rest of the netlist was not read");
  return nullptr;
}

}  // namespace rmpl::compiler
