// A new name for what has one, where everything still means what it did.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

#include "compiler/format/format.hpp"
#include "compiler/session/provider.hpp"
#include "grammar/parse/scan.hpp"
#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/mentions.hpp"
#include "tools/rmplc/server/positions.hpp"

namespace rmpl::tools {
namespace {

[[noreturn]] void refuse_name(const std::string& why) { throw RpcError(RpcCode::request_failed, why); }

compiler::Mention renamed_at(const Spot& spot) {
  const auto mention = mention_at(spot);
  if (!mention) refuse_name("no name that the compiler knows is at this place");
  if (mention->kind == compiler::NameKind::scenario) refuse_name("the name of a scenario is a text: edit it directly");
  if (mention->kind == compiler::NameKind::channel)
    refuse_name("the name of a channel comes from the telemetry: edit it directly");
  return *mention;
}

void check_name(const std::string& name) {
  const char* const end = name.data() + name.size();
  if (name.empty() || grammar::identifier_at(name.data(), end) != name || name.find('.') != std::string::npos)
    refuse_name("'" + name + "' is no name: expected a letter or `_`, then letters, digits, `_` and `-`");
  if (grammar::is_reserved(name)) refuse_name("`" + name + "` is a word of the language");
}

/// What every mention is and which mention declares it, in order of the text: the same before and after where all means
/// what it did.
using Meaning = std::vector<std::tuple<std::uint32_t, compiler::NameKind, std::size_t>>;

Meaning meaning_of(const Analysis& analysis) {
  const auto mentions = analysis.names().all();
  std::map<grammar::Span, std::size_t> places;
  for (std::size_t m = 0; m < mentions.size(); ++m) places.emplace(mentions[m].span, m);
  Meaning meaning;
  for (const compiler::Mention& mention : mentions) {
    const auto declared = places.find(mention.declaration);
    meaning.emplace_back(mention.span.file, mention.kind,
                         declared == places.end() ? mentions.size() : declared->second);
  }
  return meaning;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  for (;;) {
    const std::size_t end = text.find('\n');
    lines.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return lines;
    text.remove_prefix(end + 1);
  }
}

/// The text of a file with the new name in place of each use; `uses` are in order.
std::string renamed(std::string_view text, const std::vector<grammar::Span>& uses, const std::string& name) {
  std::string result;
  std::uint32_t at = 0;
  for (const grammar::Span use : uses) {
    result += text.substr(at, use.begin - at);
    result += name;
    at = use.end;
  }
  result += text.substr(at);
  return result;
}

/// The edits of a file: the new name at each use; where the text was in the one style and would not be any more, as
/// columns move, each line that differs as a whole. `text` becomes what the edits make of it.
Json edits_of(const grammar::SourceFile& source, const std::vector<grammar::Span>& uses, const std::string& name,
              std::string& text) {
  Json edits = Json::array();
  const auto kind = compiler::kind_by_name(source.name());
  const bool laid_out = kind && compiler::format(source.text(), *kind) == std::string(source.text());
  const auto after = laid_out ? compiler::format(text, *kind) : std::nullopt;
  const std::vector<std::string_view> old_lines = lines_of(source.text());
  const std::vector<std::string_view> new_lines = after ? lines_of(*after) : std::vector<std::string_view>{};
  if (!after || *after == text || old_lines.size() != new_lines.size()) {
    for (const grammar::Span use : uses) edits.push_back({{"range", range_of(source, use)}, {"newText", name}});
    return edits;
  }
  std::uint32_t begin = 0;
  for (std::size_t l = 0; l < old_lines.size(); ++l) {
    const std::uint32_t end = begin + static_cast<std::uint32_t>(old_lines[l].size());
    if (old_lines[l] != new_lines[l])
      edits.push_back({{"range", range_of(source, begin, end)}, {"newText", std::string(new_lines[l])}});
    begin = end + 1;
  }
  text = *after;
  return edits;
}

/// Compiles the unit with the new texts, and refuses what would then be wrong or mean something else.
void check_unit(const Analysis& before, compiler::Provider& texts, const std::string& name) {
  const Analysis after(before.unit(), texts);
  const auto is_known = [&](const grammar::Diagnostic& d) {
    return std::any_of(before.diagnostics().begin(), before.diagnostics().end(),
                       [&](const grammar::Diagnostic& old) { return old.code == d.code && old.message == d.message; });
  };
  for (const grammar::Diagnostic& diagnostic : after.diagnostics()) {
    if (diagnostic.severity != grammar::Severity::error || is_known(diagnostic)) continue;
    const grammar::SourceFile& source = after.sources()[diagnostic.span.file];
    refuse_name("with the name `" + name + "` line " + std::to_string(source.place(diagnostic.span.begin).line) +
                " of " + source.name() + " would be wrong: " + diagnostic.message);
  }
  if (meaning_of(before) != meaning_of(after))
    refuse_name("`" + name + "` already names something else: the text would change its meaning");
}

}  // namespace

Json prepare_rename(Workspace& workspace, const Json& params) {
  const Spot spot = workspace.spot(params);
  const compiler::Mention mention = renamed_at(spot);
  return {{"range", range_of(spot.source(), mention.span)},
          {"placeholder", std::string(spot.analysis->sources().text(mention.span))}};
}

Json rename(Workspace& workspace, const Json& params) {
  const Spot spot = workspace.spot(params);
  const compiler::Mention mention = renamed_at(spot);
  const std::string name = text_member(params, "newName");
  check_name(name);
  struct Changed {
    const grammar::SourceFile* source;
    std::vector<grammar::Span> uses;
  };
  std::map<std::string, Changed> files;
  const auto users = users_of(workspace, spot, mention.declaration);
  for (const Use& use : uses_of(workspace, users, spot, mention.declaration)) {
    Changed& file = files[use.uri];
    file.source = &use.analysis->sources()[use.mention.span.file];
    file.uses.push_back(use.mention.span);
  }
  compiler::Provider& before = workspace.texts();
  compiler::Overlay texts(before);
  Json changes = Json::object();
  for (const auto& [uri, file] : files) {
    std::string text = renamed(file.source->text(), file.uses, name);
    changes[uri] = edits_of(*file.source, file.uses, name, text);
    texts.put(file.source->name(), std::move(text));
  }
  // Also those that share a file with the users, and have something of their own by the new name.
  std::vector<std::shared_ptr<Analysis>> concerned = users;
  for (const auto& analysis : workspace.analyses()) {
    const bool shares = analysis && std::any_of(files.begin(), files.end(), [&](const auto& file) {
                          return analysis->find(workspace.texts().identity(file.second.source->name())).has_value();
                        });
    if (shares && std::find(users.begin(), users.end(), analysis) == users.end()) concerned.push_back(analysis);
  }
  for (const auto& analysis : concerned) {
    for (const compiler::File& file : analysis->files()) {
      if (!file.whole) refuse_name(analysis->sources()[file.index].name() + " has syntax errors: fix them first");
    }
    check_unit(*analysis, texts, name);
  }
  return {{"changes", std::move(changes)}};
}

}  // namespace rmpl::tools
