// rmplc lint, rmplc check: what compiles, and is most likely meant otherwise.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "base/check.hpp"
#include "base/rewrite_file.hpp"
#include "compiler/lint/fixes.hpp"
#include "compiler/lint/lint.hpp"
#include "compiler/session/files.hpp"
#include "compiler/session/provider.hpp"
#include "grammar/source/render.hpp"
#include "tools/rmplc/commands.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

using grammar::Diagnostic;
using grammar::Severity;
using grammar::Sources;

enum class Form { text, json, sarif, github };

struct Options {
  std::vector<std::string> files;
  std::string main;
  std::optional<Severity> level;
  Form form = Form::text;
  bool fix = false;
};

constexpr const char* lint_notes =
    R"(Compiles the files as one input set, and looks for what can never hold or happen, is
there for nothing, or is most likely meant otherwise. Findings go to standard output;
sarif is for code scanning, github annotates a pull request from a workflow.
`// lint: allow RMPL0514 because …` on the line before, or at the end of the line,
allows one. The file rmpl.ini sets levels: see rmpl.ini(5).

Exit status: 0 nothing at or above the level, 1 findings, 2 the input is wrong.

Examples:
  rmplc lint mars_entry.scn
  rmplc lint --format sarif power.tcca power.rmpl power.props)";

constexpr const char* check_notes =
    R"(Compiles the files as one input set and writes nothing. Diagnostics, and what
`rmplc lint` finds, go to standard error.

Exit status: 0 nothing at or above the level, 1 findings, 2 the input is wrong.

Example:
  rmplc check mars_entry.rmpl mars_lander.tcca)";

std::string rendered(Form form, std::span<const Diagnostic> found, const Sources& sources, bool color) {
  switch (form) {
    case Form::json:
      return grammar::render_json(found, sources);
    case Form::sarif:
      return grammar::render_sarif(found, sources, {"rmplc", RMPL_VERSION});
    case Form::github:
      return grammar::render_github(found, sources);
    case Form::text:
      break;
  }
  return grammar::render_text(found, sources, color);
}

compiler::Compilation compiled(const Options& options) {
  check_standard_input(options.files);
  return compiler::compile(options.files, {options.main, true});
}

/// What is to be told of it, sorted: where it did not compile, everything.
std::vector<Diagnostic> found_in(const compiler::Compilation& compilation, const Options& options,
                                 const Settings& settings) {
  if (!compilation.ok()) return compilation.findings().diagnostics.sorted();
  std::vector<Diagnostic> found = compiler::lint(compilation, settings.lint).sorted();
  const Severity level = options.level.value_or(settings.level.value_or(Severity::warning));
  std::erase_if(found, [&](const Diagnostic& finding) { return finding.severity < level; });
  return found;
}

/// An input set with its findings, and what fixes make of it.
struct Mending {
  compiler::Compilation compilation;
  std::vector<Diagnostic> found;
  std::map<std::string, std::string> texts;  ///< by name of a file, those that changed
  std::size_t count = 0;                     ///< findings that are fixed
};

bool is_standard_input(const Sources& sources, std::uint32_t file) { return sources[file].name() == "<stdin>"; }

/// One round of fixes, in memory. Standard input is left as it is. Whether there was any.
bool mend(Mending& mending, compiler::Overlay& texts, const Options& options, const Settings& settings) {
  const Sources& sources = mending.compilation.findings().sources;
  std::vector<Diagnostic> on_disk = mending.found;
  std::erase_if(on_disk, [&](const Diagnostic& one) { return is_standard_input(sources, one.span.file); });
  const compiler::Fixed fixed = compiler::apply_fixes(on_disk, sources);
  if (fixed.count == 0) return false;
  mending.count += fixed.count;
  for (const compiler::File& file : mending.compilation.files()) {
    if (is_standard_input(sources, file.index)) texts.put("-", std::string(sources[file.index].text()));
  }
  for (const auto& [file, text] : fixed.texts) {
    texts.put(sources[file].name(), text);
    mending.texts[sources[file].name()] = text;
  }
  mending.compilation = compiler::compile(options.files, {options.main, true}, texts);
  CHECK(mending.compilation.ok() && "a fix that is sure leaves what compiles");
  mending.found = found_in(mending.compilation, options, settings);
  return true;
}

