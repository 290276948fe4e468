// Texts with blanks in the place of what is being written.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/open_text.hpp"

#include <algorithm>
#include <utility>

#include "grammar/editor/expectation.hpp"
#include "grammar/editor/tokens.hpp"
#include "grammar/parse/parse.hpp"
#include "grammar/parse/parse_monitors.hpp"

namespace rmpl::tools {
namespace {

/// The text with blanks in the place of what stands from `begin` up to the end of the line of `offset`, or of the
/// braces that hold it all: those that open in between, `inner` of them, may close there.
std::string blanked(std::string_view text, std::size_t begin, std::uint32_t offset, std::size_t inner) {
  std::string rest(text);
  std::size_t end = offset;
  for (; end < text.size() && text[end] != '\n' && (text[end] != '}' || inner > 0); ++end) {
    if (text[end] == '}') --inner;
  }
  for (std::size_t at = begin; at < end; ++at) {
    if (rest[at] != '\n') rest[at] = ' ';
  }
  return rest;
}

/// How many braces around it may belong to what is being written: each makes texts that are parsed.
constexpr std::size_t most_levels = 8;

std::size_t errors_in(grammar::Language language, std::string text) {
  grammar::Sources sources;
  grammar::Diagnostics found;
  const std::uint32_t file = sources.add("", std::move(text));
  switch (language) {
    case grammar::Language::rmpl:
      parse_program(sources, file, found);
      break;
    case grammar::Language::tcca:
      parse_plant(sources, file, found);
      break;
    case grammar::Language::scn:
      parse_scenarios(sources, file, found);
      break;
    case grammar::Language::props:
      parse_properties(sources, file, found);
      break;
    case grammar::Language::mon:
      parse_monitors(sources, file, found);
      break;
  }
  return found.error_count();
}

}  // namespace

Before::Before(std::string_view text) {
  const auto all = grammar::tokens_of(text);
  std::size_t end = text.size();
  if (!all.empty() && all.back().end == end) {
    const std::string_view last = all.back().in(text);
    in_comment = all.back().kind == grammar::TokenKind::comment && !(last.starts_with("/*") && last.ends_with("*/"));
    in_string = last.front() == '"' && (last.size() == 1 || last.back() != '"');
    const bool joint = last == "." && all.size() > 1 && all[all.size() - 2].kind == grammar::TokenKind::word &&
                       all[all.size() - 2].end == all.back().begin;
    if (all.back().kind == grammar::TokenKind::word || in_string) end = all.back().begin;
    if (joint) end = all[all.size() - 2].begin;
  }
  word = text.substr(end);
  tokens = grammar::open_statement(text.substr(0, end));
}

std::vector<std::string> without_statement(std::string_view text, const Before& before, std::uint32_t offset) {
  const auto place = [&](std::string_view token) { return static_cast<std::size_t>(token.data() - text.data()); };
  auto open = static_cast<std::size_t>(std::count(before.tokens.begin(), before.tokens.end(), "{"));
  std::vector<std::string> result;
  const auto add = [&](std::string rest) {
    result.push_back(rest);
    if (open > 0) result.push_back(std::move(rest) + '\n' + std::string(open, '}'));
  };
  if (before.back(0) == "main") {  // the program that it starts in has been named
    std::string rest = blanked(text, place(before.back(0)), offset, 0);
    rest[place(before.back(0))] = ';';
    add(std::move(rest));
  }
  std::size_t begin = place(before.word);
  std::size_t inner = 0;
  for (std::size_t n = before.tokens.size(); n-- > 0; begin = place(before.tokens[n])) {
    if (before.tokens[n] != "{") continue;
    if (inner < most_levels) add(blanked(text, begin, offset, inner));
    ++inner;
    --open;
  }
  add(blanked(text, begin, offset, inner));
  return result;
}

std::size_t best_of(grammar::Language language, const std::vector<std::string>& texts) {
  std::size_t best = 0;
  std::size_t fewest = std::string::npos;
  for (std::size_t t = 0; t < texts.size() && fewest > 0; ++t) {
    const std::size_t errors = errors_in(language, texts[t]);
    if (errors < fewest) best = t;
    fewest = std::min(fewest, errors);
  }
  return best;
}

}  // namespace rmpl::tools
