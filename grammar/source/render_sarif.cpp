// Diagnostics as SARIF 2.1.0 (OASIS), which code scanning services read.
// SPDX-License-Identifier: MIT
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/percent.hpp"
#include "grammar/source/render.hpp"

namespace rmpl::grammar {
namespace {

using Json = nlohmann::ordered_json;

/// A file name as a URI reference (RFC 3986): a relative one stays relative to where the program ran.
std::string uri_of(std::string_view name) {
  return (name.starts_with('/') ? "file://" : "") + base::percent_encoded(name);
}

Json artifact_of(Span span, const Sources& sources) { return {{"uri", uri_of(sources[span.file].name())}}; }

Json region_of(Span span, const Sources& sources) {
  const SourceFile& file = sources[span.file];
  const Place begin = file.place(span.begin);
  const Place end = file.place(span.end);
  return {{"startLine", begin.line}, {"startColumn", begin.column}, {"endLine", end.line}, {"endColumn", end.column}};
}

Json physical_location(Span span, const Sources& sources) {
  return {{"artifactLocation", artifact_of(span, sources)}, {"region", region_of(span, sources)}};
}

Json rule_of(const CodeInfo& info, const Tool& tool) {
  const std::string text(info.explanation);
  const std::string wrong(info.wrong);
  const std::string right(info.right);
  Json rule;
  rule["id"] = to_string(info.code);
  rule["shortDescription"] = {{"text", info.title}};
  rule["fullDescription"] = {{"text", text}};
  if (!tool.homepage.empty()) rule["helpUri"] = tool.homepage + "/docs/diagnostics/" + to_string(info.code) + ".md";
  rule["help"] = {{"text", text + "\n\nwrong:\n" + wrong + "\n\nright:\n" + right},
                  {"markdown", text + "\n\nWrong:\n```\n" + wrong + "\n```\nRight:\n```\n" + right + "\n```"}};
  return rule;
}

/// The edits of a fix, by file in the order in which they come.
Json changes_of(const std::vector<Edit>& fix, const Sources& sources) {
  Json changes = Json::array();
  std::map<std::uint32_t, std::size_t> positions;
  for (const Edit& edit : fix) {
    const auto [known, fresh] = positions.emplace(edit.span.file, changes.size());
    if (fresh) {
      changes.push_back({{"artifactLocation", artifact_of(edit.span, sources)}, {"replacements", Json::array()}});
    }
    changes[known->second]["replacements"].push_back(
        {{"deletedRegion", region_of(edit.span, sources)}, {"insertedContent", {{"text", edit.text}}}});
  }
  return changes;
}

Json result_of(const Diagnostic& diagnostic, std::size_t rule, const Sources& sources) {
  Json result;
  result["ruleId"] = to_string(diagnostic.code);
  result["ruleIndex"] = rule;
  result["level"] = to_string(diagnostic.severity);
  result["message"] = {
      {"text", diagnostic.message + (diagnostic.suggestion ? "\nhelp: " + *diagnostic.suggestion : "")}};
  result["locations"] = Json::array();
  result["locations"].push_back({{"physicalLocation", physical_location(diagnostic.span, sources)}});
  if (!diagnostic.notes.empty()) result["relatedLocations"] = Json::array();
  for (std::size_t n = 0; n < diagnostic.notes.size(); ++n) {
    const Note& note = diagnostic.notes[n];
    result["relatedLocations"].push_back({{"id", n},
                                          {"message", {{"text", note.message}}},
                                          {"physicalLocation", physical_location(note.span, sources)}});
  }
  if (diagnostic.fix.empty()) return result;
  Json fix;
  if (diagnostic.suggestion) fix["description"] = {{"text", *diagnostic.suggestion}};
  fix["artifactChanges"] = changes_of(diagnostic.fix, sources);
  result["fixes"] = Json::array();
  result["fixes"].push_back(std::move(fix));
  return result;
}

}  // namespace

std::string render_sarif(std::span<const Diagnostic> diagnostics, const Sources& sources, const Tool& tool,
                         std::span<const AllowedFinding> allowed) {
  std::map<Code, std::size_t> rules;
  for (const Diagnostic& diagnostic : diagnostics) rules.emplace(diagnostic.code, 0);
  for (const AllowedFinding& one : allowed) rules.emplace(one.finding.code, 0);
  Json driver{{"name", tool.name}, {"version", tool.version}};
  if (!tool.homepage.empty()) driver["informationUri"] = tool.homepage;
  driver["rules"] = Json::array();
  for (auto& [code, position] : rules) {
    position = driver["rules"].size();
    driver["rules"].push_back(rule_of(info(code), tool));
  }
  Json results = Json::array();
  for (const Diagnostic& diagnostic : diagnostics) {
    results.push_back(result_of(diagnostic, rules.at(diagnostic.code), sources));
  }
  for (const AllowedFinding& one : allowed) {
    Json result = result_of(one.finding, rules.at(one.finding.code), sources);
    Json suppression{{"kind", "inSource"}, {"justification", one.reason}};
    suppression["location"] = {{"physicalLocation", physical_location(one.comment, sources)}};
    result["suppressions"] = Json::array();
    result["suppressions"].push_back(std::move(suppression));
    results.push_back(std::move(result));
  }
  Json run;
  run["tool"] = {{"driver", std::move(driver)}};
  run["columnKind"] = "unicodeCodePoints";
  run["results"] = std::move(results);
  Json log;
  log["$schema"] = "https://json.schemastore.org/sarif-2.1.0.json";
  log["version"] = "2.1.0";
  log["runs"] = Json::array();
  log["runs"].push_back(std::move(run));
  return log.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rmpl::grammar
