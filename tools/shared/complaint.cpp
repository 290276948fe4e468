// The parser's errors in the words of the house.
// SPDX-License-Identifier: MIT
#include "tools/shared/complaint.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "base/nearest.hpp"

namespace rmpl::automata {
namespace {

using Words = std::vector<std::string>;

std::string nearest_of(const std::string& word, const Words& words) { return base::suggestion(word, words); }

/// `a, b or c`.
std::string enumerated(const Words& words) {
  std::string text;
  for (std::size_t w = 0; w < words.size(); ++w) {
    if (w > 0) text += w + 1 == words.size() ? " or " : ", ";
    text += words[w];
  }
  return text;
}

/// The subcommands that were called, and the program itself.
std::vector<const CLI::App*> called(const CLI::App& app) {
  std::vector<const CLI::App*> apps;
  for (const CLI::App* command : app.get_subcommands()) apps.push_back(command);
  apps.push_back(&app);
  return apps;
}

std::string unknown_subcommand(const std::string& word, const CLI::App& app) {
  Words names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  const std::string near = nearest_of(word, names);
  return "unknown subcommand '" + word + "'" + (near.empty() ? "; expected " + enumerated(names) : near);
}

std::string unknown_option(std::string word, const CLI::App& app) {
  word.resize(std::min(word.find('='), word.size()));
  Words names;
  for (const CLI::App* of : called(app)) {
    for (const CLI::Option* option : of->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
      for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
  }
  const bool letter = word.size() <= 2;  // one letter is near no other
  return "unknown option '" + word + "'" + (letter ? "" : nearest_of(word, names));
}

/// The part of a text between two others that it has, one behind the other; nothing where it has not.
std::optional<std::string> between(const std::string& text, std::string_view before, std::string_view behind) {
  const std::size_t begin = text.find(before);
  if (begin == std::string::npos) return std::nullopt;
  const std::size_t end = text.find(behind, begin + before.size());
  if (end == std::string::npos) return std::nullopt;
  return text.substr(begin + before.size(), end - begin - before.size());
}

/// `a|b` of the parser's `…{a,b}`; any other description of a value as it is.
std::string choices(const std::string& description) {
  std::string words = between(description, "{", "}").value_or(description);
  std::replace(words.begin(), words.end(), ',', '|');
  return words;
}

/// The parser's own sentence, but for what it says clumsily. It begins with a capital, unless with the name of an
/// argument, which is capitals throughout.
std::string sentence(const CLI::ParseError& error) {
  std::string text = error.what();
  const std::string name = text.substr(0, text.find(':'));
  if (const auto value = between(text, ": ", " not in {")) {
    return name + ": expected " + choices(text.substr(text.rfind(" not in {"))) + ", not '" + *value + "'";
  }
  constexpr std::string_view range = " not in range ";
  if (const auto value = between(text, ": Value ", range)) {
    return name + ": expected a number from " + text.substr(text.rfind(range) + range.size()) + ", not '" + *value +
           "'";
  }
  if (const auto value = between(text, ": 1 required ", " missing")) return name + ": expected " + choices(*value);
  if (between(text, ": At Most 1 ", "received")) return name + ": given more than once";
  const auto is_upper = [](char c) { return c >= 'A' && c <= 'Z'; };
  if (text.size() > 1 && is_upper(text[0]) && !is_upper(text[1])) text[0] = static_cast<char>(text[0] - 'A' + 'a');
  return text;
}

std::string reason(const CLI::App& app, const CLI::ParseError& error) {
  // A word that nothing takes is the mistake, even where the parser first misses another.
  const Words left = app.remaining(true);
  const auto first = std::find_if(left.begin(), left.end(), [](const std::string& word) { return word != "--"; });
  if (first == left.end()) return sentence(error);
  const std::string& word = *first;
  if (word.size() > 1 && word.front() == '-') return unknown_option(word, app);
  return app.get_subcommands().empty() ? unknown_subcommand(word, app) : "unexpected argument '" + word + "'";
}

}  // namespace

std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
  std::string of = app.get_name();
  for (const CLI::App* command : app.get_subcommands()) of += " " + command->get_name();
  return app.get_name() + ": " + reason(app, error) + "\nsee " + of + " --help\n";
}

}  // namespace rmpl::automata
