// Diagnostics as the protocol has them, and the edits that put them right.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/positions.hpp"
#include "tools/rmplc/server/uri.hpp"

namespace rmpl::tools {
namespace {

int severity_of(grammar::Severity severity) {
  switch (severity) {
    case grammar::Severity::error:
      return 1;
    case grammar::Severity::warning:
      return 2;
    case grammar::Severity::note:
      return 3;
  }
  return 3;
}

std::string uri_of(const Workspace& workspace, const Analysis& analysis, grammar::Span span) {
  return workspace.documents().uri_of(analysis.sources()[span.file].name());
}

Json to_protocol(const grammar::Diagnostic& diagnostic, const Analysis& analysis, const Workspace& workspace) {
  const grammar::Sources& sources = analysis.sources();
  Json result = {{"range", range_of(sources[diagnostic.span.file], diagnostic.span)},
                 {"severity", severity_of(diagnostic.severity)},
                 {"code", grammar::to_string(diagnostic.code)},
                 {"source", "rmplc"},
                 {"message", diagnostic.message}};
  if (diagnostic.suggestion) result["message"] = diagnostic.message + "\nhelp: " + *diagnostic.suggestion;
  if (!workspace.pages().empty()) {
    const std::string page = workspace.pages() + "/" + grammar::to_string(diagnostic.code) + ".md";
    result["codeDescription"] = {{"href", uri_of_path(page)}};
  }
  if (diagnostic.notes.empty()) return result;
  Json& related = result["relatedInformation"] = Json::array();
  for (const grammar::Note& note : diagnostic.notes) {
    related.push_back(
        {{"location",
          {{"uri", uri_of(workspace, analysis, note.span)}, {"range", range_of(sources[note.span.file], note.span)}}},
         {"message", note.message}});
  }
  return result;
}

/// The fix of a diagnostic as an action of the editor.
Json action_of(const grammar::Diagnostic& diagnostic, const Analysis& analysis, const Workspace& workspace) {
  Json changes = Json::object();
  for (const grammar::Edit& edit : diagnostic.fix) {
    changes[uri_of(workspace, analysis, edit.span)].push_back(
        {{"range", range_of(analysis.sources()[edit.span.file], edit.span)}, {"newText", edit.text}});
  }
  return {{"title", diagnostic.suggestion.value_or("fix it")},
          {"kind", "quickfix"},
          {"diagnostics", Json::array({to_protocol(diagnostic, analysis, workspace)})},
          {"isPreferred", true},
          {"edit", {{"changes", std::move(changes)}}}};
}

/// Whether the client asks for actions of this kind.
bool wants_quick_fixes(const Json& params) {
  const auto context = params.find("context");
  if (context == params.end() || !context->is_object()) return true;
  const auto only = context->find("only");
  if (only == context->end() || !only->is_array()) return true;
  return std::any_of(only->begin(), only->end(), [](const Json& kind) { return kind == "quickfix" || kind == ""; });
}

std::pair<std::uint32_t, std::uint32_t> place_of(const Json& position) {
  return {number_member(position, "line"), number_member(position, "character")};
}

}  // namespace

Json findings_of(std::span<const grammar::Diagnostic> diagnostics, const Analysis& analysis,
                 const Workspace& workspace) {
  Json findings = Json::array();
  for (const grammar::Diagnostic& diagnostic : diagnostics) {
    Json one = {{"uri", uri_of(workspace, analysis, diagnostic.span)},
                {"diagnostic", to_protocol(diagnostic, analysis, workspace)}};
    if (!diagnostic.fix.empty()) one["action"] = action_of(diagnostic, analysis, workspace);
    findings.push_back(std::move(one));
  }
  return findings;
}

Json findings_of(const Analysis& analysis, const Workspace& workspace) {
  if (analysis.lint_findings()) return *analysis.lint_findings();
  return findings_of(analysis.diagnostics(), analysis, workspace);
}

bool touch(const Json& range, const Json& other) {
  return place_of(member(range, "start")) <= place_of(member(other, "end")) &&
         place_of(member(range, "end")) >= place_of(member(other, "start"));
}

std::map<std::string, Json> diagnostics_by_uri(Workspace& workspace) {
  std::map<std::string, Json> found;
  std::map<std::string, std::set<std::string>> told;  // a file may be in several units, and wrong in each
  for (const auto& [uri, document] : workspace.documents().all()) found[uri] = Json::array();
  for (const auto& analysis : workspace.analyses()) {
    if (!analysis) continue;
    for (const compiler::File& file : analysis->files())
      found.try_emplace(workspace.documents().uri_of(analysis->sources()[file.index].name()), Json::array());
    for (Json& finding : findings_of(*analysis, workspace)) {
      const std::string uri = finding["uri"];
      Json& one = finding["diagnostic"];
      if (told[uri].insert(one.dump(-1, ' ', false, Json::error_handler_t::replace)).second)
        found[uri].push_back(std::move(one));
    }
  }
  return found;
}

Json code_actions(Workspace& workspace, const Json& params) {
  Json actions = Json::array();
  const OpenDocument& document = workspace.documents().of(params);
  const Json& range = member(params, "range");
  offset_of(*document.source, member(range, "start"));  // must be places
  offset_of(*document.source, member(range, "end"));
  if (!wants_quick_fixes(params)) return actions;
  for (const auto& analysis : workspace.analyses()) {
    if (!analysis) continue;
    for (Json& finding : findings_of(*analysis, workspace)) {
      const bool here = finding["uri"] == document.uri && finding.contains("action");
      if (!here || !touch(finding["diagnostic"]["range"], range)) continue;
      Json& action = finding["action"];
      if (std::find(actions.begin(), actions.end(), action) == actions.end()) actions.push_back(std::move(action));
    }
  }
  return actions;
}

}  // namespace rmpl::tools
