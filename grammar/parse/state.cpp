// Reports and recovery of a parse.
// SPDX-License-Identifier: MIT
#include "grammar/parse/state.hpp"

#include <algorithm>
#include <vector>

#include "grammar/parse/parse.hpp"
#include "grammar/parse/scan.hpp"
#include "grammar/source/nearest.hpp"

namespace grammar {
namespace {

constexpr std::size_t error_limit = 100;

/// The words between backquotes: the keywords that would have been right.
std::vector<std::string> keywords_in(const std::string& expected) {
  std::vector<std::string> keywords;
  std::size_t open = expected.find('`');
  while (open != std::string::npos) {
    const std::size_t close = expected.find('`', open + 1);
    if (close == std::string::npos) break;
    std::string word = expected.substr(open + 1, close - open - 1);
    if (identifier_at(word.data(), word.data() + word.size()) == word) keywords.push_back(std::move(word));
    open = expected.find('`', close + 1);
  }
  return keywords;
}

/// What was meant, where the habits of other languages or of the papers show.
std::optional<std::string> habit(std::string_view before, std::string_view found, std::string_view expected) {
  if (expected == "a value" && found == "0") return "a clock is started by a step of its own: `t = 0`";
  if (before.ends_with('=') && found == "=") return "equality is written with one `=`";
  if (before.ends_with('&') && found == "&") return "`and` is written with one `&`";
  if (before.ends_with('|') && found == "|") return "`or` is written with one `|`";
  return std::nullopt;
}

}  // namespace

ParseState::ParseState(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics)
    : text_(sources[file].text()), file_(file), diagnostics_(diagnostics) {}

Span ParseState::span(const char* from, const char* to) const {
  return {file_, static_cast<std::uint32_t>(from - begin()), static_cast<std::uint32_t>(to - begin())};
}

void ParseState::report_unexpected(const char* where, const std::string& expected) {
  const char* at = skip_blank(where, end());
  if (at == last_error_) return;
  last_error_ = at;
  if (at == end()) {
    // Blamed behind the last character that shows, not in an empty line below it.
    while (at != begin() && skip_blank(at - 1, end()) == end()) --at;
    Diagnostic& error =
        diagnostics_.error(Code::syntax, span(at, at), "expected " + expected + ", found the end of the text");
    if (const char* brace = unclosed_brace()) error.notes.push_back({span(brace, brace + 1), "this `{` is not closed"});
  } else if (std::string_view(at, static_cast<std::size_t>(end() - at)).starts_with("/*")) {
    diagnostics_.error(Code::syntax, span(at, at + 2), "this comment is not closed: expected `*/`");
  } else {
    const std::string_view found = token_at(at, end());
    const bool word = !identifier_at(at, end()).empty();
    if (found.front() == '"' && (found.size() == 1 || found.back() != '"')) {
      diagnostics_.error(Code::syntax, span(at, at + found.size()), "this string is not closed: expected `\"`");
    } else {
      // A parser without a name of its own has one that only the C++ compiler reads.
      const bool named = expected.find("spirit") == std::string::npos;
      Diagnostic& error =
          diagnostics_.error(Code::syntax, span(at, at + found.size()),
                             (named ? "expected " + expected + ", found " : "did not expect ") +
                                 (word && is_reserved(found) ? "the reserved word `" : "`") + std::string(found) + "`");
      error.suggestion = habit(text_.substr(0, static_cast<std::size_t>(at - begin())), found, expected);
      if (const auto near = word ? nearest(found, keywords_in(expected)) : std::nullopt)
        error.suggestion = "did you mean `" + *near + "`?";
    }
  }
  if (++errors_ < error_limit) return;
  diagnostics_.error(Code::too_many_errors, span(at, at), "too many syntax errors: the rest of the text was not read");
  throw Abandoned{};
}

const char* ParseState::resume(const char* start, const char* where, Resume how) const {
  // A `;` that was not expected ends the statement, whatever braces it has left open.
  const char* fault = skip_blank(where, end());
  if (fault != end() && *fault == ';') return how == Resume::at_semicolon ? fault : fault + 1;
  std::size_t open = 0;
  for (const char* at = skip_blank(start, end()); at != end(); at = skip_blank(at, end())) {
    const std::string_view token = token_at(at, end());
    const char* behind = at + token.size();
    if (token == "{") {
      ++open;
    } else if (token == "}" && open == 0 && at >= where) {
      return how == Resume::over_braces ? behind : at;
    } else if (token == "}" && open > 0) {
      --open;
      if (open == 0 && behind > where) {
        const char* next = skip_blank(behind, end());
        const std::string_view ahead = next == end() ? std::string_view(";") : token_at(next, end());
        if (how == Resume::at_semicolon && (ahead == ";" || ahead == "," || ahead == "}")) return behind;
        if (how != Resume::at_semicolon) return next != end() && ahead == ";" ? next + 1 : behind;
      }
    } else if (token == ";" && open == 0 && at >= where) {
      return how == Resume::at_semicolon ? at : behind;
    }
    at = behind;
  }
  return end();
}

void ParseState::check_depth(const char* where, std::size_t further) {
  if (depth_ + further <= nesting_limit) return;
  const char* at = skip_blank(where, end());
  diagnostics_.error(Code::nesting_too_deep, span(at, at),
                     "nested too deep: at most " + std::to_string(nesting_limit) + " levels were expected");
  throw Abandoned{};
}

const char* ParseState::unclosed_brace() const {
  std::vector<const char*> open;
  for (const char* at = skip_blank(begin(), end()); at != end(); at = skip_blank(at, end())) {
    const std::string_view token = token_at(at, end());
    if (token == "{") open.push_back(at);
    if (token == "}" && !open.empty()) open.pop_back();
    at += token.size();
  }
  return open.empty() ? nullptr : open.back();
}

}  // namespace grammar
