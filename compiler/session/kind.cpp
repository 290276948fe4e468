// What a file holds: by its name, or by its first words.
// SPDX-License-Identifier: MIT
#include "compiler/session/kind.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace rmpl::compiler {

namespace {

/// Takes white space and comments from the front.
std::string_view trimmed(std::string_view text) {
  while (!text.empty()) {
    if (std::isspace(static_cast<unsigned char>(text.front())) != 0) {
      text.remove_prefix(1);
    } else if (text.substr(0, 2) == "//") {
      text.remove_prefix(std::min(text.find('\n'), text.size()));
    } else if (text.substr(0, 2) == "/*") {
      const auto end = text.find("*/", 2);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
    } else {
      break;
    }
  }
  return text;
}

/// Takes the word at the front, empty where there is none.
std::string_view take_word(std::string_view& text) {
  std::size_t length = 0;
  while (length < text.size() && (std::isalnum(static_cast<unsigned char>(text[length])) != 0 || text[length] == '_')) {
    ++length;
  }
  const std::string_view word = text.substr(0, length);
  text = trimmed(text.substr(length));
  return word;
}

}  // namespace

std::optional<Kind> kind_by_name(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".rmpl") return Kind::program;
  if (extension == ".tcca") return Kind::plant;
  if (extension == ".scn") return Kind::scenario;
  if (extension == ".props") return Kind::properties;
  if (extension == ".mon") return Kind::monitors;
  if (extension == ".json") return Kind::document;
  return std::nullopt;
}

std::string not_a_model(const std::string& path) {
  return path + ": expected a file named .rmpl, .tcca, .scn or .json";
}

Kind kind_by_content(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
  text = trimmed(text);
  if (!text.empty() && text.front() == '{') return Kind::document;
  std::string_view word = take_word(text);
  while (word == "import" && !text.empty() && text.front() == '"') {
    const auto quote = text.find('"', 1);
    if (quote == std::string_view::npos) return Kind::program;
    if (const auto kind = kind_by_name(std::string(text.substr(1, quote - 1)))) return *kind;
    text = trimmed(text.substr(quote + 1));
    if (!text.empty() && text.front() == ';') text = trimmed(text.substr(1));
    word = take_word(text);
  }
  // Domains stand before plants and before model programs.
  while (word == "domain" && !text.empty() && text.front() != '(') {
    text = trimmed(text.substr(std::min(text.find(';'), text.size() - 1) + 1));
    if (text.empty()) return Kind::plant;
    word = take_word(text);
  }
  // `plant() :: { … }` is a definition: the words are reserved only where the grammar expects them.
  if (!text.empty() && text.front() == '(') return Kind::program;
  if ((word == "property" || word == "hazard") && !text.empty() && text.front() == '"') return Kind::properties;
  for (const std::string_view setting : {"faults", "time", "commands", "from", "entailed", "allow-stuck"}) {
    if (word == setting) return Kind::properties;
  }
  if (word == "channel" && !text.empty() && text.front() == '"') return Kind::monitors;
  if (word == "scenario") return Kind::scenario;
  if (word == "component" || word == "module" || word == "domain" || word == "plant") return Kind::plant;
  return Kind::program;
}

}  // namespace rmpl::compiler
