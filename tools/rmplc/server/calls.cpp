// Who calls a definition, and whom it calls: definitions of programs, scenarios that start with one, and plants that
// hold one as a model program.
// SPDX-License-Identifier: MIT
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tools/rmplc/server/declaration.hpp"
#include "tools/rmplc/server/everywhere.hpp"
#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/mentions.hpp"
#include "tools/rmplc/server/positions.hpp"
#include "tools/rmplc/server/uri.hpp"

namespace rmpl::tools {
namespace {

using compiler::NameKind;

/// The kinds of symbols of the protocol that are used here.
enum class CallerKind { module = 2, function = 12, event = 24 };

/// What calls or is called.
struct Caller {
  std::string name;
  CallerKind kind = CallerKind::function;
  grammar::Span place;  ///< of its name
  grammar::Span whole;
};

/// What a place stands in, or whose name it is.
std::optional<Caller> caller_at(const Analysis& analysis, grammar::Span place) {
  const Declaration around = find_declaration(analysis.file(place.file), place);
  if (around.definition != nullptr) {
    const grammar::Definition& one = *around.definition;
    return Caller{one.name.text, CallerKind::function, one.name.span, one.span};
  }
  if (around.scenario != nullptr) {
    const grammar::ScenarioDefinition& one = *around.scenario;
    return Caller{one.name.text, CallerKind::event, one.name.span, one.span};
  }
  if (around.module != nullptr) {
    const grammar::ModuleDefinition& one = *around.module;
    return Caller{one.name.text, CallerKind::module, one.name.span, one.span};
  }
  return std::nullopt;
}

Json item_of(const Workspace& workspace, const Analysis& analysis, const Caller& caller) {
  const grammar::SourceFile& source = analysis.sources()[caller.place.file];
  return {{"name", caller.name.empty() ? "?" : caller.name},
          {"kind", static_cast<int>(caller.kind)},
          {"uri", workspace.documents().uri_of(source.name())},
          {"range", range_of(source, caller.whole)},
          {"selectionRange", range_of(source, caller.place)}};
}

/// The place of an item that came before, in a document that need not be open. Throws RpcError where it is in no unit.
struct ItemSpot {
  std::shared_ptr<Analysis> analysis;
  Spot spot;
};

ItemSpot spot_of(Workspace& workspace, const Json& params) {
  const Json& item = member(params, "item");
  const std::string uri = text_member(item, "uri");
  const Json& place = member(member(item, "selectionRange"), "start");
  const auto& open = workspace.documents().all();
  const auto document = open.find(uri);
  const auto path = document != open.end() ? std::optional(document->second.path) : path_of_uri(uri);
  if (path) {
    const std::string identity = workspace.texts().identity(*path);
    const auto found_in = [&](const std::vector<std::shared_ptr<Analysis>>& some) -> std::optional<ItemSpot> {
      for (const auto& analysis : some) {
        const auto file = analysis ? analysis->find(identity) : std::nullopt;
        if (file) return ItemSpot{analysis, {analysis.get(), *file, offset_of(analysis->sources()[*file], place)}};
      }
      return std::nullopt;
    };
    if (auto found = found_in(workspace.analyses())) return std::move(*found);
    if (auto found = found_in(analyses_with(workspace, identity))) return std::move(*found);
  }
  throw RpcError(RpcCode::request_failed, uri + ": this name is not known");
}

/// The calls of one caller or of one that is called, in the order in which they came first.
class Calls {
 public:
  Calls(const Workspace& workspace, const char* side) : workspace_(workspace), side_(side) {}

  /// A call at a place of one unit, that has to do with `other` of the same unit.
  void add(const Analysis& analysis, const Caller& other, grammar::Span call) {
    Json item = item_of(workspace_, analysis, other);
    const auto [at, fresh] =
        positions_.emplace(std::pair(item["uri"].get<std::string>(), other.place.begin), all_.size());
    if (fresh) all_.push_back({{side_, std::move(item)}, {"fromRanges", Json::array()}});
    all_[at->second]["fromRanges"].push_back(range_of(analysis.sources()[call.file], call));
  }
  Json take() { return std::move(all_); }

 private:
  const Workspace& workspace_;
  const char* side_;  ///< `from` or `to`
  std::map<std::pair<std::string, std::uint32_t>, std::size_t> positions_;
  Json all_ = Json::array();
};

}  // namespace

Json prepare_call_hierarchy(Workspace& workspace, const Json& params) {
  const Spot spot = workspace.spot(params);
  const auto mention = mention_at(spot);
  if (!mention || mention->kind != NameKind::definition) return nullptr;
  const auto named = caller_at(*spot.analysis, mention->declaration);
  if (!named) return nullptr;
  return Json::array({item_of(workspace, *spot.analysis, *named)});
}

Json incoming_calls(Workspace& workspace, const Json& params) {
  const ItemSpot item = spot_of(workspace, params);
  const auto mention = mention_at(item.spot);
  if (!mention || mention->kind != NameKind::definition) return Json::array();
  const auto users = users_of(workspace, item.spot, mention->declaration);
  Calls calls(workspace, "from");
  for (const Use& use : uses_of(workspace, users, item.spot, mention->declaration)) {
    if (use.mention.span == use.mention.declaration) continue;
    if (const auto caller = caller_at(*use.analysis, use.mention.span)) {
      calls.add(*use.analysis, *caller, use.mention.span);
    }
  }
  return calls.take();
}

Json outgoing_calls(Workspace& workspace, const Json& params) {
  const ItemSpot item = spot_of(workspace, params);
  const Analysis& analysis = *item.analysis;
  const auto caller = caller_at(analysis, {item.spot.file, item.spot.offset, item.spot.offset});
  Calls calls(workspace, "to");
  if (!caller) return calls.take();
  for (const compiler::Mention& mention : analysis.names().all()) {
    const bool inside = mention.span.file == caller->whole.file && caller->whole.begin <= mention.span.begin &&
                        mention.span.end <= caller->whole.end;
    if (!inside || mention.kind != NameKind::definition || mention.span == mention.declaration) continue;
    if (const auto called = caller_at(analysis, mention.declaration)) {
      calls.add(analysis, *called, mention.span);
    }
  }
  return calls.take();
}

}  // namespace rmpl::tools
