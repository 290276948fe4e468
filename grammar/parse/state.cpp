// Reports and recovery of a parse.
// SPDX-License-Identifier: MIT
#include "grammar/parse/state.hpp"

#include <algorithm>

#include "grammar/parse/foreign.hpp"
#include "grammar/parse/hint.hpp"
#include "grammar/parse/parse.hpp"
#include "grammar/parse/scan.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::size_t error_limit = 100;

/// The bracket that a closing one closes; 0 for what closes nothing.
char opening(std::string_view closing) {
  if (closing == ")") return '(';
  if (closing == "]") return '[';
  return closing == "}" ? '{' : '\0';
}

/// The closing bracket that is expected last, as in "`,` or `}`"; 0 where it is none, or where a statement may end:
/// then it is not the bracket that is missing.
char expected_bracket(std::string_view expected) {
  if (expected.size() < 3 || !expected.ends_with('`') || expected.find("`;`") != expected.npos) return '\0';
  expected.remove_suffix(1);
  return expected[expected.size() - 2] == '`' ? opening(expected.substr(expected.size() - 1)) : '\0';
}

}  // namespace

ParseState::ParseState(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics, bool clocks)
    : text_(sources[file].text()), file_(file), diagnostics_(diagnostics), brackets_(text_), clocks_(clocks) {}

Span ParseState::span(const char* from, const char* to) const {
  return {file_, static_cast<std::uint32_t>(from - begin()), static_cast<std::uint32_t>(to - begin())};
}

void ParseState::report_unexpected(const char* where, const std::string& expected) {
  const char* at = skip_blank(where, end());
  if (at == last_error_) return;
  last_error_ = at;
  if (at == end()) {
    // Blamed behind the last character that shows, not in an empty line below it.
    while (at != begin() && is_space(at[-1])) --at;
    Diagnostic& error =
        diagnostics_.error(Code::syntax, span(at, at), "expected " + expected + ", found the end of the text");
    note_unclosed(error, '{', end());
  } else if (std::string_view(at, static_cast<std::size_t>(end() - at)).starts_with("/*")) {
    diagnostics_.error(Code::syntax, span(at, at + 2), "this comment is not closed: expected `*/`");
  } else {
    const std::string_view found = token_at(at, end());
    if (found.front() == '"' && (found.size() == 1 || found.back() != '"')) {
      diagnostics_.error(Code::syntax, span(at, at + found.size()), "this string is not closed: expected `\"`");
    } else {
      report_token(where, found, expected);
    }
  }
  if (++errors_ < error_limit) return;
  diagnostics_.error(Code::too_many_errors, span(at, at), "too many syntax errors: the rest of the text was not read");
  throw Abandoned{};
}

void ParseState::report_token(const char* where, std::string_view found, const std::string& expected) {
  const char* at = found.data();
  const bool word = !identifier_at(at, end()).empty();
  Diagnostic& error = diagnostics_.error(
      Code::syntax, span(at, at + found.size()),
      "expected " + expected + ", found " + (word && is_reserved(found) ? "the reserved word " : "") + shown(found));
  const char* behind = at + found.size();
  const std::string_view before(begin(), static_cast<std::size_t>(at - begin()));
  if (const auto found_hint =
          hint({before, found, {behind, static_cast<std::size_t>(end() - behind)}, expected, clocks_})) {
    error.suggestion = found_hint->suggestion;
    const std::string_view replaced = found_hint->replaced;
    if (!replaced.empty()) {
      error.fix = {{span(replaced.data(), replaced.data() + replaced.size()), found_hint->text}};
    }
  }
  const char closed = opening(found);
  if (closed != '\0' && brackets_.open(closed, at) == nullptr) {
    error.suggestion = std::string("no `") + closed + "` is open here";
    error.fix.clear();
  } else if (const char kind = expected_bracket(expected); kind != '\0' && (kind != '{' || !is_closed_in_line(at))) {
    note_unclosed(error, kind, at);
  }
  // A statement that ends with its line most likely lacks its `;` there.
  const bool next_line = std::find(where, at, '\n') != at;
  if (next_line && !error.suggestion && expected.find("`;`") != std::string::npos) {
    error.notes.push_back({span(where, where), "is a `;` missing here?"});
    error.fix = {{span(where, where), ";"}};
    if (word) next_statement_ = at;
  }
}

void ParseState::note_unclosed(Diagnostic& error, char kind, const char* place) {
  const char* bracket = brackets_.open(kind, place);
  if (bracket == nullptr) return;
  error.notes.push_back({span(bracket, bracket + 1), std::string("this `") + kind + "` is not closed"});
}

/// Whether the line has opened a brace before the place and closes it behind.
bool ParseState::is_closed_in_line(const char* place) const {
  const char* line = place;
  while (line != begin() && line[-1] != '\n') --line;
  const char* const end_of_line = std::find(place, end(), '\n');
  const auto opened = std::count(line, place, '{') - std::count(line, place, '}');
  const char* const close = std::find(place, end_of_line, '}');
  return opened == 1 && close != end_of_line && std::find(place, close, '{') == close;
}

const char* ParseState::resume(const char* start, const char* where, Resume how) const {
  const char* fault = skip_blank(where, end());
  if (fault == next_statement_ && how != Resume::at_semicolon && fault > start) return fault;
  // A `;` that was not expected ends the statement, whatever braces it has left open, but for such as its line closes.
  const bool listed = how != Resume::at_semicolon && is_closed_in_line(fault);
  if (fault != end() && *fault == ';' && !listed) return how == Resume::at_semicolon ? fault : fault + 1;
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
        if (ahead == "->") {  // nothing begins so: the braces were part of the statement
          at = behind;
          continue;
        }
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

}  // namespace rmpl::grammar
