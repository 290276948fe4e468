// The text shown for a name: its declaration, its values, the transitions into a mode and out of it.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <functional>

#include "grammar/source/codes.hpp"
#include "tools/rmplc/server/declaration.hpp"
#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/mentions.hpp"
#include "tools/rmplc/server/positions.hpp"

namespace rmpl::tools {
namespace {

using compiler::NameKind;

/// A stretch of source on one line.
std::string on_one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == ' ' || (c >= '\t' && c <= '\r');
    if (!blank)
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  return line;
}

bool names(const std::vector<grammar::Name>& list, std::string_view name) {
  return std::any_of(list.begin(), list.end(), [&](const grammar::Name& one) { return one.text == name; });
}

bool leaves(const grammar::TransitionText& transition, const grammar::ModeDeclaration& mode) {
  if (const auto* named = std::get_if<grammar::NamedSources>(&transition.sources.node))
    return names(named->modes, mode.name.text);
  const bool only_target =
      std::all_of(transition.branches.begin(), transition.branches.end(),
                  [&](const grammar::Branch& branch) { return branch.target.text == mode.name.text; });
  return !only_target && !(std::get<grammar::AnySource>(transition.sources.node).nominal && mode.fault);
}

bool enters(const grammar::TransitionText& transition, const grammar::ModeDeclaration& mode) {
  return std::any_of(transition.branches.begin(), transition.branches.end(),
                     [&](const grammar::Branch& branch) { return branch.target.text == mode.name.text; });
}

/// The text of one hover, as Markdown.
class Card {
 public:
  Card(const Analysis& analysis, const Declaration& declaration, const compiler::Mention& mention)
      : sources_(analysis.sources()), analysis_(analysis), declared_(declaration), mention_(mention) {}

  std::string text() {
    switch (mention_.kind) {
      case NameKind::mode:
        mode();
        break;
      case NameKind::attribute:
      case NameKind::variable:
        typed();
        break;
      case NameKind::instance:
        instance();
        break;
      case NameKind::component:
        if (declared_.component != nullptr) component(*declared_.component);
        break;
      case NameKind::clock:
        clock();
        break;
      case NameKind::definition:
      case NameKind::parameter:
        definition();
        break;
      case NameKind::module:
      case NameKind::plant:
        module();
        break;
      case NameKind::channel:
        channel();
        break;
      case NameKind::value:
      case NameKind::domain:
      case NameKind::scenario:
        if (declared_.scenario == nullptr) code(on_one_line(sources_.text(declared_.statement)));
        break;
    }
    return text_;
  }

 private:
  void code(const std::string& source) { text_ += "```" + language() + "\n" + source + "\n```\n"; }
  void say(const std::string& sentence) { text_ += "\n" + sentence + "\n"; }
  void comment(grammar::Span statement) {
    const std::string comment = comment_above(sources_[statement.file], statement);
    if (!comment.empty()) say(comment);
  }
  [[nodiscard]] std::string language() const {
    const std::string extension =
        std::filesystem::path(sources_[mention_.declaration.file].name()).extension().string();
    return extension.empty() ? extension : extension.substr(1);
  }
  [[nodiscard]] std::string line(grammar::Span span) const { return on_one_line(sources_.text(span)); }

