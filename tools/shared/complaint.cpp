// Rewrites the errors of the command-line parser in the style of the programs' own.
// SPDX-License-Identifier: MIT
#include "tools/shared/complaint.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "base/enumerated.hpp"
#include "base/nearest.hpp"

namespace rmpl::tools {
namespace {

using Words = std::vector<std::string>;

std::string nearest_of(const std::string& word, const Words& words) { return base::suggestion(word, words); }

/// The subcommands that were called, and the program itself.
std::vector<const CLI::App*> called(const CLI::App& app) {
  std::vector<const CLI::App*> apps;
  for (const CLI::App* command : app.get_subcommands()) apps.push_back(command);
  apps.push_back(&app);
  return apps;
}

Words names_of_subcommands(const CLI::App& app) {
  Words names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  return names;
}

std::string unknown_subcommand(const std::string& word, const CLI::App& app) {
  const Words names = names_of_subcommands(app);
  const std::string near = nearest_of(word, names);
  return "unknown subcommand '" + word + "'" + (near.empty() ? "; expected " + base::enumerated(names, "or") : near);
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
  const std::size_t end = behind.empty() ? text.size() : text.find(behind, begin + before.size());
  if (end == std::string::npos) return std::nullopt;
  return text.substr(begin + before.size(), end - begin - before.size());
}

/// What is missing: a subcommand, an argument, an option.
std::string missing(const CLI::App& app, const std::string& text) {
  if (text.starts_with("A subcommand"))
    return "expected a subcommand: " + base::enumerated(names_of_subcommands(app), "or");
  const std::string name = text.substr(0, text.find(' '));
  return name + ": is missing";
}

/// What the parser objects to, in our own words.
std::string sentence(const CLI::App& app, const CLI::ParseError& error) {
  std::string text = error.what();
  const std::string name = text.substr(0, text.find(':'));
  const std::string kind = error.get_name();
  if (kind == "RequiredError") return missing(app, text);
  if (kind == "RequiresError")
    return text.substr(0, text.find(' ')) + ": goes only with" + text.substr(text.rfind(' '));
  if (kind == "ExcludesError")
    return text.substr(0, text.find(' ')) + ": does not go with" + text.substr(text.rfind(' '));
  if (kind == "ArgumentMismatch") {
    if (const auto value = between(text, " required ", " missing")) return name + ": expected " + *value;
    if (text.find("disallowed flag override") != std::string::npos) {
      return text.substr(0, text.find(' ')) + ": takes no value";
    }
    return name + (between(text, ": At Most 1 ", "") ? ": given more than once" : ": given too few or too many words");
  }
  return text;  // ours: options are read by functions of the house
}

std::string reason(const CLI::App& app, const CLI::ParseError& error) {
  // A word that nothing takes is the mistake, even where the parser first misses another.
  const Words left = app.remaining(true);
  const auto first = std::find_if(left.begin(), left.end(), [](const std::string& word) { return word != "--"; });
  if (first == left.end()) return sentence(app, error);
  const std::string& word = *first;
  if (word.starts_with("-=")) return "'" + word.substr(1) + "': this option takes no value";
  if (word.size() > 1 && word.front() == '-') return unknown_option(word, app);
  return app.get_subcommands().empty() ? unknown_subcommand(word, app) : "unexpected argument '" + word + "'";
}

}  // namespace

std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
  std::string of = app.get_name();
  for (const CLI::App* command : app.get_subcommands()) of += " " + command->get_name();
  return app.get_name() + ": " + reason(app, error) + "\nsee " + of + " --help\n";
}

}  // namespace rmpl::tools
