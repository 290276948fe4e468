// rmplc lint, rmplc check: what compiles, and is most likely meant otherwise.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/output_file.hpp"
#include "base/printable.hpp"
#include "base/rewrite_file.hpp"
#include "compiler/lint/fixes.hpp"
#include "compiler/lint/lint.hpp"
#include "compiler/session/files.hpp"
#include "compiler/session/provider.hpp"
#include "grammar/source/render.hpp"
#include "tools/rmplc/commands.hpp"
#include "tools/rmplc/project/baseline.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

using grammar::Diagnostic;
using grammar::Severity;
using grammar::Sources;

enum class LintForm { text, json, sarif, github };

struct LintOptions {
  std::vector<std::string> files;
  std::string main;
  std::optional<Severity> level;
  LintForm form = LintForm::text;
  bool fix = false;
  std::string baseline;        ///< findings that are known; empty: as the project has it
  std::string write_baseline;  ///< where to write those that there are now; empty: nowhere
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

/// Of what is allowed SARIF alone tells.
std::string rendered(LintForm form, std::span<const Diagnostic> found, const Sources& sources, bool color,
                     std::span<const grammar::AllowedFinding> allowed = {}) {
  switch (form) {
    case LintForm::json:
      return base::printable_json(grammar::render_json(found, sources));
    case LintForm::sarif:
      return base::printable_json(
          grammar::render_sarif(found, sources, {"rmplc", RMPL_VERSION, RMPL_HOMEPAGE}, allowed));
    case LintForm::github:
      return grammar::render_github(found, sources);
    case LintForm::text:
      break;
  }
  return grammar::render_text(found, sources, color);
}

/// Monitors speak of a plant. Where nothing else is named, it is the one of the project's set that has them.
void add_plant_of_monitors(LintOptions& options, const Settings& settings) {
  const auto are_monitors = [](const std::string& path) { return path.ends_with(".mon"); };
  if (!std::all_of(options.files.begin(), options.files.end(), are_monitors)) return;
  std::set<std::string> plants;
  for (const ManifestSet& set : settings.manifest ? settings.manifest->sets : std::vector<ManifestSet>()) {
    if (set.monitors.empty()) continue;
    const SetFiles files = files_of(*settings.manifest, set);
    const auto is_of_set = [&](const std::string& path) {
      return std::any_of(files.monitors.begin(), files.monitors.end(), [&](const std::string& other) {
        std::error_code error;
        return std::filesystem::equivalent(path, other, error);
      });
    };
    if (std::all_of(options.files.begin(), options.files.end(), is_of_set)) plants.insert(files.plant);
  }
  if (plants.empty()) {
    throw base::InputError(options.files.front() + ": monitors refer to a plant; give its .tcca file too");
  }
  options.files.insert(options.files.begin(), plants.begin(), plants.end());
}

/// An input set that was compiled. Of component types without a plant, as a library has them, there is nothing to
/// prove: they are compiled by themselves, and not linted.
struct Input {
  compiler::Compilation compilation;
  bool library = false;
};

compiler::Options all_kinds(const LintOptions& options) {
  return {.main = options.main, .properties = true, .monitors = true};
}

Input compiled(const LintOptions& options) {
  check_standard_input(options.files);
  compiler::Compilation whole = compiler::compile(options.files, all_kinds(options));
  const auto& found = whole.findings().diagnostics.all();
  const bool types = std::all_of(options.files.begin(), options.files.end(),
                                 [](const std::string& path) { return path.ends_with(".tcca"); });
  const bool library = types && std::any_of(found.begin(), found.end(),
                                            [](const Diagnostic& one) { return one.code == grammar::Code::no_plant; });
  if (!library) return {std::move(whole)};
  compiler::Options library_options = all_kinds(options);
  library_options.types_suffice = true;
  return {compiler::compile(options.files, library_options), true};
}

/// What is known, by the option or else by the project: nothing where it is written anew.
Baseline known_findings(const LintOptions& options, const Settings& settings) {
  if (!options.write_baseline.empty()) return {};
  if (!options.baseline.empty()) return Baseline(options.baseline);
  const std::string path = settings.manifest ? baseline_of(*settings.manifest) : "";
  return path.empty() ? Baseline() : Baseline(path);
}

/// Leaves out what is known, and says what of it is there no more. In a project other files may have that.
void forget(Baseline known, std::vector<Diagnostic>& found, const Sources& sources, const LintOptions& options,
            const Common& common) {
  found = known.unknown(found, sources);
  const std::size_t unmet = options.baseline.empty() ? 0 : known.unmet();
  if (unmet == 0 || common.quiet) return;
  tell(options.baseline + ": " + std::to_string(unmet) + " known " + (unmet == 1 ? "finding" : "findings") +
       " no longer found: update the baseline with --write-baseline");
}

/// What is to be told of it, sorted: where it did not compile, everything.
std::vector<Diagnostic> found_in(const compiler::Compilation& compilation, const LintOptions& options,
                                 const Settings& settings, bool library,
                                 std::vector<grammar::AllowedFinding>& allowed) {
  allowed.clear();
  std::vector<Diagnostic> found = compilation.findings().diagnostics.sorted();
  if (!compilation.ok()) return found;
  if (!library) found = compiler::lint(compilation, settings.lint, allowed).sorted();
  const Severity level = options.level.value_or(settings.level.value_or(Severity::warning));
  std::erase_if(found, [&](const Diagnostic& finding) { return finding.severity < level; });
  std::erase_if(allowed, [&](const grammar::AllowedFinding& one) { return one.finding.severity < level; });
  return found;
}

/// Of programs without a plant it is not known whether what they speak of is there: that is told.
void tell_what_is_missing(const compiler::Compilation& compilation, const Common& common) {
  const automata::Document& document = compilation.document();
  const bool bound = !document.plants.empty() || !document.models.empty();
  if (common.quiet || bound || document.programs.empty()) return;
  tell("no plant among the files: components and modes that '" + document.programs.front().name +
       "' mentions are not checked");
}

void tell_library(const Common& common) {
  if (common.quiet) return;
  tell("no plant among the files: component types are compiled one by one, and lint proves nothing about them");
}

/// An input set with its findings, and what fixes make of it.
struct Mending {
  compiler::Compilation compilation;
  std::vector<Diagnostic> found;             ///< with what is known
  std::map<std::string, std::string> texts;  ///< by name of a file, those that changed
  std::size_t count = 0;                     ///< findings that are fixed
  std::vector<grammar::AllowedFinding> allowed;
};

bool is_standard_input(const Sources& sources, std::uint32_t file) { return sources[file].name() == "<stdin>"; }

/// One round of fixes, in memory. What is known and standard input are left as they are. Whether there was any.
bool mend(Mending& mending, compiler::Overlay& texts, Baseline known, const LintOptions& options,
          const Settings& settings) {
  const Sources& sources = mending.compilation.findings().sources;
  std::vector<Diagnostic> on_disk = known.unknown(mending.found, sources);
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
  mending.compilation = compiler::compile(options.files, all_kinds(options), texts);
  CHECK(mending.compilation.ok() && "a fix that is sure leaves what compiles");
  mending.found = found_in(mending.compilation, options, settings, false, mending.allowed);
  return true;
}

/// Fixes until there is nothing left to fix, as one may bring another, and then rewrites the files.
void fix(Mending& mending, const Baseline& known, const LintOptions& options, const Common& common,
         const Settings& settings) {
  compiler::Disk disk;
  compiler::Overlay texts(disk);
  constexpr std::size_t most = 100;
  for (std::size_t round = 0; round < most && mend(mending, texts, known, options, settings); ++round) continue;
  for (const auto& [name, text] : mending.texts) base::rewrite_file(name, text);
  if (common.quiet || mending.count == 0) return;
  print_error(std::to_string(mending.count) + (mending.count == 1 ? " finding" : " findings") + " fixed in " +
              std::to_string(mending.texts.size()) + (mending.texts.size() == 1 ? " file\n" : " files\n"));
}

ExitStatus run_lint(const LintOptions& options, const Common& common, const Settings& settings) {
  auto [compilation, library] = compiled(options);
  std::vector<grammar::AllowedFinding> allowed;
  std::vector<Diagnostic> all = found_in(compilation, options, settings, library, allowed);
  if (!compilation.ok()) {
    // For programs the errors are the result; people find them where all errors are.
    const bool to_people = options.form == LintForm::text;
    const bool color = to_people && error_painter(common.color).color;
    (to_people ? print_error : print)(rendered(options.form, all, compilation.findings().sources, color));
    throw Rejected{};
  }
  const Baseline known = known_findings(options, settings);
  if (library) tell_library(common);
  Mending mending{std::move(compilation), std::move(all), {}, 0, std::move(allowed)};
  if (options.fix && !library) fix(mending, known, options, common, settings);
  const Sources& sources = mending.compilation.findings().sources;
  std::vector<Diagnostic>& found = mending.found;
  if (!options.write_baseline.empty()) {
    base::write_file(options.write_baseline, to_baseline(found, sources, options.write_baseline));
    return ExitStatus::done;
  }
  forget(known, found, sources, options, common);
  print(rendered(options.form, found, sources, output_painter(common.color).color, mending.allowed));
  return found.empty() ? ExitStatus::done : ExitStatus::violated;
}

ExitStatus run_check(const LintOptions& options, const Common& common, const Settings& settings) {
  const auto [compilation, library] = compiled(options);
  std::vector<grammar::AllowedFinding> allowed;
  auto found = found_in(compilation, options, settings, library, allowed);
  const Sources& sources = compilation.findings().sources;
  if (compilation.ok()) forget(known_findings(options, settings), found, sources, options, common);
  if (!found.empty()) {
    const LintForm form = common.format == Format::json ? LintForm::json : LintForm::text;
    print_error(rendered(form, found, sources, error_painter(common.color).color));
  }
  if (!compilation.ok()) throw Rejected{};
  if (library) {
    tell_library(common);
  } else {
    tell_what_is_missing(compilation, common);
  }
  return found.empty() ? ExitStatus::done : ExitStatus::violated;
}

/// What both take.
void add_inputs(Command& command, LintOptions& options) {
  command.add_option("FILE", options.files, "sources, scenarios, properties and monitors").required();
  command.add_option("--main", options.main, "start the control program at this definition").option_text("NAME");
  add_choice<std::optional<Severity>>(
      command, "--level", options.level,
      {{"error", Severity::error}, {"warning", Severity::warning}, {"note", Severity::note}},
      "the lowest severity of findings that count (default: warning)");
}

}  // namespace

