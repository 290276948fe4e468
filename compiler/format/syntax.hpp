// The syntax of the four languages as streams: where lines may break, what belongs together, what stands in columns.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "compiler/format/document.hpp"
#include "grammar/ast/plant.hpp"
#include "grammar/ast/program.hpp"
#include "grammar/ast/property.hpp"
#include "grammar/ast/scenario.hpp"

namespace rmpl::compiler {

// Each takes the tokens of what it is given, of whole files with the end of the text.

void write(Document& document, const grammar::ProgramFile& file);
void write(Document& document, const grammar::PlantFile& file);
void write(Document& document, const grammar::ScenarioFile& file);
void write(Document& document, const grammar::PropertyFile& file);

void write(Document& document, const grammar::Constraint& constraint);
/// A row of connections: where it is an implication or an equivalence, its arrow is a column.
void write_connection(Document& document, const grammar::Constraint& constraint);

void write(Document& document, const grammar::Import& import);
void write(Document& document, const grammar::Domain& domain);
void write(Document& document, const grammar::Observe& observe);
void write(Document& document, const grammar::Control& control);
/// The names before the colon, which of one name is a column.
void write_names(Document& document, const std::vector<grammar::Name>& names);
void write(Document& document, const grammar::DomainRef& domain);
void write(Document& document, const grammar::Body& body);

/// All elements up to the last token of the last one, with the commas between them; lines break where they must, and
/// start below the first one.
template <class Element, class Write>
void write_list(Document& document, const std::vector<Element>& elements, Write write_element) {
  document.open(Breaks::needed, Margin::aligned);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    write_element(elements[i]);
    if (i + 1 == elements.size()) break;
    document.take();
    document.line();
  }
  document.close();
}

/// Elements that are a few tokens with a place.
template <class Element>
void write_list(Document& document, const std::vector<Element>& elements) {
  write_list(document, elements, [&](const Element& one) { document.take_to(one.span.end); });
}

/// What stands between the braces that come next, and the braces: on their line, or else a line further in.
template <class Write>
void write_in_braces(Document& document, Write write_content) {
  document.take();
  document.open(Breaks::all, Margin::nested);
  document.line();
  write_content();
  document.line();
  document.close();
  document.take();
}

/// `{}`, if that comes next.
bool take_empty_braces(Document& document);

/// Statements between the braces that come next, each on its line.
template <class Item, class Write>
void write_block(Document& document, const std::vector<Item>& items, Write write_item) {
  if (take_empty_braces(document)) return;
  document.take();
  document.open(Breaks::all, Margin::nested);
  document.enter_block();
  for (const Item& item : items) {
    document.hard_line();
    write_item(item);
  }
  document.hard_line();
  document.leave_block();
  document.close();
  document.take();
}

/// The items of a file, and the end of the text.
template <class Item, class Write>
void write_file(Document& document, const std::vector<Item>& items, Write write_item) {
  for (const Item& item : items) {
    document.hard_line();
    write_item(item);
  }
  document.hard_line();
  document.take();
}

}  // namespace rmpl::compiler
