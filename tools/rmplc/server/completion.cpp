// What may be written next: words by the grammar, names by what the grammar wants them for.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "grammar/editor/expectation.hpp"
#include "tools/rmplc/server/declaration.hpp"
#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/language.hpp"
#include "tools/rmplc/server/open_text.hpp"
#include "tools/rmplc/server/positions.hpp"

namespace rmpl::tools {
namespace {

using compiler::Declared;
using compiler::NameKind;

/// The kinds of the protocol that are used here.
enum class ItemKind {
  function = 3,
  variable = 6,
  klass = 7,
  property = 10,
  enumeration = 13,
  keyword = 14,
  file = 17,
  member = 20
};

ItemKind kind_of(NameKind kind) {
  switch (kind) {
    case NameKind::definition:
      return ItemKind::function;
    case NameKind::component:
    case NameKind::module:
    case NameKind::plant:
      return ItemKind::klass;
    case NameKind::domain:
      return ItemKind::enumeration;
    case NameKind::value:
    case NameKind::mode:
      return ItemKind::member;
    case NameKind::attribute:
      return ItemKind::property;
    case NameKind::parameter:
    case NameKind::clock:
    case NameKind::variable:
    case NameKind::instance:
    case NameKind::scenario:
    case NameKind::channel:
      return ItemKind::variable;
  }
  return ItemKind::variable;
}

class Completing {
 public:
  Completing(Workspace& workspace, const Spot& spot, grammar::Language language)
      : workspace_(workspace),
        spot_(spot),
        language_(language),
        before_(spot.source().text().substr(0, spot.offset)),
        mended_(mended(workspace, spot, language, before_)),
        scopes_(mended_ ? mended_->scopes() : spot.analysis->scopes()) {}

  Json run() {
    if (before_.in_comment) return take();
    if (before_.in_string) {
      before_.back(0) == "channel" ? add_channels() : files();
      return take();
    }
    const grammar::Expectation expected = grammar::expected_after(language_, before_.tokens);
    for (const std::string& rule : expected.name_rules) names_for(rule);
    if (before_.word.find('.') == std::string_view::npos) {
      for (const std::string& word : expected.words) keyword(word);
    }
    return take();
  }

 private:
  static bool is_number(std::string_view token) {
    return !token.empty() && token.front() >= '0' && token.front() <= '9';
  }

  /// Where the statement that is being written makes the text no text of the language, what is known without it: a
  /// compiler does not follow the imports of such a text.
  static std::unique_ptr<Analysis> mended(Workspace& workspace, const Spot& spot, grammar::Language language,
                                          const Before& before) {
    if (spot.analysis->file(spot.file).whole) return nullptr;
    compiler::Provider& texts = workspace.texts();
    compiler::Overlay changed(texts);
    std::vector<std::string> texts_without = without_statement(spot.source().text(), before, spot.offset);
    changed.put(spot.source().name(), std::move(texts_without[best_of(language, texts_without)]));
    return std::make_unique<Analysis>(spot.analysis->unit(), changed);
  }

  /// A word of the grammar; a unit only right behind a number, or where a rate is given by it.
  void keyword(const std::string& word) {
    const auto& list = grammar::keywords(language_);
    const auto known = list.find(word);
    if (known == list.end()) return;
    const bool unit = known->second.kind == "unit";
    if (unit && !is_number(before_.back(0)) && before_.back(0) != "/") return;
    add(word, ItemKind::keyword, std::string(known->second.meaning), unit ? '1' : '3');
  }

  Json take() { return {{"isIncomplete", false}, {"items", std::move(items_)}}; }

  void add(const std::string& label, ItemKind kind, const std::string& detail, char rank) {
    if (!seen_.insert(label).second) return;
    const auto begin = static_cast<std::uint32_t>(spot_.offset - before_.word.size());
    Json item = {{"label", label}, {"kind", static_cast<int>(kind)}};
    if (!detail.empty()) item["detail"] = detail;
    item["sortText"] = rank + label;
    item["filterText"] = label;
    item["textEdit"] = {{"range", range_of(spot_.source(), begin, spot_.offset)}, {"newText", label}};
    items_.push_back(std::move(item));
  }
  void add_all(const compiler::Members& members, const std::string& prefix, char rank) {
    for (const auto& [name, declared] : members)
      add(prefix + name, kind_of(declared.kind),
          declared.type.empty() ? std::string(name_of(declared.kind)) : declared.type, rank);
  }

