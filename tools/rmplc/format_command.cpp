// rmplc format: sources in the one style.
// SPDX-License-Identifier: MIT
#include <memory>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/rewrite_file.hpp"
#include "compiler/format/difference.hpp"
#include "compiler/format/format.hpp"
#include "tools/rmplc/commands.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

struct FormatOptions {
  std::vector<std::string> files;
  bool check = false;
  bool diff = false;
};

/// A file and what becomes of it.
struct Formatted {
  std::string path;
  std::string before;
  std::string after;
};

constexpr const char* format_notes =
    R"(Lays out .rmpl, .tcca, .scn, .props and .mon files in one style, in place: lines of at most
120 columns, tables aligned. Tokens and comments stay as they are; of blank lines at
most one stays. A file that is well laid out is not touched. `-` is standard input,
told by its content, and goes to standard output.

A file with syntax errors ends the command before any file is written. --check and
--diff write none. Lines end in LF; where some end in CR LF, that is told.

Exit status: 1 if --check or --diff find a file that would change.

Example:
  rmplc format --check *.rmpl *.tcca)";

compiler::Kind kind_of(const std::string& path, const std::string& text) {
  const auto kind = path == "-" ? compiler::kind_by_content(text) : compiler::kind_by_name(path);
  if (kind && *kind != compiler::Kind::document) return *kind;
  if (path == "-") throw base::InputError("standard input: expected source text, found a compiled document");
  throw base::InputError(path + ": expected a .rmpl, .tcca, .scn, .props or .mon file");
}

/// All files, formatted. Tells the errors of all of them; throws Rejected where there are any.
std::vector<Formatted> format_all(const std::vector<std::string>& paths, const Common& common) {
  grammar::Findings findings;
  std::vector<Formatted> all;
  for (const std::string& path : paths) {
    std::string text = base::read_file(path);
    const compiler::Kind kind = kind_of(path, text);
    const std::uint32_t file = findings.sources.add(path == "-" ? "standard input" : path, text);
    auto after = compiler::format(findings.sources, file, kind, findings.diagnostics);
    if (after) all.push_back({path, std::move(text), std::move(*after)});
  }
  tell_findings(findings, common);
  if (findings.diagnostics.has_errors()) throw Rejected{};
  return all;
}

ExitStatus run(const FormatOptions& options, const Common& common) {
  check_standard_input(options.files);
  std::string report;
  bool changes = false;
  for (const Formatted& file : format_all(options.files, common)) {
    const bool changed = file.before != file.after;
    if (!common.quiet && file.before.find("\r\n") != std::string::npos) {
      const bool writes = !options.check && !options.diff;
      tell(file.path + ": lines end in CR LF; " + (writes ? "they end in LF now" : "they would end in LF"));
    }
    changes = changes || changed;
    if (options.check) {
      if (changed && !options.diff) report += file.path + "\n";
    } else if (!options.diff) {
      if (file.path == "-") print_file(file.after);
      if (file.path != "-" && changed) base::rewrite_file(file.path, file.after);
    }
    if (options.diff) report += compiler::layout_difference(file.before, file.after, file.path);
  }
  if (!report.empty()) print_file(report);
  return changes && (options.check || options.diff) ? ExitStatus::violated : ExitStatus::done;
}

}  // namespace

void add_format(Program& program) {
  Command command = program.add_command("format", "lay out sources in the standard style");
  const auto options = std::make_shared<FormatOptions>();
  command.add_option("FILE", options->files, "sources; - is standard input").required();
  command.add_flag("--check", options->check, "write nothing; print the names of files that would change");
  command.add_flag("--diff", options->diff, "write nothing; print what would change");
  Common& common = program.common();
  add_diagnostics_format(command, common);
  command.footer(format_notes);
  program.add({command, [options, &common] { return run(*options, common); }});
}

}  // namespace rmpl::tools
