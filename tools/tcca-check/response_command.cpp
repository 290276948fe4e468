// tcca-check response.
// SPDX-License-Identifier: MIT
#include <memory>

#include "tools/shared/models.hpp"
#include "tools/tcca-check/commands.hpp"
#include "tools/tcca-check/property_check.hpp"

namespace rmpl::tools {
namespace {

struct Options : PropertyOptions {
  std::string after, then;
  automata::Ticks within;
};

ExitStatus run(const Options& options, const Common& common) {
  const std::string title =
      "response " + options.after + " within " + automata::format_seconds(options.within) + " s " + options.then;
  return check_property(options, common, title, [&](const automata::Plant& plant) {
    return verifier::Response{formula_option(options.after, plant, "--after", common),
                              formula_option(options.then, plant, "--within", common), options.within};
  });
}

}  // namespace

void add_response(Program& program) {
  CLI::App* command = program.app().add_subcommand(
      "response", "whenever one formula holds, does another follow in time? no: a timed counterexample");
  const auto options = std::make_shared<Options>();
  add_text(*command, "--after", options->after, "FORMULA", "what asks for the response, each time it holds")
      ->required();
  const auto take = [options](const std::vector<std::string>& words) {
    try {
      options->within = duration(words[0]);
    } catch (const CLI::ValidationError& error) {
      throw CLI::ValidationError("--within", error.what());
    }
    options->then = words[1];
  };
  command->add_option_function<std::vector<std::string>>("--within", take, "how soon, and what the response is")
      ->type_name("T FORMULA")
      ->option_text("T FORMULA")
      ->required()
      ->expected(2);
  add_property_options(*command, *options, program.common());
  program.add({command, [options, &common = program.common()] { return run(*options, common); }});
}

}  // namespace rmpl::tools
