// The outline of a document, and of all together.
// SPDX-License-Identifier: MIT
#include <set>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "grammar/parse/parse.hpp"
#include "grammar/parse/parse_monitors.hpp"
#include "tools/rmplc/server/everywhere.hpp"
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
    if (file.monitors) {
      for (const grammar::MonitorDefinition& monitor : file.monitors->monitors)
        add(monitor.channel.text, monitor.channel.span, monitor.span, SymbolKind::property, monitor.attribute.text);
    }
    if (file.properties) {
      for (const grammar::PropertyDefinition& property : file.properties->properties)
        add(property.name.text, property.name.span, property.span, SymbolKind::event);
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

/// A file by itself: nothing that it names is read.
Json outline_of(const std::string& path, std::string text) {
  grammar::Sources sources;
  grammar::Diagnostics diagnostics;
  compiler::File file;
  file.index = sources.add(path, std::move(text));
  file.kind = compiler::kind_by_name(path).value_or(compiler::Kind::document);
  switch (file.kind) {
    case compiler::Kind::program:
      file.program = grammar::parse_program(sources, file.index, diagnostics).tree;
      break;
    case compiler::Kind::plant:
      file.plant = grammar::parse_plant(sources, file.index, diagnostics).tree;
      break;
    case compiler::Kind::scenario:
      file.scenarios = grammar::parse_scenarios(sources, file.index, diagnostics).tree;
      break;
    case compiler::Kind::properties:
      file.properties = grammar::parse_properties(sources, file.index, diagnostics).tree;
      break;
    case compiler::Kind::monitors:
      file.monitors = grammar::parse_monitors(sources, file.index, diagnostics).tree;
      break;
    case compiler::Kind::document:
      break;
  }
  return Outline(sources[file.index]).run(file);
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Whether the characters of the query stand in the name, in their order, whatever their case.
bool answers(std::string_view name, std::string_view query) {
  std::size_t at = 0;
  for (const char c : name) {
    if (at < query.size() && lower(c) == lower(query[at])) ++at;
  }
  return at == query.size();
}

/// Adds the symbols of an outline that answer a query, with what they stand in.
void add_answers(const Json& outline, const std::string& uri, const std::string& container, const std::string& query,
                 Json& found) {
  constexpr std::size_t most = 500;
  for (const Json& symbol : outline) {
    if (found.size() >= most) return;
    const std::string& name = symbol["name"].get_ref<const std::string&>();
    if (answers(name, query)) {
      found.push_back({{"name", name},
                       {"kind", symbol["kind"]},
                       {"containerName", container},
                       {"location", {{"uri", uri}, {"range", symbol["selectionRange"]}}}});
    }
    if (symbol.contains("children")) add_answers(symbol["children"], uri, name, query, found);
  }
}

}  // namespace

Json workspace_symbols(Workspace& workspace, const Json& params) {
  const std::string query = text_member(params, "query");
  std::set<std::string> paths = sources_below(workspace.roots());
  for (const auto& [uri, document] : workspace.documents().all()) paths.insert(document.path);
  Json found = Json::array();
  for (const std::string& path : paths) {
    try {
      const std::string uri = workspace.documents().uri_of(path);
      add_answers(outline_of(path, workspace.texts().read(path)), uri, "", query, found);
    } catch (const base::InputError&) {
      continue;  // what cannot be read declares nothing
    }
  }
  return found;
}

Json document_symbols(Workspace& workspace, const Json& params) {
  const OpenDocument& document = workspace.documents().of(params);
  const Analysis* analysis = workspace.analysis_of(document);
  if (analysis == nullptr) return Json::array();
  const std::uint32_t file = *analysis->find(workspace.texts().identity(document.path));
  return Outline(analysis->sources()[file]).run(analysis->file(file));
}

}  // namespace rmpl::tools
