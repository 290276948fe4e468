// The runner of lint: the passes in order, and what the codes are.
// SPDX-License-Identifier: MIT
#include "compiler/lint/lint.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "base/check.hpp"
#include "compiler/lint/allowances.hpp"

namespace rmpl::compiler {

using grammar::Diagnostics;

grammar::Diagnostic& add_finding(Diagnostics& found, grammar::Code code, grammar::Span span, std::string message) {
  const LintCode* known = find_lint_code(code);
  CHECK(known != nullptr && "what lint finds is among its codes");
  switch (known->level) {
    case grammar::Severity::error:
      return found.error(code, span, std::move(message));
    case grammar::Severity::warning:
      return found.warning(code, span, std::move(message));
    case grammar::Severity::note:
      break;
  }
  return found.note(code, span, std::move(message));
}

namespace {

/// A pass may tell a finding once more, with the fix that it found: that one stays.
Diagnostics without_poorer(const Diagnostics& found) {
  std::set<std::pair<grammar::Span, grammar::Code>> richer;
  for (const grammar::Diagnostic& finding : found.all()) {
    if (!finding.fix.empty()) richer.emplace(finding.span, finding.code);
  }
  Diagnostics result;
  for (const grammar::Diagnostic& finding : found.all()) {
    if (!finding.fix.empty() || !richer.contains({finding.span, finding.code})) result.add(finding);
  }
  return result;
}

/// Puts a finding at the level that was asked for; whether it is to be told.
bool put_at_level(grammar::Diagnostic& finding, const LintSettings& settings) {
  const auto level = settings.levels.find(finding.code);
  if (level == settings.levels.end()) return true;
  if (!level->second) return false;
  // One that is less certain than others of its code stays milder.
  const LintCode* known = find_lint_code(finding.code);
  const bool mild = known != nullptr && finding.severity < known->level;
  finding.severity = mild ? std::min(finding.severity, *level->second) : *level->second;
  return true;
}

/// The findings at the levels that were asked for.
Diagnostics at_levels(const Diagnostics& found, const LintSettings& settings) {
  Diagnostics result;
  for (grammar::Diagnostic finding : found.all()) {
    if (put_at_level(finding, settings)) result.add(std::move(finding));
  }
  return result;
}

}  // namespace

Diagnostics lint(const Compilation& compilation, const LintSettings& settings) {
  std::vector<grammar::AllowedFinding> untold;
  return lint(compilation, settings, untold);
}

Diagnostics lint(const Compilation& compilation, const LintSettings& settings,
                 std::vector<grammar::AllowedFinding>& allowed) {
  const grammar::Sources& sources = compilation.findings().sources;
  Diagnostics found = compilation.findings().diagnostics;
  const NameIndex names = compilation.names();
  const Places places(sources, compilation.files());
  const LintInput input{sources,
                        compilation.files(),
                        compilation.document(),
                        compilation.properties(),
                        names,
                        places,
                        compilation.places(),
                        compilation.model_places(),
                        compilation.plants_with_models(),
                        compilation.software_places(),
                        settings.cycle};
  for (const auto passes : {plant_passes(), model_program_passes(), program_passes()}) {
    for (const LintPass pass : passes) pass(input, found);
  }
  std::vector<grammar::AllowedFinding> own;
  const Diagnostics left = without_allowed(without_poorer(found), sources, compilation.files(), own);
  std::erase_if(own, [&](grammar::AllowedFinding& one) { return !put_at_level(one.finding, settings); });
  std::stable_sort(own.begin(), own.end(), [](const auto& a, const auto& b) {
    return std::tie(a.finding.span, a.finding.code) < std::tie(b.finding.span, b.finding.code);
  });
  const auto same = [](const auto& a, const auto& b) { return a.finding == b.finding; };
  own.erase(std::unique(own.begin(), own.end(), same), own.end());
  std::move(own.begin(), own.end(), std::back_inserter(allowed));
  return at_levels(left, settings);
}

}  // namespace rmpl::compiler