  void mode() {
    if (declared_.mode == nullptr || declared_.component == nullptr) return;
    code(line(declared_.mode->span));
    transitions("out of it", leaves);
    transitions("into it", enters);
    comment(declared_.statement);
  }
  void transitions(const std::string& what,
                   bool (*counts)(const grammar::TransitionText&, const grammar::ModeDeclaration&)) {
    std::string list;
    for (const grammar::ComponentItem& item : declared_.component->items) {
      const auto* transition = std::get_if<grammar::TransitionText>(&item);
      if (transition != nullptr && counts(*transition, *declared_.mode)) list += line(transition->span) + "\n";
    }
    say(list.empty() ? "No transition leads " + what + "." : "Transitions " + what + ":");
    if (!list.empty()) code(list.substr(0, list.size() - 1));
  }
  void typed() {
    code(line(declared_.statement));
    const grammar::DomainRef* domain = nullptr;
    if (declared_.attribute != nullptr) domain = &declared_.attribute->domain;
    if (declared_.variable != nullptr) domain = &declared_.variable->domain;
    if (domain != nullptr && std::holds_alternative<grammar::Name>(*domain)) {
      const auto* named = analysis_.scopes().domain(std::get<grammar::Name>(*domain).text);
      if (named != nullptr) code(line(find_declaration(analysis_.file(named->span.file), named->span).statement));
    }
    comment(declared_.statement);
  }
  void instance() {
    code(line(declared_.statement));
    comment(declared_.statement);
    if (declared_.instance == nullptr) return;
    const auto* type = analysis_.scopes().type(declared_.instance->type.text);
    if (type == nullptr) return;
    const Declaration declaration = find_declaration(analysis_.file(type->span.file), type->span);
    if (declaration.component != nullptr) component(*declaration.component);
  }
  void component(const grammar::ComponentDefinition& component) {
    std::string lines = "component " + component.name.text + " {\n";
    for (const grammar::ComponentItem& item : component.items) {
      const auto add = [&](const auto& one) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(one)>, grammar::TransitionText>)
          lines += "  " + line(one.span) + "\n";
      };
      std::visit(add, item);
    }
    code(lines + "}");
    comment(component.span);
  }
  void module() {
    if (declared_.module == nullptr) return;
    code((declared_.module->plant ? "plant " : "module ") + declared_.module->name.text);
    comment(declared_.module->span);
  }
  void clock() {
    std::string lines;
    const grammar::SourceFile& source = sources_[mention_.declaration.file];
    for (const compiler::Mention& use : analysis_.names().of(mention_.declaration)) {
      if (starts(use.span)) lines += (lines.empty() ? "" : ", ") + std::to_string(source.place(use.span.begin).line);
    }
    code("clock " + std::string(sources_.text(mention_.declaration)));
    say(lines.empty() ? "It starts nowhere." : "It starts in line " + lines + ".");
  }
  /// Every monitor of the channel, as it is written.
  void channel() {
    const std::string_view name = sources_.text(mention_.declaration);
    for (const compiler::File& file : analysis_.files()) {
      if (!file.monitors) continue;
      for (const grammar::MonitorDefinition& monitor : file.monitors->monitors) {
        const bool minus = monitor.minus && sources_.text(monitor.minus->span) == name;
        if (sources_.text(monitor.channel.span) != name && !minus) continue;
        code(std::string(sources_.text(monitor.span)));
        comment(monitor.span);
      }
    }
  }
  /// Whether `= 0` stands behind a clock.
  [[nodiscard]] bool starts(grammar::Span clock) const {
    std::string_view rest = sources_[clock.file].text().substr(clock.end);
    const std::string behind = on_one_line(rest.substr(0, 64));
    const std::size_t equals = behind.find_first_not_of(' ');
    if (equals == std::string::npos || behind[equals] != '=') return false;
    const std::size_t zero = behind.find_first_not_of(' ', equals + 1);
    return zero != std::string::npos && behind[zero] == '0';
  }
  void definition() {
    if (declared_.definition == nullptr) return;
    const grammar::Definition& definition = *declared_.definition;
    std::string signature = (definition.model ? "model " : "") + definition.name.text + "(";
    for (const grammar::Name& parameter : definition.parameters)
      signature += (&parameter == definition.parameters.data() ? "" : ", ") + parameter.text;
    code(signature + ")");
    comment(definition.span);
  }

  const grammar::Sources& sources_;
  const Analysis& analysis_;
  const Declaration& declared_;
  const compiler::Mention& mention_;
  std::string text_;
};

/// What the codes of the diagnostics at a place mean.
std::string explained(const Workspace& workspace, const Spot& spot, const Json& params) {
  const std::string uri = workspace.documents().of(params).uri;
  const Json& position = member(params, "position");
  std::string text;
  for (const Json& finding : findings_of(*spot.analysis, workspace)) {
    const Json& diagnostic = finding["diagnostic"];
    if (finding["uri"] != uri || !touch(diagnostic["range"], {{"start", position}, {"end", position}})) continue;
    const std::string code = diagnostic["code"];
    const grammar::CodeInfo& info = grammar::info(*grammar::find_code(code));
    text += "**" + code + "**: " + std::string(info.title) + "\n\n" + std::string(info.explanation) + "\n\n";
  }
  return text;
}

}  // namespace

Json hover(Workspace& workspace, const Json& params) {
  const Spot spot = workspace.spot(params);
  const auto mention = mention_at(spot);
  std::string text = explained(workspace, spot, params);
  if (mention) {
    const Declaration declared = find_declaration(spot.analysis->file(mention->declaration.file), mention->declaration);
    if (declared.statement.end > 0) text += Card(*spot.analysis, declared, *mention).text();
  }
  if (text.empty()) return nullptr;
  Json result = {{"contents", {{"kind", "markdown"}, {"value", text}}}};
  if (mention) result["range"] = range_of(spot.source(), mention->span);
  return result;
}

}  // namespace rmpl::tools
