// Reading the list of words.
// SPDX-License-Identifier: MIT
#include "grammar/editor/keywords.hpp"

#include <algorithm>
#include <array>

#include "base/check.hpp"
#include "grammar/editor/texts.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array<Language, 5> languages = {Language::rmpl, Language::tcca, Language::scn, Language::props,
                                               Language::mon};

/// Takes a column from a line.
std::string_view take(std::string_view& line) {
  const std::size_t end = std::min(line.find(' '), line.size());
  const std::string_view column = line.substr(0, end);
  line.remove_prefix(std::min(line.find_first_not_of(' ', end), line.size()));
  return column;
}

struct List {
  std::array<Keywords, languages.size()> words;
  std::map<std::string_view, std::string_view> tokens_of_kinds;
  std::map<std::string_view, std::string_view> tokens_of_names;
  std::vector<std::string_view> tokens;

  List() {
    for (std::string_view rest = keyword_list; !rest.empty();) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      read(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }

 private:
  void read(std::string_view line) {
    const std::string_view what = take(line);
    if (what == "kind" || what == "name") {
      const std::string_view name = take(line);
      const std::string_view token = take(line);
      (what == "kind" ? tokens_of_kinds : tokens_of_names).emplace(name, token);
      if (std::find(tokens.begin(), tokens.end(), token) == tokens.end()) tokens.push_back(token);
    } else if (what == "word") {
      const std::string_view word = take(line);
      const std::string_view of = take(line);
      const std::string_view kind = take(line);
      const auto token = tokens_of_kinds.find(kind);
      CHECK(token != tokens_of_kinds.end());
      for (const Language language : languages) {
        if (is_among(of, to_string(language)))
          words[static_cast<std::size_t>(language)].emplace(word, KeywordInfo{kind, token->second, line});
      }
    }
  }
  static bool is_among(std::string_view list, std::string_view name) {
    for (std::size_t at = 0; at <= list.size();) {
      const std::size_t end = std::min(list.find(',', at), list.size());
      if (list.substr(at, end - at) == name) return true;
      at = end + 1;
    }
    return false;
  }
};

const List& list() {
  static const List read;
  return read;
}

}  // namespace

std::string_view to_string(Language language) {
  constexpr std::array<std::string_view, languages.size()> names = {"rmpl", "tcca", "scn", "props", "mon"};
  return names[static_cast<std::size_t>(language)];
}

const Keywords& keywords(Language language) { return list().words[static_cast<std::size_t>(language)]; }

std::string_view token_of_names(std::string_view kind) {
  const auto found = list().tokens_of_names.find(kind);
  return found == list().tokens_of_names.end() ? std::string_view() : found->second;
}

const std::vector<std::string_view>& semantic_tokens() { return list().tokens; }

}  // namespace rmpl::grammar
