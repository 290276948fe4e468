// Finding a declaration: down the tree, by places.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/declaration.hpp"

#include <algorithm>

#include "base/overloaded.hpp"

namespace rmpl::tools {
namespace {

bool holds(grammar::Span outer, grammar::Span inner) {
  return outer.file == inner.file && outer.begin <= inner.begin && inner.end <= outer.end;
}

/// Goes to the item that the name stands in.
class Finding {
 public:
  explicit Finding(grammar::Span name) : name_(name) {}

  Declaration run(const compiler::File& file) {
    if (file.plant) items(file.plant->items);
    if (file.program) items(file.program->items);
    if (file.monitors) {
      for (const auto& monitor : file.monitors->monitors)
        if (enter(monitor.span)) found_.monitor = &monitor;
    }
    if (file.scenarios) {
      for (const auto& scenario : file.scenarios->scenarios)
        if (enter(scenario.span)) found_.scenario = &scenario;
    }
    return found_;
  }

 private:
  bool enter(grammar::Span span) {
    if (!holds(span, name_)) return false;
    found_.statement = span;
    return true;
  }
  void items(const auto& list) {
    for (const auto& item : list)
      std::visit(
          [this](const auto& one) {
            if (enter(one.span)) add(one);
          },
          item);
  }
  void add(const grammar::ComponentDefinition& component) {
    found_.component = &component;
    items(component.items);
  }
  void add(const grammar::ModuleDefinition& module) {
    found_.module = &module;
    items(module.items);
  }
  void add(const grammar::AttributeDeclaration& attribute) { found_.attribute = &attribute; }
  void add(const grammar::ModeDeclaration& mode) { found_.mode = &mode; }
  void add(const grammar::InstanceDeclaration& instance) { found_.instance = &instance; }
  void add(const grammar::Domain& domain) { found_.domain = &domain; }
  void add(const grammar::VariableDeclaration& variable) { found_.variable = &variable; }
  void add(const grammar::Definition& definition) { found_.definition = &definition; }
  void add(const auto&) {}

  grammar::Span name_;
  Declaration found_;
};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

}  // namespace

Declaration find_declaration(const compiler::File& file, grammar::Span name) { return Finding(name).run(file); }

std::string comment_above(const grammar::SourceFile& source, grammar::Span statement) {
  std::uint32_t first = source.place(statement.begin).line;
  const std::uint32_t own = first;
  while (first > 1 && trimmed(source.line(first - 1)).starts_with("//")) --first;
  std::string text;
  for (std::uint32_t line = first; line < own; ++line) {
    const std::string_view comment = trimmed(trimmed(source.line(line)).substr(2));
    if (comment.starts_with("SPDX")) {
      text.clear();
      continue;
    }
    if (!text.empty()) text += '\n';
    text += comment;
  }
  while (text.starts_with('\n')) text.erase(0, 1);
  return text;
}

}  // namespace rmpl::tools
