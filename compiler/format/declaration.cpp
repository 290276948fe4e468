// Declarations that several languages share.
// SPDX-License-Identifier: MIT
#include "base/overloaded.hpp"
#include "compiler/format/syntax.hpp"

namespace rmpl::compiler {
namespace {

void write_values(Document& document, const grammar::Values& values) {
  write_in_braces(document, [&] { write_list(document, values.names); });
}

}  // namespace

bool take_empty_braces(Document& document) {
  if (document.next() != "{" || document.behind_next() != "}") return false;
  document.take();
  const bool commented = document.has_comments_before_next();
  if (commented) {
    document.open(Breaks::all, Margin::nested);
    document.hard_line();
    document.close();
  } else {
    document.glue();
  }
  document.take();
  return true;
}

void write_names(Document& document, const std::vector<grammar::Name>& names) {
  write_list(document, names);
  if (names.size() == 1) document.stop();
}

void write(Document& document, const grammar::DomainRef& domain) {
  std::visit(base::Overloaded{[&](const grammar::Name& name) { document.take_to(name.span.end); },
                              [&](const grammar::Values& values) { write_values(document, values); }},
             domain);
}

void write(Document& document, const grammar::Import& import) {
  document.open_statement();
  document.take_to(import.span.end);
  document.close_statement();
}

void write(Document& document, const grammar::Domain& domain) {
  document.open_statement(Table::domains);
  document.take_to(domain.name.span.end);
  document.stop();
  document.take();
  write_values(document, domain.values);
  document.take_to(domain.span.end);
  document.close_statement();
}

void write(Document& document, const grammar::Observe& observe) {
  document.open_statement();
  document.take();
  write_list(document, observe.names);
  document.take_to(observe.span.end);
  document.close_statement();
}

void write(Document& document, const grammar::Control& control) {
  document.open_statement(Table::controls);
  document.take();
  write_list(document, control.names);
  if (control.idle) {
    if (control.names.size() == 1) document.stop();
    document.line();
  }
  document.take_to(control.span.end);
  document.close_statement();
}

}  // namespace rmpl::compiler
