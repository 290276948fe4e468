// Damage to texts.
// SPDX-License-Identifier: MIT
#include "tests/fuzz/mutate.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

namespace rmpl::fuzz {

namespace {

/// 0 … bound - 1, and 0 where there is nothing to choose from. Plain modulo: the same on every standard library.
std::size_t below(std::size_t bound, Random& random) { return bound == 0 ? 0 : random() % bound; }

struct Piece {
  std::size_t begin;
  std::size_t length;
};

/// A run of letters and digits, or one other character.
Piece random_token(const std::string& text, Random& random) {
  const auto is_word = [&](std::size_t i) { return std::isalnum(static_cast<unsigned char>(text[i])) != 0; };
  std::size_t begin = below(text.size(), random);
  std::size_t end = begin + 1;
  if (is_word(begin)) {
    while (begin > 0 && is_word(begin - 1)) --begin;
    while (end < text.size() && is_word(end)) ++end;
  }
  return {begin, end - begin};
}

/// Brackets and prefix operators in great number, closed or not.
std::string nest(Random& random) {
  static constexpr std::string_view openings[] = {"(",    "{",    "!", "[", "do { ", "always ", "if a = b thennext ",
                                                  "not ", "a -> "};
  static constexpr std::string_view closings[] = {")", "}", "", "]", "} watching a = b", "", "", "", ""};
  const std::size_t kind = below(std::size(openings), random);
  const std::size_t depth = 1 + below(random() % 8 == 0 ? 10'000 : 50, random);
  std::string result;
  for (std::size_t i = 0; i < depth; ++i) result += openings[kind];
  if (random() % 2 == 0)
    for (std::size_t i = 0; i < depth; ++i) result += closings[kind];
  return result;
}

std::string random_literal(Random& random) {
  static constexpr std::string_view literals[] = {"0",
                                                  "-1",
                                                  "1e999",
                                                  "99999999999999999999999999",
                                                  "1e-999",
                                                  "inf",
                                                  "0.0000000001",
                                                  "18446744073709551616",
                                                  "nan",
                                                  "\"",
                                                  "/*",
                                                  "//",
                                                  "\xff",
                                                  "\xc3",
                                                  "\xed\xa0\x80",
                                                  "\xf0\x9f",
                                                  "¬",
                                                  "∞",
                                                  "⇔",
                                                  "<->",
                                                  ":",
                                                  "::",
                                                  ";",
                                                  ",",
                                                  "true",
                                                  "="};
  if (random() % 16 == 0) return std::string(1, '\0');
  return std::string(literals[below(std::size(literals), random)]);
}

void change(std::string& text, const std::vector<Seed>& corpus, Random& random) {
  if (text.empty()) {
    text = random_literal(random);
    return;
  }
  const std::size_t place = below(text.size(), random);
  switch (random() % 10) {
    case 0:
      text[place] = static_cast<char>(text[place] ^ (1 << (random() % 8)));
      break;
    case 1:
      text[place] = static_cast<char>(random() % 256);
      break;
    case 2:
      text.resize(place);
      break;
    case 3:
      text.erase(place, 1 + below(std::min<std::size_t>(40, text.size() - place), random));
      break;
    case 4: {
      const Piece token = random_token(text, random);
      text.insert(token.begin, text.substr(token.begin, token.length) + ' ');
      break;
    }
    case 5: {
      const Piece token = random_token(text, random);
      text.erase(token.begin, token.length);
      break;
    }
    case 6: {
      const Piece from = random_token(text, random);
      const std::string other = text.substr(from.begin, from.length);
      const Piece to = random_token(text, random);
      text.replace(to.begin, to.length, other);
      break;
    }
    case 7: {
      const Piece token = random_token(text, random);
      text.replace(token.begin, random() % 2 == 0 ? token.length : 0, random_literal(random));
      break;
    }
    case 8:
      text.insert(place, nest(random));
      break;
    default: {
      const std::string& other = corpus[below(corpus.size(), random)].text;
      const std::size_t begin = below(other.size(), random);
      text.insert(place, other.substr(begin, 1 + below(200, random)));
      break;
    }
  }
}

}  // namespace

std::vector<Seed> read_corpus(const std::string& directory, const std::vector<std::string>& extensions) {
  std::vector<Seed> corpus;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    const auto extension = entry.path().extension().string();
    if (!entry.is_regular_file() || std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
      continue;
    std::ifstream file(entry.path(), std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    corpus.push_back({entry.path().string(), text.str()});
  }
  std::sort(corpus.begin(), corpus.end(), [](const Seed& a, const Seed& b) { return a.path < b.path; });
  return corpus;
}

std::string mutate(const std::string& text, const std::vector<Seed>& corpus, Random& random) {
  std::string result = text;
  const std::size_t changes = 1 + below(4, random);
  for (std::size_t i = 0; i < changes; ++i) change(result, corpus, random);
  return result;
}

}  // namespace rmpl::fuzz
