// From exceptions to exit codes, in one place.
// SPDX-License-Identifier: MIT
#include "tools/shared/program.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/junit.hpp"
#include "base/limit_error.hpp"
#include "base/printable.hpp"
#include "tools/shared/complaint.hpp"
#include "tools/shared/completion.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/last_words.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

/// Descriptors 0 to 2 are taken, so that no file that is opened later becomes standard output by chance. What was
/// closed still fails, for it is opened the wrong way round.
void occupy_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
    if (::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) != descriptor) std::terminate();
  }
}

/// Help without the words of a parser: an option, what it takes, what it does.
class Help final : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string& text = option->get_option_text();
    if (!text.empty()) return " " + text;
    if (option->get_positional() || option->get_expected_max() == 0) return {};
    return " " + option->get_type_name();
  }
  std::string make_option_desc(const CLI::Option* option) const override {
    return option->get_description() + (option->get_required() && !option->get_positional() ? " (required)" : "");
  }
};

/// A flag takes no value, whatever the parser would make of `--flag=false`; and what an option takes is called in
/// errors what it is called in help.
void finish_options(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_expected_max() == 0 && option->get_configurable()) option->disable_flag_override();
    if (!option->get_option_text().empty()) option->type_name(option->get_option_text());
  }
  for (CLI::App* inner : app.get_subcommands(nullptr)) finish_options(*inner);
}

/// The first of the files that a command line names; empty where it names none.
std::string first_file(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() && option->count() > 0) return option->results().front();
  }
  return "";
}

/// Options that stand in the manifest for a subcommand, but for those that the command line gives.
void take_defaults(CLI::App& command, const Manifest& manifest, const std::map<std::string, ManifestText>& given) {
  for (const auto& [name, value] : given) {
    CLI::Option* option = command.get_option_no_throw("--" + name);
    if (option == nullptr || option == command.get_help_ptr()) {
      std::vector<std::string> names;
      for (const CLI::Option* one : command.get_options()) {
        for (const std::string& known : one->get_lnames()) names.push_back(known);
      }
      std::erase(names, "help");
      manifest.fail(value, command.get_name() + " has no option '" + name + "'" +
                               suggestion_or_list(name, {names.begin(), names.end()}));
    }
    if (option->count() > 0) continue;
    const bool is_switch = option->get_expected_max() == 0;
    if (is_switch && value.text != "true" && value.text != "false") {
      manifest.fail(value, "'" + name + "' is true or false, not '" + value.text + "'");
    }
    if (is_switch && value.text == "false") continue;
    try {
      option->add_result(value.text);
      option->run_callback();
    } catch (const CLI::Error& error) {
      manifest.fail(value, error.what());
    }
  }
}

/// Why there is no answer, as the one test case of a suite: the files that the subcommand was to read.
std::string failure_as_junit(const CLI::App& app, const std::string& text) {
  std::string suite = app.get_name(), files;
  for (const CLI::App* command : app.get_subcommands()) {
    suite += " " + command->get_name();
    for (const CLI::Option* option : command->get_options()) {
      if (!option->get_positional()) continue;
      for (const std::string& file : option->results()) files += (files.empty() ? "" : " ") + file;
    }
  }
  return base::to_junit(suite, {base::no_answer(files.empty() ? suite : files, suite, text)});
}

}  // namespace

Program::Program(const char* name, const char* version, const char* description, const char* notes)
    : app_(std::make_unique<CLI::App>()) {
  exit_is_a_failure();
  occupy_standard_descriptors();
  note_signals(name);
  name_program(name);
  app_->name(name);
  app_->description(description);
  app_->set_version_flag("--version", std::string(name) + " " + version, "print the version and exit");
  app_->set_help_flag("-h,--help", "print this help and exit");
  app_->footer(notes);
  app_->require_subcommand(1);
  app_->fallthrough();
  app_->formatter(std::make_shared<Help>());
  Command top(app_.get());
  add_common(top, common_);
}

Program::~Program() = default;

Command Program::add_command(const char* name, const char* description) {
  return Command(app_->add_subcommand(name, description));
}