  /// The component or module that the statement stands in; empty outside of them.
  [[nodiscard]] std::string enclosing_type() const {
    if (language_ != grammar::Language::tcca || before_.tokens.size() < 3) return {};
    const std::string_view what = before_.tokens.front();
    return what == "component" || what == "module" || what == "plant" ? std::string(before_.tokens[1]) : "";
  }
  [[nodiscard]] bool behind_colon() const {
    const auto& tokens = before_.tokens;
    const auto colon = std::find(tokens.rbegin(), tokens.rend(), ":");
    const auto end = std::find_if(tokens.rbegin(), tokens.rend(), [](auto t) { return t == ";" || t == "{"; });
    return colon < end;
  }

  void names_for(const std::string& rule) {
    if (rule == "value") return values();
    if (rule == "atom" || rule == "argument" || rule == "assignment" || rule == "observe" || rule == "control" ||
        rule == "monitor")
      return variables();
    if (rule == "goal" || rule == "clock-start") return clocks();
    if (rule == "item") return starts();
    if (rule == "call") return add_all(scopes_.definitions(), "", '2');
    if (rule == "sources" || rule == "plain" || rule == "branch") return modes_of(enclosing_type());
    if (rule == "initial-mode") return modes_of(type_of_initial());
    if (rule == "instance" && behind_colon()) return types();
    if ((rule == "attribute" || rule == "variable") && behind_colon()) return add_all(scopes_.domains(), "", '1');
  }
  /// The definitions that the program of a scenario may start with: `program "main.rmpl" main`.
  void starts() {
    const Analysis& analysis = mended_ ? *mended_ : *spot_.analysis;
    std::string_view program = before_.back(1);
    if (program.size() < 2) return;
    program = program.substr(1, program.size() - 2);
    const auto folder = std::filesystem::path(spot_.source().name()).parent_path();
    for (const compiler::File& file : analysis.files()) {
      const std::filesystem::path path(analysis.sources()[file.index].name());
      if (!file.program || path.lexically_normal() != (folder / program).lexically_normal()) continue;
      for (const grammar::ProgramItem& item : file.program->items) {
        const auto* definition = std::get_if<grammar::Definition>(&item);
        if (definition != nullptr && definition->parameters.empty() && !definition->model)
          add(definition->name.text, kind_of(NameKind::definition), std::string(name_of(NameKind::definition)), '2');
      }
    }
  }
  void types() {
    for (const auto& [name, declared] : scopes_.types()) {
      if (declared.kind != NameKind::plant) add(name, kind_of(declared.kind), std::string(name_of(declared.kind)), '1');
    }
  }
  /// Of `initial`: the component's own, or in an instance those of its type.
  [[nodiscard]] std::string type_of_initial() const {
    const auto& tokens = before_.tokens;
    const auto colon = std::find(tokens.rbegin(), tokens.rend(), ":");
    return colon == tokens.rend() || colon == tokens.rbegin() ? enclosing_type() : std::string(*(colon - 1));
  }
  void modes_of(const std::string& type) {
    const compiler::Members* modes = scopes_.values({{}, NameKind::instance, nullptr, type});
    if (modes != nullptr) add_all(*modes, "", '1');
  }

