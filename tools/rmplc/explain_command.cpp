// rmplc explain: what a diagnostic means.
// SPDX-License-Identifier: MIT
#include <memory>
#include <string_view>

#include "base/error.hpp"
#include "grammar/source/codes.hpp"
#include "tools/rmplc/commands.hpp"

namespace rmpl::tools {
namespace {

std::string indented(std::string_view text) {
  std::string result = "  ";
  for (const char c : text) result += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return result;
}

ExitStatus run(const std::string& text) {
  const auto code = grammar::find_code(text);
  if (!code) throw base::InputError("'" + text + "' is not a diagnostic code; expected one such as RMPL0100");
  const grammar::CodeInfo& info = grammar::info(*code);
  print(std::string(grammar::to_string(*code)) + ": " + std::string(info.title) + "\n\n" +
        std::string(info.explanation) + "\n\nwrong:\n" + indented(info.wrong) + "\n\nright:\n" + indented(info.right) +
        "\n");
  return ExitStatus::done;
}

}  // namespace

void add_explain(Program& program) {
  CLI::App* command = program.app().add_subcommand("explain", "tell what a diagnostic means, with an example");
  const auto code = std::make_shared<std::string>();
  command->add_option("CODE", *code, "as in the diagnostic: RMPL0301")->required();
  program.add({command, [code] { return run(*code); }});
}

}  // namespace rmpl::tools
