// Where the parts of trees begin and end.
// SPDX-License-Identifier: MIT
#include "compiler/lint/places.hpp"

#include <algorithm>
#include <variant>

#include "base/utf8.hpp"

namespace rmpl::compiler {

using grammar::Span;

namespace {

/// Collects the spans of all that automata can have come from.
class Collector {
 public:
  explicit Collector(std::vector<Span>& parts) : parts_(parts) {}

  void run(const File& file) {
    if (file.plant) items(file.plant->items);
    if (file.program) items(file.program->items);
    if (file.scenarios) all(file.scenarios->scenarios);
    if (file.properties) all(file.properties->properties);
  }

 private:
  void keep(Span span) { parts_.push_back(span); }
  void items(const auto& list) {
    for (const auto& item : list) std::visit([this](const auto& one) { this->add(one); }, item);
  }
  void all(const auto& definitions) {
    for (const auto& definition : definitions) {
      keep(definition.span);
      keep(definition.name.span);
      for (const auto& item : definition.items) {
        std::visit([this](const auto& one) { this->keep(one.span); }, item);
      }
    }
  }

  void add(const auto& other) { keep(other.span); }
  void add(const grammar::ModeDeclaration& mode) {
    keep(mode.span);
    keep(mode.name.span);
  }
  void add(const grammar::AttributeDeclaration& attribute) {
    keep(attribute.span);
    for (const grammar::Name& name : attribute.names) keep(name.span);
  }
  void add(const grammar::InstanceDeclaration& instance) {
    keep(instance.span);
    for (const grammar::Name& name : instance.names) keep(name.span);
  }
  void add(const grammar::ComponentDefinition& component) {
    keep(component.name.span);
    items(component.items);
  }
  void add(const grammar::ModuleDefinition& module) {
    keep(module.name.span);
    items(module.items);
  }
  void add(const grammar::Definition& definition) {
    keep(definition.name.span);
    body(definition.body);
  }
  void body(const grammar::Body& body) {
    keep(body.span);
    for (const grammar::Sequence& thread : body.threads) {
      for (const grammar::Step& step : thread.steps) this->step(step);
    }
  }
  void step(const grammar::Step& step) {
    keep(step.span);
    std::visit([this](const auto& node) { inside(node); }, step.node);
  }
  void inside(const grammar::Goal&) {}
  void inside(const grammar::ClockStart&) {}
  void inside(const grammar::Call&) {}
  void inside(const grammar::Nothing&) {}
  void inside(const grammar::Each& each) { body(each.body); }
  void inside(const grammar::Block& block) { body(block.body); }
  void inside(const grammar::If& node) {
    step(*node.step);
    if (node.otherwise) step(**node.otherwise);
  }
  void inside(const grammar::Choose& choose) {
    for (const grammar::Choice& choice : choose.choices) step(choice.step);
  }
  void inside(const auto& node) { step(*node.step); }

  std::vector<Span>& parts_;
};

/// The byte of a column, counted from 1 in code points, of a line.
std::uint32_t offset_of(const grammar::SourceFile& file, const automata::Origin& origin) {
  const std::string_view line = file.line(origin.line);
  std::size_t byte = 0;
  for (std::uint32_t column = 1; column < origin.column && byte < line.size(); ++column) {
    byte += std::max<std::size_t>(1, base::code_point_length(line.substr(byte)));
  }
  return file.line_start(origin.line) + static_cast<std::uint32_t>(byte);
}

}  // namespace

Places::Places(const grammar::Sources& sources, std::span<const File> files) : sources_(sources) {
  Collector collector(parts_);
  for (const File& file : files) {
    if (file.kind == Kind::document) continue;
    files_.emplace(sources[file.index].name(), file.index);
    collector.run(file);
  }
  std::sort(parts_.begin(), parts_.end());
}

Span Places::at(const automata::Origin& origin) const {
  const auto known = files_.find(origin.file);
  if (known == files_.end()) return {};
  const grammar::SourceFile& file = sources_[known->second];
  if (origin.line == 0 || origin.line > file.line_count()) return {known->second, 0, 0};
  const std::uint32_t begin = offset_of(file, origin);
  const auto part = std::upper_bound(parts_.begin(), parts_.end(), Span{known->second, begin, begin});
  if (part == parts_.end() || part->file != known->second || part->begin != begin) return {known->second, begin, begin};
  return *part;
}

}  // namespace rmpl::compiler
