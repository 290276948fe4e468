// Monitors: a channel, what it means, and its settings, line by line.
// SPDX-License-Identifier: MIT
#include "compiler/format/monitor.hpp"

#include "compiler/format/syntax.hpp"

namespace rmpl::compiler {

void write(Document& document, const grammar::MonitorFile& file) {
  write_file(document, file.monitors, [&](const grammar::MonitorDefinition& monitor) {
    document.open_statement();
    document.take_to(monitor.attribute.span.end);
    write_block(document, monitor.items, [&](const grammar::MonitorItem& item) {
      document.open_statement();
      document.take_to(std::visit([](const auto& part) { return part.span.end; }, item));
      document.close_statement();
    });
    document.close_statement();
  });
}

}  // namespace rmpl::compiler
