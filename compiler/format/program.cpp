// Control programs: blocks step by step, and steps that stay on a line where they can.
// SPDX-License-Identifier: MIT
#include "base/overloaded.hpp"
#include "compiler/format/syntax.hpp"

namespace rmpl::compiler {
namespace {

using grammar::Step;

/// Whether the last token of a step is the brace of a block: what belongs to the step then stands beside it.
bool ends_in_block(const Step& step) {
  return std::visit(
      base::Overloaded{
          [](const grammar::Block&) { return true; }, [](const grammar::Choose&) { return true; },
          [](const grammar::If& node) { return ends_in_block(node.otherwise ? **node.otherwise : *node.step); },
          [](const grammar::Unless& node) { return ends_in_block(*node.step); },
          [](const grammar::When& node) { return ends_in_block(*node.step); },
          [](const grammar::Whenever& node) { return ends_in_block(*node.step); },
          [](const grammar::Nothing&) { return true; }, [](const grammar::Each&) { return true; },
          [](const grammar::Repeat& node) { return ends_in_block(*node.step); },
          [](const grammar::Always& node) { return ends_in_block(*node.step); },
          [](const grammar::Next& node) { return ends_in_block(*node.step); }, [](const auto&) { return false; }},
      step.node);
}

class StepWriter {
 public:
  explicit StepWriter(Document& document) : document_(document) {}

  void write(const Step& step) {
    std::visit([&](const auto& node) { write(node); }, step.node);
  }

  void write(const grammar::Goal& goal) { compiler::write(document_, goal.constraint); }

  void write(const grammar::ClockStart&) {
    for (std::size_t token = 0; token < 3; ++token) document_.take();
  }

  void write(const grammar::Call& call) {
    document_.take_to(call.definition.span.end);
    document_.glue();
    document_.take();
    if (!call.arguments.empty()) {
      write_list(document_, call.arguments, [&](const grammar::Argument& argument) { this->argument(argument); });
    }
    document_.take();
  }

  void write(const grammar::Block& block) { compiler::write(document_, block.body); }

  void write(const grammar::Nothing&) { take_empty_braces(document_); }
  void write(const grammar::Each& node) {
    document_.take();
    compiler::write(document_, node.body);
  }

  void write(const grammar::Watching& node) { ended(*node.step, node.condition, true); }
  void write(const grammar::Maintaining& node) { ended(*node.step, node.condition, node.with_do); }

  void write(const grammar::If& node) {
    document_.open(Breaks::all, Margin::outer);
    condition(node.condition);
    behind_keyword(*node.step);
    if (node.otherwise) {
      if (!ends_in_block(*node.step)) document_.line();
      document_.take();
      behind_keyword(**node.otherwise);
    }
    document_.close();
  }

  void write(const grammar::Unless& node) { conditional(node); }
  void write(const grammar::When& node) { conditional(node); }
  void write(const grammar::Whenever& node) { conditional(node); }

  void write(const grammar::Always& node) {
    document_.take();
    write(*node.step);
  }
  void write(const grammar::Repeat& node) {
    document_.take();
    write(*node.step);
  }
  void write(const grammar::Next& node) {
    document_.take();
    write(*node.step);
  }

  void write(const grammar::Choose& node) {
    document_.take();
    document_.take();
    document_.open(Breaks::all, Margin::nested);
    for (const grammar::Choice& choice : node.choices) {
      document_.line();
      write(choice.step);
      document_.take_to(choice.span.end);
      if (document_.next() == ",") document_.take();
    }
    document_.line();
    document_.close();
    document_.take();
  }

 private:
  void argument(const grammar::Argument& argument) {
    std::visit(base::Overloaded{[&](const grammar::Name& name) { document_.take_to(name.span.end); },
                                [&](const grammar::Constraint& one) { compiler::write(document_, one); }},
               argument.node);
  }

  /// `if c thennext`, `when c donext`: the second word stands on a line of its own where the condition takes several.
  void condition(const grammar::Constraint& condition) {
    document_.open(Breaks::all, Margin::outer);
    document_.take();
    compiler::write(document_, condition);
    document_.line();
    document_.take();
    document_.close();
  }

  /// The step that a keyword is followed by: a block beside it, another one beside it or a line further in.
  void behind_keyword(const Step& step) {
    if (document_.next() == "{") return write(step);
    document_.open(Breaks::needed, Margin::nested);
    document_.line();
    write(step);
    document_.close();
  }

  template <class Node>
  void conditional(const Node& node) {
    condition(node.condition);
    behind_keyword(*node.step);
  }

  /// `do A watching c`, `A maintaining c`.
  void ended(const Step& step, const grammar::Constraint& condition, bool with_do) {
    document_.open(Breaks::needed, Margin::nested);
    if (with_do) document_.take();
    write(step);
    if (!ends_in_block(step)) document_.line();
    document_.take();
    compiler::write(document_, condition);
    document_.close();
  }

  Document& document_;
};

void write(Document& document, const grammar::VariableDeclaration& variable) {
  document.open_statement(Table::attributes);
  document.take_keyword();
  write_names(document, variable.names);
  document.take();
  write(document, variable.domain);
  document.take_to(variable.span.end);
  document.close_statement();
}

void write(Document& document, const grammar::StandingConstraint& standing) {
  document.open_statement();
  document.take();
  write(document, standing.constraint);
  document.take_to(standing.span.end);
  document.close_statement();
}

void write(Document& document, const grammar::Definition& definition) {
  document.open_statement();
  document.take_to(definition.name.span.end);
  document.glue();
  document.take();
  if (!definition.parameters.empty()) write_list(document, definition.parameters);
  document.take();  // the parenthesis
  document.take();  // ::
  write(document, definition.body);
  document.close_statement();
}

/// `clock t, u;` at the start of a definition. A goal on a thing called `clock` is no such thing: no name follows it.
void write_clocks(Document& document, std::uint32_t body) {
  while (document.next_begin() < body) {
    document.hard_line();
    document.open_statement();
    document.take();
    document.open(Breaks::needed, Margin::aligned);
    while (document.next() != ";") {
      document.take();
      if (document.next() != "," && document.next() != ";") document.line();
    }
    document.close();
    document.take();
    document.close_statement();
  }
}

}  // namespace

void write(Document& document, const grammar::Body& body) {
  StepWriter steps(document);
  document.take();
  document.open(Breaks::all, Margin::nested);
  document.enter_block();
  write_clocks(document, body.span.begin);
  for (const grammar::Sequence& thread : body.threads) {
    for (const Step& step : thread.steps) {
      document.hard_line();
      document.open_statement();
      steps.write(step);
      document.close_statement();
      if (document.next() != "}") document.take();
    }
  }
  document.hard_line();
  document.leave_block();
  document.close();
  document.take();
}

void write(Document& document, const grammar::ProgramFile& file) {
  write_file(document, file.items, [&](const grammar::ProgramItem& item) {
    std::visit([&](const auto& node) { write(document, node); }, item);
  });
}

}  // namespace rmpl::compiler