ExitStatus Program::parse_and_run(int count, const char* const* arguments) {
  finish_options(*app_);
  // For the installation only, and therefore no option: what the shells are told is what the parser knows.
  if (count == 3 && std::string_view(arguments[1]) == "--completion") {
    print_file(completion(*app_, arguments[2]));
    return ExitStatus::done;
  }
  // `help lint` is `lint --help`, and `help` alone `--help`.
  std::vector<const char*> words(arguments, arguments + count);
  if (count > 1 && count <= 3 && std::string_view(words[1]) == "help") {
    words.erase(words.begin() + 1);
    const auto subcommands = app_->get_subcommands(nullptr);
    const bool known = count == 2 || std::any_of(subcommands.begin(), subcommands.end(),
                                                 [&](const CLI::App* one) { return one->get_name() == words.back(); });
    if (known) words.push_back("--help");
  }
  try {
    app_->parse(static_cast<int>(words.size()), words.data());
    for (const Subcommand& command : commands_) {
      CLI::App& parser = command.command.parser();
      if (!parser.parsed()) continue;
      if (command.at_signal == AtSignal::end) end_at_signals();
      take_settings(parser);
      base::limit_inputs(common_.max_input);
      base::end_inputs_when(interrupted);
      return command.run();
    }
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      print_error(base::printable(complaint(*app_, error)));
      return ExitStatus::wrong_input;
    }
    std::ostringstream text;  // help or version
    app_->exit(error, text, text);
    print(text.str());
  }
  return ExitStatus::done;
}

static std::string not_a_switch(const std::string& path, const std::string& name, const std::string& value) {
  return path + ": '" + name + "' is true or false, not '" + value + "'";
}

/// What the command line does not say is as the settings have it.
void Program::take_settings(CLI::App& command) {
  settings_ = find_settings(first_file(command));
  if (settings_.manifest) take_defaults(command);
  for (const auto& [name, value] : settings_.options) {
    CLI::Option* option = app_->get_option("--" + name);
    if (option->count() > 0) continue;
    if (option->get_expected_max() == 0) {
      if (value != "true" && value != "false") {
        throw base::InputError(not_a_switch(settings_.path, name, value));
      }
      (name == "quiet" ? common_.quiet : common_.verbose) = value == "true";
      continue;
    }
    try {
      option->add_result(value);
      option->run_callback();
    } catch (const CLI::Error& error) {
      throw base::InputError(settings_.path + ": " + error.what());
    }
  }
}

void Program::take_defaults(CLI::App& command) const {
  const Manifest& manifest = *settings_.manifest;
  std::vector<std::string> names;
  for (const CLI::App* one : app_->get_subcommands(nullptr)) names.push_back(one->get_name());
  const std::string prefix = app_->get_name() + ".";
  for (const auto& [table, options] : manifest.options) {
    if (!table.starts_with(prefix)) continue;
    const std::string name = table.substr(prefix.size());
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      std::string what = "[" + table;
      what.append("]: ").append(app_->get_name()).append(" has no subcommand '").append(name).append("'");
      manifest.fail(options.begin()->second, what + suggestion_or_list(name, {names.begin(), names.end()}));
    }
    if (name == command.get_name()) tools::take_defaults(command, manifest, options);
  }
}

/// A service that reads JUnit finds what went wrong there too, and no empty file.
void Program::print_failure(const std::string& text) noexcept {
  if (common_.format != Format::junit || output_is_begun()) return;
  try {
    print(failure_as_junit(*app_, text));
  } catch (const std::exception&) {
    // Standard output cannot be written; what went wrong first is told already.
  }
}

int Program::run(int count, const char* const* arguments) noexcept {
  ExitStatus status = ExitStatus::done;
  const auto fail = [&](ExitStatus as, const std::string& why) {
    tell(why);
    print_failure(why + "\n");
    status = as;
  };
  try {
    status = parse_and_run(count, arguments);
  } catch (const Rejected& rejected) {
    print_failure(rejected.text);
    status = ExitStatus::wrong_input;
  } catch (const base::InputError& error) {
    fail(ExitStatus::wrong_input, error.what());
  } catch (const base::LimitError& error) {
    fail(ExitStatus::undecided, error.what());
  } catch (const std::exception& error) {
    const bool memory = tells_lack_of_memory(error);
    fail(memory ? ExitStatus::undecided : ExitStatus::internal_error,
         memory ? "out of memory" : std::string("internal error, so there is no result: ") + error.what());
  }
  exit_is_ours();
  return static_cast<int>(status);
}

}  // namespace rmpl::tools
