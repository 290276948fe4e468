// rmplc lint, rmplc check: what compiles, and is most likely meant otherwise.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include "compiler/lint/lint.hpp"
#include "grammar/source/render.hpp"
#include "tools/rmplc/commands.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

using grammar::Diagnostic;
using grammar::Severity;

struct Options {
  std::vector<std::string> files;
  std::string main;
  Severity level = Severity::warning;
};

constexpr const char* lint_notes =
    R"(Compiles the files as one input set, and looks for what can never hold or happen, is
there for nothing, or is most likely meant otherwise. Findings go to standard output.

Exit status: 0 nothing at or above the level, 1 findings, 2 the input is wrong.

Example:
  rmplc lint mars_entry.scn)";

constexpr const char* check_notes =
    R"(Compiles the files as one input set and writes nothing. Diagnostics, and what
`rmplc lint` finds, go to standard error.

Exit status: 0 nothing at or above the level, 1 findings, 2 the input is wrong.

Example:
  rmplc check mars_entry.rmpl mars_lander.tcca)";

/// Compiles, or tells why not and throws Rejected.
compiler::Compilation compiled(const Options& options, const Common& common) {
  check_standard_input(options.files);
  compiler::Compilation compilation = compiler::compile(options.files, {options.main, true});
  if (compilation.ok()) return compilation;
  tell_findings(compilation.findings(), common);
  throw Rejected{};
}

/// What was found at or above the level, sorted.
std::vector<Diagnostic> found_in(const compiler::Compilation& compilation, Severity level) {
  std::vector<Diagnostic> found = compiler::lint(compilation).sorted();
  std::erase_if(found, [&](const Diagnostic& finding) { return finding.severity < level; });
  return found;
}

ExitStatus run_lint(const Options& options, const Common& common) {
  const compiler::Compilation compilation = compiled(options, common);
  const grammar::Sources& sources = compilation.findings().sources;
  const auto found = found_in(compilation, options.level);
  print(common.format == Format::json ? grammar::render_json(found, sources)
                                      : grammar::render_text(found, sources, output_painter(common.color).color));
  return found.empty() ? ExitStatus::done : ExitStatus::violated;
}

ExitStatus run_check(const Options& options, const Common& common) {
  const compiler::Compilation compilation = compiled(options, common);
  const grammar::Sources& sources = compilation.findings().sources;
  const auto found = found_in(compilation, options.level);
  if (!found.empty()) {
    print_error(common.format == Format::json
                    ? grammar::render_json(found, sources)
                    : grammar::render_text(found, sources, error_painter(common.color).color));
  }
  return found.empty() ? ExitStatus::done : ExitStatus::violated;
}

using Run = ExitStatus (*)(const Options&, const Common&);

void add(Program& program, const char* name, const char* description, const char* notes, Run run) {
  CLI::App* command = program.app().add_subcommand(name, description);
  const auto options = std::make_shared<Options>();
  command->add_option("FILE", options->files, "sources, scenarios and properties")->required();
  command->add_option("--main", options->main, "start the control program at this definition")->option_text("NAME");
  Common& common = program.common();
  add_diagnostics_format(*command, common);
  add_choice<Severity>(*command, "--level", options->level,
                       {{"error", Severity::error}, {"warning", Severity::warning}, {"note", Severity::note}},
                       "the least severe findings that count (default: warning)");
  command->footer(notes);
  program.add({command, [options, &common, run] { return run(*options, common); }});
}

}  // namespace

void add_lint(Program& program) {
  add(program, "lint", "find what is most likely meant otherwise, by proof", lint_notes, run_lint);
}

void add_check(Program& program) {
  add(program, "check", "compile and lint, and write nothing", check_notes, run_check);
}

}  // namespace rmpl::tools
