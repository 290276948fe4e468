// A new name for what has one, where everything still means what it did.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

#include "compiler/session/provider.hpp"
#include "grammar/parse/scan.hpp"
#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/mentions.hpp"
#include "tools/rmplc/server/positions.hpp"

namespace rmpl::tools {
namespace {

[[noreturn]] void refuse(const std::string& why) { throw RpcError(RpcCode::request_failed, why); }

compiler::Mention renamed_at(const Spot& spot) {
  const auto mention = mention_at(spot);
  if (!mention) refuse("there is no name here that the compiler knows");
  if (mention->kind == compiler::NameKind::scenario) refuse("a scenario's name is a text: edit it where it stands");
  return *mention;
}

void check_name(const std::string& name) {
  const char* const end = name.data() + name.size();
  if (name.empty() || grammar::identifier_at(name.data(), end) != name || name.find('.') != std::string::npos)
    refuse("'" + name + "' is no name: expected a letter or `_`, then letters, digits, `_` and `-`");
  if (grammar::is_reserved(name)) refuse("`" + name + "` is a word of the language");
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
    refuse("with the name `" + name + "` line " + std::to_string(source.place(diagnostic.span.begin).line) + " of " +
           source.name() + " would be wrong: " + diagnostic.message);
  }
  if (meaning_of(before) != meaning_of(after))
    refuse("`" + name + "` is the name of something else: with it the text would have another meaning");
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
  for (const Use& use : uses_of(workspace, spot, mention.declaration)) {
    Changed& file = files[use.uri];
    file.source = &use.analysis->sources()[use.mention.span.file];
    file.uses.push_back(use.mention.span);
  }
  compiler::Provider& before = workspace.texts();
  compiler::Overlay texts(before);
  Json changes = Json::object();
  for (const auto& [uri, file] : files) {
    texts.put(file.source->name(), renamed(file.source->text(), file.uses, name));
    for (const grammar::Span use : file.uses)
      changes[uri].push_back({{"range", range_of(*file.source, use)}, {"newText", name}});
  }
  for (const auto& analysis : workspace.analyses()) {
    if (!analysis) continue;
    const bool concerned = std::any_of(files.begin(), files.end(), [&](const auto& file) {
      return analysis->find(workspace.texts().identity(file.second.source->name())).has_value();
    });
    if (!concerned) continue;
    for (const compiler::File& file : analysis->files()) {
      if (!file.whole) refuse(analysis->sources()[file.index].name() + " has syntax errors: mend them first");
    }
    check_unit(*analysis, texts, name);
  }
  return {{"changes", std::move(changes)}};
}

}  // namespace rmpl::tools
