// From exceptions to exit codes, in one place.
// SPDX-License-Identifier: MIT
#include "tools/shared/program.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <exception>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/limit_error.hpp"
#include "base/printable.hpp"
#include "tools/shared/complaint.hpp"
#include "tools/shared/completion.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/last_words.hpp"

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

}  // namespace

Program::Program(const char* name, const char* version, const char* description, const char* notes) {
  exit_is_a_failure();
  occupy_standard_descriptors();
  clean_up_on_signals();
  name_program(name);
  app_.name(name);
  app_.description(description);
  app_.set_version_flag("--version", std::string(name) + " " + version, "print the version and end");
  app_.set_help_flag("-h,--help", "print this help and end");
  app_.footer(notes);
  app_.require_subcommand(1);
  app_.fallthrough();
  app_.formatter(std::make_shared<Help>());
  add_common(app_, common_);
}

ExitStatus Program::parse_and_run(int count, const char* const* arguments) {
  finish_options(app_);
  // For the installation only, and therefore no option: what the shells are told is what the parser knows.
  if (count == 3 && std::string_view(arguments[1]) == "--completion") {
    print(completion(app_, arguments[2]));
    return ExitStatus::done;
  }
  try {
    app_.parse(count, arguments);
    for (const Subcommand& command : commands_) {
      if (!command.app->parsed()) continue;
      take_settings(*command.app);
      base::limit_inputs(common_.max_input);
      return command.run();
    }
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      print_error(base::printable(complaint(app_, error)));
      return ExitStatus::wrong_input;
    }
    std::ostringstream text;  // help or version
    app_.exit(error, text, text);
    print(text.str());
  }
  return ExitStatus::done;
}

static std::string not_a_switch(const std::string& path, const std::string& name, const std::string& value) {
  return path + ": '" + name + "' is true or false, not '" + value + "'";
}

/// What the command line does not say is as the settings have it.
void Program::take_settings(const CLI::App& command) {
  settings_ = find_settings(first_file(command));
  for (const auto& [name, value] : settings_.options) {
    CLI::Option* option = app_.get_option("--" + name);
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

int Program::run(int count, const char* const* arguments) noexcept {
  ExitStatus status = ExitStatus::done;
  try {
    status = parse_and_run(count, arguments);
  } catch (const Rejected&) {
    status = ExitStatus::wrong_input;
  } catch (const base::InputError& error) {
    tell(error.what());
    status = ExitStatus::wrong_input;
  } catch (const base::LimitError& error) {
    tell(error.what());
    status = ExitStatus::undecided;
  } catch (const std::exception& error) {
    const bool memory = tells_lack_of_memory(error);
    tell(memory ? "out of memory" : std::string("internal error, nothing is claimed: ") + error.what());
    status = memory ? ExitStatus::undecided : ExitStatus::internal_error;
  }
  exit_is_ours();
  return static_cast<int>(status);
}

}  // namespace rmpl::tools
