// Plant models: the parts of a component and of a module are tables.
// SPDX-License-Identifier: MIT
#include "base/overloaded.hpp"
#include "compiler/format/syntax.hpp"

namespace rmpl::compiler {
namespace {

void write(Document& document, const grammar::AttributeDeclaration& attribute) {
  document.open_statement(Table::attributes);
  document.take_keyword();
  write_names(document, attribute.names);
  document.take();
  write(document, attribute.domain);
  document.take_to(attribute.span.end);
  document.close_statement();
}

/// Up to the semicolon, which is part of it.
void write_initial(Document& document, const grammar::Initial& initial) {
  document.take();
  write_list(document, initial.modes);
  document.take_to(initial.span.end);
}

void write(Document& document, const grammar::Initial& initial) {
  document.open_statement();
  write_initial(document, initial);
  document.close_statement();
}

void write(Document& document, const grammar::ModeDeclaration& mode) {
  document.open_statement(Table::modes);
  document.take_keyword();
  document.take_to(mode.name.span.end);
  if (document.next() == "{") {
    document.stop();
    if (!take_empty_braces(document)) {
      write_in_braces(document, [&] { write(document, *mode.constraint); });
    }
  }
  document.take_to(mode.span.end);
  document.close_statement();
}

class TransitionWriter {
 public:
  TransitionWriter(Document& document, const grammar::TransitionText& text) : document_(document), text_(text) {}

  void write() {
    document_.open_statement(Table::transitions);
    write_sources();
    document_.take();  // the arrow
    if (text_.braced) {
      write_branched();
    } else {
      document_.take_to(text_.branches.front().target.span.end);
      if (text_.restart) document_.take();
      if (!is_list() && document_.next() != ";") document_.stop();
      write_conditions();
      if (document_.next() != ";") document_.line();
    }
    document_.take_to(text_.span.end);
    document_.close_statement();
  }

 private:
  [[nodiscard]] const grammar::NamedSources* named() const {
    return std::get_if<grammar::NamedSources>(&text_.sources.node);
  }
  /// Several modes are left: such a row gives the others no column.
  [[nodiscard]] bool is_list() const { return named() != nullptr && named()->modes.size() > 1; }

  void write_sources() {
    if (named() != nullptr) {
      write_list(document_, named()->modes);
    } else {
      document_.take_to(text_.sources.span.end);
    }
    if (!is_list()) document_.stop();
  }

  void write_branched() {
    if (document_.next() != "{") write_conditions();
    write_in_braces(document_, [&] { write_list(document_, text_.branches); });
    write_conditions();
  }

  /// Guard and timing, where they come next.
  void write_conditions() {
    if (text_.guard && document_.next_begin() < text_.guard->span.begin) {
      document_.line();
      document_.take();
      compiler::write(document_, *text_.guard);
    }
    if (text_.timing && document_.next_begin() <= text_.timing->span.begin) {
      document_.line();
      write_timing();
    }
  }

  /// `in [0 s, inf] ~ normal(10 s, 2 s)`: the parameters stand close to the name.
  void write_timing() {
    while (document_.next_begin() < text_.timing->span.end) {
      if (document_.next() == "(") document_.glue();
      document_.take();
    }
  }

  Document& document_;
  const grammar::TransitionText& text_;
};

void write(Document& document, const grammar::TransitionText& text) { TransitionWriter(document, text).write(); }

void write(Document& document, const grammar::InstanceDeclaration& instance) {
  document.open_statement(Table::instances);
  if (instance.progress) document.take();
  write_names(document, instance.names);
  document.take_to(instance.type.span.end);
  if (instance.initial) {
    write_in_braces(document, [&] { write_initial(document, *instance.initial); });
  }
  document.take_to(instance.span.end);
  document.close_statement();
}

void write(Document& document, const grammar::Interconnection& connection) {
  document.open_statement(Table::connections);
  write_connection(document, connection.constraint);
  document.take_to(connection.span.end);
  document.close_statement();
}

template <class Definition>
void write_definition(Document& document, const Definition& definition) {
  document.open_statement();
  document.take_to(definition.name.span.end);
  write_block(document, definition.items,
              [&](const auto& item) { std::visit([&](const auto& node) { write(document, node); }, item); });
  document.close_statement();
}

}  // namespace

void write(Document& document, const grammar::PlantFile& file) {
  const base::Overloaded write_item{
      [&](const grammar::ComponentDefinition& component) { write_definition(document, component); },
      [&](const grammar::ModuleDefinition& module) { write_definition(document, module); },
      [&](const auto& declaration) { write(document, declaration); }};
  write_file(document, file.items, [&](const grammar::PlantItem& item) { std::visit(write_item, item); });
}

}  // namespace rmpl::compiler
