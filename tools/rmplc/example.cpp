// The notation of examples, and what is run on them where they do not say.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/example.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "compiler/lint/lint.hpp"
#include "compiler/session/files.hpp"

namespace rmpl::tools {
namespace {

/// The file that a line begins: `// plant.tcca`.
std::optional<std::string> heading(std::string_view line) {
  constexpr std::string_view start = "// ";
  if (!line.starts_with(start)) return std::nullopt;
  line.remove_prefix(start.size());
  const std::size_t dot = line.rfind('.');
  if (dot == std::string_view::npos || line.find(' ') != std::string_view::npos) return std::nullopt;
  for (const std::string_view extension : {"tcca", "rmpl", "scn", "props", "mon", "json", "bench", "ini"}) {
    if (line.substr(dot + 1) == extension) return std::string(line);
  }
  return std::nullopt;
}

std::string name_by_content(std::string_view text) {
  const compiler::Kind kind = compiler::kind_by_content(text);
  if (kind == compiler::Kind::plant) return "plant.tcca";
  if (kind == compiler::Kind::document) return "document.json";
  return kind == compiler::Kind::scenario ? "test.scn" : "main.rmpl";
}

/// Whether a file names another one, as an import does.
bool is_named(const ExampleFile& file, const std::vector<ExampleFile>& files) {
  const std::string quoted = '"' + file.name + '"';
  return std::any_of(files.begin(), files.end(),
                     [&](const ExampleFile& other) { return other.text.find(quoted) != std::string::npos; });
}

/// The program that tells the finding, with its options.
std::string program(grammar::Code code, const std::vector<ExampleFile>& files) {
  constexpr int lint = 5;
  if (static_cast<int>(code) / 100 == lint) {
    const compiler::LintCode* found = compiler::find_lint_code(code);
    const bool note = found != nullptr && found->level == grammar::Severity::note;
    return note ? "rmplc lint --level note" : "rmplc lint";
  }
  const auto has = [&](std::string_view extension) {
    return std::any_of(files.begin(), files.end(), [&](const auto& file) { return file.name.ends_with(extension); });
  };
  if (has(".mon") && !has(".scn")) return "rmplc check";
  if (has(".bench")) return "rmplc import -o circuit.tcca";
  return has(".props") ? "tcca-check check" : "rmplc compile -o model.json";
}

std::string command(grammar::Code code, const std::vector<ExampleFile>& files) {
  const auto named = [&](const ExampleFile& file) { return is_named(file, files); };
  const bool in_a_circle = std::all_of(files.begin(), files.end(), named);
  std::string line = program(code, files);
  for (const ExampleFile& file : files) {
    if (in_a_circle || !named(file)) line += " " + file.name;
  }
  return line;
}

}  // namespace

Example example(const grammar::CodeInfo& info, std::string_view text) {
  Example result;
  bool in_file = false;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string line(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!in_file && line.starts_with("$ ")) {
      result.commands.push_back(line.substr(2));
      continue;
    }
    const auto name = heading(line);
    if (name || !in_file) result.files.push_back({name.value_or(""), ""});
    if (!name) result.files.back().text += line + "\n";
    in_file = true;
  }
  for (ExampleFile& file : result.files) {
    if (file.name.empty()) file.name = name_by_content(file.text);
  }
  if (result.commands.empty()) result.commands.push_back(command(info.code, result.files));
  return result;
}

}  // namespace rmpl::tools