  /// What has a value here: of a plant's part its attributes and instances, else of the whole plant.
  void variables() {
    const std::string type = enclosing_type();
    const std::string inside = type.empty() ? scopes_.plant() : type;
    const std::size_t dot = before_.word.rfind('.');
    if (dot != std::string_view::npos) {
      const Declared* instance = scopes_.member(inside, before_.word.substr(0, dot));
      const compiler::Members* members = instance == nullptr ? nullptr : scopes_.members(instance->type);
      if (members != nullptr) add_all(*members, std::string(before_.word.substr(0, dot + 1)), '1');
      return;
    }
    if (type.empty()) add_all(scopes_.variables(), "", '2');
    if (const compiler::Members* members = scopes_.members(inside)) add_all(*members, "", '2');
    clocks();
  }
  /// Clocks and parameters that the program mentions.
  void clocks() {
    if (language_ != grammar::Language::rmpl) return;
    const grammar::Sources& sources = spot_.analysis->sources();
    const Declaration around =
        find_declaration(spot_.analysis->file(spot_.file), {spot_.file, spot_.offset, spot_.offset});
    for (const compiler::Mention& mention : spot_.analysis->names().all()) {
      const bool own = mention.kind == NameKind::parameter && around.definition != nullptr &&
                       around.definition->span.begin <= mention.span.begin &&
                       mention.span.end <= around.definition->span.end;
      if (mention.span.file == spot_.file && (mention.kind == NameKind::clock || own))
        add(std::string(sources.text(mention.span)), ItemKind::variable, std::string(name_of(mention.kind)), '2');
    }
  }

  /// The variable whose value comes next: of `x =`, `x in { v,` or `control x default`; of a monitor its attribute.
  [[nodiscard]] std::string_view compared() const {
    if (language_ == grammar::Language::mon) {
      const auto& tokens = before_.tokens;
      const auto brace = std::find(tokens.rbegin(), tokens.rend(), "{");
      return brace == tokens.rend() || brace + 1 == tokens.rend() ? "" : *(brace + 1);
    }
    const std::string_view last = before_.back(0);
    if (last == "=" || last == "!=" || last == "≠") return before_.back(1);
    if (last == "default") {
      const auto& tokens = before_.tokens;
      const auto control = std::find(tokens.rbegin(), tokens.rend(), "control");
      return control == tokens.rend() || control == tokens.rbegin() ? "" : *(control - 1);
    }
    for (std::size_t n = 0; n + 2 < before_.tokens.size(); ++n) {
      if (before_.back(n) == "{") return before_.back(n + 1) == "in" ? before_.back(n + 2) : "";
    }
    return "";
  }
  void values() {
    const std::string_view variable = compared();
    if (variable.empty()) return;
    const std::string type = enclosing_type();
    const Declared* declared = type.empty() ? scopes_.visible(variable) : scopes_.member(type, variable);
    const compiler::Members* values = declared == nullptr ? nullptr : scopes_.values(*declared);
    if (values != nullptr) add_all(*values, "", '1');
    if (before_.back(0) != "default" && before_.tokens.front() != "component" && !type.empty()) variables();
  }

  /// The channels that monitors name, between quotes.
  void add_channels() {
    for (const auto& [name, declared] : scopes_.channels())
      add("\"" + name + "\"", kind_of(declared.kind), std::string(name_of(declared.kind)), '1');
  }

  /// The files beside this one that may be named here.
  void files() {
    const std::string_view keyword = before_.back(0);
    const std::string own = std::filesystem::path(spot_.source().name()).extension().string();
    const std::string wanted = keyword == "import"    ? own
                               : keyword == "program" ? ".rmpl"
                               : keyword == "plant"   ? ".tcca"
                                                      : "";
    if (wanted.empty()) return;
    const std::filesystem::path folder = std::filesystem::path(spot_.source().name()).parent_path();
    std::set<std::string> names;
    std::error_code error;
    std::filesystem::directory_iterator entry(folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
      if (entry->path().extension() == wanted) names.insert(entry->path().filename().string());
    for (const auto& [uri, document] : workspace_.documents().all()) {
      const std::filesystem::path path(document.path);
      if (path.parent_path() == folder && path.extension() == wanted) names.insert(path.filename().string());
    }
    names.erase(std::filesystem::path(spot_.source().name()).filename().string());
    for (const std::string& name : names) add("\"" + name + "\"", ItemKind::file, "", '1');
  }

  Workspace& workspace_;
  const Spot& spot_;
  grammar::Language language_;
  Before before_;
  std::unique_ptr<Analysis> mended_;
  const compiler::NameScopes& scopes_;
  Json items_ = Json::array();
  std::set<std::string> seen_;
};

}  // namespace

Json completion(Workspace& workspace, const Json& params) {
  const Spot spot = workspace.spot(params);
  const auto language = language_of(spot.source().name());
  if (!language) return nullptr;
  return Completing(workspace, spot, *language).run();
}

}  // namespace rmpl::tools