/// Fixes until there is nothing left to fix, as one may bring another, and then rewrites the files.
void fix(Mending& mending, const Options& options, const Common& common, const Settings& settings) {
  compiler::Disk disk;
  compiler::Overlay texts(disk);
  constexpr std::size_t most = 100;
  for (std::size_t round = 0; round < most && mend(mending, texts, options, settings); ++round) continue;
  for (const auto& [name, text] : mending.texts) base::rewrite_file(name, text);
  if (common.quiet || mending.count == 0) return;
  print_error(std::to_string(mending.count) + (mending.count == 1 ? " finding" : " findings") + " fixed in " +
              std::to_string(mending.texts.size()) + (mending.texts.size() == 1 ? " file\n" : " files\n"));
}

ExitStatus run_lint(const Options& options, const Common& common, const Settings& settings) {
  compiler::Compilation compilation = compiled(options);
  std::vector<Diagnostic> found = found_in(compilation, options, settings);
  if (!compilation.ok()) {
    // For programs the errors are the result; people find them where all errors are.
    const bool to_people = options.form == Form::text;
    const bool color = to_people && error_painter(common.color).color;
    (to_people ? print_error : print)(rendered(options.form, found, compilation.findings().sources, color));
    throw Rejected{};
  }
  Mending mending{std::move(compilation), std::move(found), {}, 0};
  if (options.fix) fix(mending, options, common, settings);
  const Sources& sources = mending.compilation.findings().sources;
  print(rendered(options.form, mending.found, sources, output_painter(common.color).color));
  return mending.found.empty() ? ExitStatus::done : ExitStatus::violated;
}

ExitStatus run_check(const Options& options, const Common& common, const Settings& settings) {
  const compiler::Compilation compilation = compiled(options);
  const auto found = found_in(compilation, options, settings);
  if (!found.empty()) {
    const Form form = common.format == Format::json ? Form::json : Form::text;
    print_error(rendered(form, found, compilation.findings().sources, error_painter(common.color).color));
  }
  if (!compilation.ok()) throw Rejected{};
  return found.empty() ? ExitStatus::done : ExitStatus::violated;
}

/// What both take.
void add_inputs(CLI::App& command, Options& options) {
  command.add_option("FILE", options.files, "sources, scenarios and properties")->required();
  command.add_option("--main", options.main, "start the control program at this definition")->option_text("NAME");
  add_choice<std::optional<Severity>>(
      command, "--level", options.level,
      {{"error", Severity::error}, {"warning", Severity::warning}, {"note", Severity::note}},
      "the least severe findings that count (default: warning)");
}

}  // namespace

void add_lint(Program& program) {
  CLI::App* command = program.app().add_subcommand("lint", "find what is most likely meant otherwise, by proof");
  const auto options = std::make_shared<Options>();
  add_inputs(*command, *options);
  add_choice<Form>(*command, "--format", options->form,
                   {{"text", Form::text}, {"json", Form::json}, {"sarif", Form::sarif}, {"github", Form::github}},
                   "the form of findings (default: text)");
  command->add_flag("--fix", options->fix, "rewrite the files where a finding has a sure fix, and tell the rest");
  command->footer(lint_notes);
  program.add({command, [options, &program] { return run_lint(*options, program.common(), program.settings()); }});
}

void add_check(Program& program) {
  CLI::App* command = program.app().add_subcommand("check", "compile and lint, and write nothing");
  const auto options = std::make_shared<Options>();
  add_inputs(*command, *options);
  add_diagnostics_format(*command, program.common());
  command->footer(check_notes);
  program.add({command, [options, &program] { return run_check(*options, program.common(), program.settings()); }});
}

}  // namespace rmpl::tools
