// Where a name is declared, and where it is used: over all units, for a plant may have several programs.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>

#include "tools/rmplc/server/everywhere.hpp"
#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/mentions.hpp"
#include "tools/rmplc/server/positions.hpp"

namespace rmpl::tools {

std::optional<compiler::Mention> mention_at(const Spot& spot) {
  return spot.analysis->names().at(spot.file, spot.offset);
}

std::vector<std::shared_ptr<Analysis>> users_of(Workspace& workspace, const Spot& spot, grammar::Span declaration) {
  return analyses_with(workspace, workspace.texts().identity(spot.analysis->sources()[declaration.file].name()));
}

std::vector<Use> uses_of(Workspace& workspace, const std::vector<std::shared_ptr<Analysis>>& analyses, const Spot& spot,
                         grammar::Span declaration) {
  const std::string declared_in = workspace.texts().identity(spot.analysis->sources()[declaration.file].name());
  std::vector<Use> uses;
  std::set<std::tuple<std::string, std::uint32_t>> seen;
  for (const auto& analysis : analyses) {
    const auto file = analysis->find(declared_in);
    if (!file) continue;
    for (const compiler::Mention& mention : analysis->names().of({*file, declaration.begin, declaration.end})) {
      const std::string uri = workspace.documents().uri_of(analysis->sources()[mention.span.file].name());
      if (seen.emplace(uri, mention.span.begin).second) uses.push_back({analysis.get(), mention, uri});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
    return std::tie(a.uri, a.mention.span.begin) < std::tie(b.uri, b.mention.span.begin);
  });
  return uses;
}

Json location_of(const Workspace& workspace, const Analysis& analysis, grammar::Span span) {
  const grammar::SourceFile& source = analysis.sources()[span.file];
  return {{"uri", workspace.documents().uri_of(source.name())}, {"range", range_of(source, span)}};
}

namespace {

/// The file that an import, a scenario's program or its plant names, where the spot is in that name.
std::optional<std::string> named_file(const Spot& spot) {
  const auto in = [&](const grammar::String& path) {
    return path.span.begin <= spot.offset && spot.offset <= path.span.end;
  };
  const grammar::String* found = nullptr;
  const auto look = [&](const auto& items) {
    for (const auto& item : items) {
      std::visit(
          [&](const auto& one) {
            if constexpr (requires { one.path.text; }) {
              if (in(one.path)) found = &one.path;
            }
          },
          item);
    }
  };
  const compiler::File& file = spot.analysis->file(spot.file);
  if (file.program) look(file.program->items);
  if (file.plant) look(file.plant->items);
  if (file.scenarios) {
    for (const grammar::ScenarioDefinition& scenario : file.scenarios->scenarios) look(scenario.items);
  }
  if (found == nullptr) return std::nullopt;
  return (std::filesystem::path(file.directory) / found->text).lexically_normal().string();
}

}  // namespace

Json definition(Workspace& workspace, const Json& params) {
  const Spot spot = workspace.spot(params);
  if (const auto path = named_file(spot)) {
    if (!spot.analysis->find(workspace.texts().identity(*path))) return nullptr;
    const Json start = {{"line", 0}, {"character", 0}};
    return {{"uri", workspace.documents().uri_of(*path)}, {"range", {{"start", start}, {"end", start}}}};
  }
  const auto mention = mention_at(spot);
  if (!mention) return nullptr;
  return location_of(workspace, *spot.analysis, mention->declaration);
}

Json references(Workspace& workspace, const Json& params) {
  const Spot spot = workspace.spot(params);
  const auto mention = mention_at(spot);
  if (!mention) return nullptr;
  const auto context = params.find("context");
  const bool with_declaration = context == params.end() || !context->is_object() ||
                                context->value("includeDeclaration", Json(true)) != Json(false);
  Json found = Json::array();
  const auto users = users_of(workspace, spot, mention->declaration);
  for (const Use& use : uses_of(workspace, users, spot, mention->declaration)) {
    if (!with_declaration && use.mention.span == use.mention.declaration) continue;
    found.push_back(location_of(workspace, *use.analysis, use.mention.span));
  }
  return found;
}

Json highlights(Workspace& workspace, const Json& params) {
  const Spot spot = workspace.spot(params);
  const auto mention = mention_at(spot);
  if (!mention) return nullptr;
  Json found = Json::array();
  for (const compiler::Mention& same : spot.analysis->names().of(mention->declaration)) {
    if (same.span.file == spot.file) found.push_back({{"range", range_of(spot.source(), same.span)}, {"kind", 1}});
  }
  return found;
}

}  // namespace rmpl::tools
