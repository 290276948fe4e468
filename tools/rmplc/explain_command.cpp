// rmplc explain: what a diagnostic means, and which there are.
// SPDX-License-Identifier: MIT
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/error.hpp"
#include "compiler/lint/lint.hpp"
#include "grammar/source/codes.hpp"
#include "grammar/source/diagnostic.hpp"
#include "tools/rmplc/commands.hpp"
#include "tools/rmplc/example.hpp"

namespace rmpl::tools {
namespace {

using grammar::CodeInfo;
using Json = nlohmann::ordered_json;

/// How it is reported: at the level that lint gives it, or else as an error.
const char* level(const CodeInfo& info) {
  const compiler::LintCode* found = compiler::find_lint_code(info.code);
  return to_string(found == nullptr ? grammar::Severity::error : found->level);
}

/// Each paragraph in lines of at most 80 characters.
std::string wrapped(std::string_view text) {
  constexpr std::size_t width = 80;
  std::string result;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::size_t end = text.find_first_of(" \n");
    const std::string_view word = text.substr(0, end);
    if (column > 0 && column + 1 + word.size() > width) {
      result += '\n';
      column = 0;
    }
    if (column > 0) result += ' ';
    column += word.size() + (column > 0 ? 1 : 0);
    result += word;
    if (end == std::string_view::npos) break;
    if (text[end] == '\n') {
      result += '\n';
      column = 0;
    }
    text.remove_prefix(end + 1);
  }
  return result;
}

std::string indented(std::string_view text) {
  std::string result = "  ";
  for (const char c : text) result += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return result;
}

Json to_json(const Example& example) {
  Json files = Json::array();
  for (const ExampleFile& file : example.files) files.push_back({{"name", file.name}, {"text", file.text}});
  return {{"files", files}, {"commands", example.commands}};
}

Json to_json(const CodeInfo& info) {
  return {{"code", to_string(info.code)},
          {"level", level(info)},
          {"title", info.title},
          {"explanation", info.explanation},
          {"wrong", to_json(example(info, info.wrong))},
          {"right", to_json(example(info, info.right))}};
}

ExitStatus list(Format format) {
  Json codes = Json::array();
  std::string text;
  for (const CodeInfo& info : grammar::all_codes()) {
    if (format == Format::json) {
      codes.push_back(to_json(info));
      continue;
    }
    std::string column = level(info);
    column.resize(sizeof "warning", ' ');
    text += to_string(info.code) + "  " + column + " " + std::string(info.title) + "\n";
  }
  format == Format::json ? print_json(Json{{"codes", codes}}.dump(2) + "\n") : print(text);
  return ExitStatus::done;
}

ExitStatus explain(const std::string& text, Format format) {
  const auto code = grammar::find_code(text);
  if (!code) {
    throw base::InputError("'" + text +
                           "' is not a diagnostic code; expected one such as RMPL0100: see rmplc explain --list");
  }
  const CodeInfo& info = grammar::info(*code);
  if (format == Format::json) {
    print_json(Json{{"codes", Json::array({to_json(info)})}}.dump(2) + "\n");
    return ExitStatus::done;
  }
  print(to_string(*code) + ": " + std::string(info.title) + " (" + level(info) + ")\n\n" + wrapped(info.explanation) +
        "\n\nwrong:\n" + indented(info.wrong) + "\n\nright:\n" + indented(info.right) + "\n");
  return ExitStatus::done;
}

constexpr const char* explain_notes = R"(Exit status: 0 it is told, 2 there is no such code.

Examples:
  rmplc explain RMPL0301
  rmplc explain --list)";

}  // namespace

void add_explain(Program& program) {
  Command command = program.add_command("explain", "explain a diagnostic, with a wrong and a right example");
  const auto code = std::make_shared<std::string>();
  const auto all = std::make_shared<bool>(false);
  Option one = command.add_option("CODE", *code, "as in the diagnostic: RMPL0301");
  Option list_all = command.add_flag("--list", *all, "list all diagnostics");
  command.require_one(one, list_all);
  Common& common = program.common();
  add_format(command, common);
  command.footer(explain_notes);
  program.add({command, [code, all, &common] { return *all ? list(common.format) : explain(*code, common.format); }});
}

}  // namespace rmpl::tools
