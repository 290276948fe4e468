// Diagnostics for people and for programs.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "grammar/source/diagnostic.hpp"
#include "grammar/source/findings.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::grammar {

/// The manner of rustc: a headline with severity and code, the place, the source line with carets under the span, each
/// note with its own line and carets, the suggestion as `help:`. Long lines are shown through a window around the span,
/// tabs as four columns. One blank line after each. `color`: with ANSI escapes.
std::string render_text(std::span<const Diagnostic> diagnostics, const Sources& sources, bool color);

/// A JSON array of {code, severity, file, line, column, end_line, end_column, message, notes[], suggestion, fix[]}; a
/// note has the place keys and message, an edit of a fix the place keys and text; `suggestion` is null where there is
/// none. Lines and columns count from 1, columns in code points, the end is exclusive. Schema:
/// grammar/schema/diagnostics.schema.json.
std::string render_json(std::span<const Diagnostic> diagnostics, const Sources& sources);

/// What a log says of the program that made it.
struct Tool {
  std::string name;
  std::string version;
  std::string homepage = {};  ///< its address; docs/diagnostics below it has a page for each rule; empty: none is known
};

/// SARIF 2.1.0: one run; the rules that occur, with help; regions by line and column in code points; notes as related
/// locations; fixes. A file name becomes a URI, relative where it was. Findings that are allowed stand among the
/// others, each with its suppression: the comment, and the reason as its justification.
std::string render_sarif(std::span<const Diagnostic> diagnostics, const Sources& sources, const Tool& tool,
                         std::span<const AllowedFinding> allowed = {});

/// Workflow commands of GitHub Actions, a line each: `::warning file=…,line=…::…`. Notes and the suggestion stand in
/// the message.
std::string render_github(std::span<const Diagnostic> diagnostics, const Sources& sources);

/// One such command, for what is no diagnostic; line 0: of the file as a whole.
std::string github_command(Severity severity, const std::string& file, std::uint32_t line, const std::string& title,
                           const std::string& message);

/// All findings as text, sorted; empty where there are none.
std::string render_text(const Findings& findings, bool color);

/// All findings as JSON, sorted.
std::string render_json(const Findings& findings);

}  // namespace rmpl::grammar
