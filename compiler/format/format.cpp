// Formatting: parse, lay out, and see that it still is what it was.
// SPDX-License-Identifier: MIT
#include "compiler/format/format.hpp"

#include "base/check.hpp"
#include "compiler/format/document.hpp"
#include "compiler/format/layout.hpp"
#include "compiler/format/monitor.hpp"
#include "compiler/format/syntax.hpp"
#include "grammar/ast/same.hpp"
#include "grammar/parse/parse.hpp"
#include "grammar/parse/parse_monitors.hpp"

namespace rmpl::compiler {
namespace {

template <class Tree>
using Parser = grammar::Parse<Tree> (*)(const grammar::Sources&, std::uint32_t, grammar::Diagnostics&);

/// Whether a text that was laid out holds what it was made of.
template <class Tree>
bool holds(const std::string& text, const Tokens& tokens, const Tree& tree, Parser<Tree> parse) {
  grammar::Sources sources;
  grammar::Diagnostics diagnostics;
  const std::uint32_t file = sources.add("formatted", text);
  if (!Tokens(sources[file].text()).same(tokens)) return false;
  const grammar::Parse<Tree> again = parse(sources, file, diagnostics);
  return again.whole && grammar::same(again.tree, tree);
}

template <class Tree>
std::optional<std::string> format_as(const grammar::Sources& sources, std::uint32_t file,
                                     grammar::Diagnostics& diagnostics, Parser<Tree> parse) {
  const grammar::Parse<Tree> parsed = parse(sources, file, diagnostics);
  if (!parsed.whole) return std::nullopt;
  const Tokens tokens(sources[file].text());
  Document document(tokens);
  write(document, parsed.tree);
  std::string text = lay_out(document);
  if (text != sources[file].text()) {
    CHECK(holds(text, tokens, parsed.tree, parse) && "a layout keeps every token and every comment");
  }
  return text;
}

}  // namespace

std::optional<std::string> format(const grammar::Sources& sources, std::uint32_t file, Kind kind,
                                  grammar::Diagnostics& diagnostics) {
  switch (kind) {
    case Kind::program:
      return format_as<grammar::ProgramFile>(sources, file, diagnostics, grammar::parse_program);
    case Kind::plant:
      return format_as<grammar::PlantFile>(sources, file, diagnostics, grammar::parse_plant);
    case Kind::scenario:
      return format_as<grammar::ScenarioFile>(sources, file, diagnostics, grammar::parse_scenarios);
    case Kind::properties:
      return format_as<grammar::PropertyFile>(sources, file, diagnostics, grammar::parse_properties);
    case Kind::monitors:
      return format_as<grammar::MonitorFile>(sources, file, diagnostics, grammar::parse_monitors);
    case Kind::document:
      break;
  }
  CHECK(false && "a compiled document is in none of the five languages");
  return std::nullopt;
}

std::optional<std::string> format(std::string_view text, Kind kind) {
  grammar::Sources sources;
  grammar::Diagnostics diagnostics;
  return format(sources, sources.add("text", std::string(text)), kind, diagnostics);
}

}  // namespace rmpl::compiler
