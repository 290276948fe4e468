// The outline of a document.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/positions.hpp"

namespace rmpl::tools {
namespace {

/// The kinds of the protocol that are used here.
enum class SymbolKind {
  module = 2,
  klass = 5,
  property = 7,
  enumeration = 10,
  function = 12,
  variable = 13,
  object = 19,
  member = 22,
  event = 24
};

class Outline {
 public:
  explicit Outline(const grammar::SourceFile& source) : source_(source) {}

  Json run(const compiler::File& file) {
    if (file.plant) items(file.plant->items);
    if (file.program) items(file.program->items);
    if (file.scenarios) {
      for (const grammar::ScenarioDefinition& scenario : file.scenarios->scenarios)
        add(scenario.name.text, scenario.name.span, scenario.span, SymbolKind::event);
    }
    return std::move(symbols_);
  }

 private:
  Json& add(const std::string& name, grammar::Span span, grammar::Span whole, SymbolKind kind,
            const std::string& detail = {}) {
    // The protocol wants a name, and its place inside the whole.
    Json symbol = {{"name", name.empty() ? "?" : name}, {"kind", static_cast<int>(kind)}};
    if (!detail.empty()) symbol["detail"] = detail;
    const bool inside = whole.begin <= span.begin && span.end <= whole.end;
    symbol["range"] = range_of(source_, inside ? whole : span);
    symbol["selectionRange"] = range_of(source_, span);
    symbols_.push_back(std::move(symbol));
    return symbols_.back();
  }
  void all(const std::vector<grammar::Name>& names, grammar::Span whole, SymbolKind kind,
           const std::string& detail = {}) {
    for (const grammar::Name& name : names) add(name.text, name.span, whole, kind, detail);
  }
  void items(const auto& list) {
    for (const auto& item : list) std::visit([this](const auto& one) { this->item(one); }, item);
  }
  /// A symbol with those of its items below it.
  void nested(const grammar::Name& name, grammar::Span whole, SymbolKind kind, const auto& list) {
    Outline below(source_);
    below.items(list);
    add(name.text, name.span, whole, kind)["children"] = std::move(below.symbols_);
  }

  void item(const grammar::ComponentDefinition& c) { nested(c.name, c.span, SymbolKind::klass, c.items); }
  void item(const grammar::ModuleDefinition& m) { nested(m.name, m.span, SymbolKind::module, m.items); }
  void item(const grammar::Domain& d) { add(d.name.text, d.name.span, d.span, SymbolKind::enumeration); }
  void item(const grammar::AttributeDeclaration& a) { all(a.names, a.span, SymbolKind::property); }
  void item(const grammar::ModeDeclaration& m) {
    add(m.name.text, m.name.span, m.span, SymbolKind::member, m.fault ? "fault" : "mode");
  }
  void item(const grammar::InstanceDeclaration& i) { all(i.names, i.span, SymbolKind::object, i.type.text); }
  void item(const grammar::VariableDeclaration& v) { all(v.names, v.span, SymbolKind::variable); }
  void item(const grammar::Definition& d) { add(d.name.text, d.name.span, d.span, SymbolKind::function); }
  void item(const auto&) {}

  const grammar::SourceFile& source_;
  Json symbols_ = Json::array();
};

}  // namespace

Json document_symbols(Workspace& workspace, const Json& params) {
  const OpenDocument& document = workspace.documents().of(params);
  const Analysis* analysis = workspace.analysis_of(document);
  if (analysis == nullptr) return Json::array();
  const std::uint32_t file = *analysis->find(workspace.texts().identity(document.path));
  return Outline(analysis->sources()[file]).run(analysis->file(file));
}

}  // namespace rmpl::tools