void add_lint(Program& program) {
  Command command = program.add_command("lint", "find probable mistakes, by proof");
  const auto options = std::make_shared<LintOptions>();
  add_inputs(command, *options);
  add_choice<LintForm>(
      command, "--format", options->form,
      {{"text", LintForm::text}, {"json", LintForm::json}, {"sarif", LintForm::sarif}, {"github", LintForm::github}},
      "the format of findings (default: text)");
  command.add_flag("--fix", options->fix, "apply every fix that is certain, and report the other findings");
  Option known = command.add_option("--baseline", options->baseline, "omit the findings that this file lists");
  known.option_text("FILE.json");
  command.add_option("--write-baseline", options->write_baseline, "write the findings to this file, and report none")
      .option_text("OUT.json")
      .excludes(known)
      .excludes(command.option("--fix"));
  command.footer(lint_notes);
  program.add({command, [options, &program] {
                 add_plant_of_monitors(*options, program.settings());
                 return run_lint(*options, program.common(), program.settings());
               }});
}

void add_check(Program& program) {
  Command command = program.add_command("check", "compile and lint, and write nothing");
  const auto options = std::make_shared<LintOptions>();
  add_inputs(command, *options);
  add_diagnostics_format(command, program.common());
  command.footer(check_notes);
  program.add({command, [options, &program] {
                 add_plant_of_monitors(*options, program.settings());
                 return run_check(*options, program.common(), program.settings());
               }});
}

}  // namespace rmpl::tools
