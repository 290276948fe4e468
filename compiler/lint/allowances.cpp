// Finding the comments, reading them, and taking out what they allow.
// SPDX-License-Identifier: MIT
#include "compiler/lint/allowances.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/lint.hpp"

namespace rmpl::compiler {

using grammar::Code;
using grammar::Diagnostic;
using grammar::Span;

namespace {

constexpr std::string_view blank = " \t\r";

/// The byte behind a string literal or a block comment that begins at `at`.
std::size_t behind(std::string_view text, std::size_t at) {
  if (text[at] == '/') return std::min(text.size(), text.find("*/", at + 2)) + 2;
  for (++at; at < text.size() && text[at] != '"' && text[at] != '\n'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return at + 1;
}

/// Calls `visit(begin, end)` for each comment from `//` to the end of its line.
void for_each_line_comment(std::string_view text, const auto& visit) {
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view two = text.substr(at, 2);
    if (two == "//") {
      const std::size_t end = std::min(text.size(), text.find('\n', at));
      visit(at, end);
      at = end;
    } else {
      at = two == "/*" || two.front() == '"' ? behind(text, at) : at + 1;
    }
  }
}

/// Reads the words of one comment.
class Reader {
 public:
  Reader(std::string_view text, std::size_t begin, std::size_t end) : text_(text.substr(0, end)), at_(begin) {}

  bool take(std::string_view word) {
    skip();
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }
  /// The letters and digits that come next, with where they begin.
  std::pair<std::size_t, std::string_view> word() {
    skip();
    const std::size_t begin = at_;
    while (at_ < text_.size() && blank.find(text_[at_]) == std::string_view::npos && text_[at_] != ',') ++at_;
    return {begin, text_.substr(begin, at_ - begin)};
  }
  bool at_end() {
    skip();
    return at_ == text_.size();
  }

 private:
  void skip() { at_ = std::min(text_.size(), text_.find_first_not_of(blank, at_)); }

  std::string_view text_;
  std::size_t at_;
};

/// What is wrong with a comment that begins with `lint:`; nothing where all is right.
std::string read(Reader& words, std::vector<std::pair<std::size_t, std::string_view>>& codes) {
  if (!words.take("allow")) return "expected `allow` after `lint:`";
  do codes.push_back(words.word());
  while (words.take(","));
  for (const auto& [begin, code] : codes) {
    const auto known = grammar::find_code(code);
    if (!known || !code.starts_with("RMPL")) return "expected a code such as RMPL0514, and not " + backquoted(code);
    if (find_lint_code(*known) == nullptr) return std::string(code) + " is no finding of lint, and cannot be allowed";
  }
  if (!words.take("because") || words.at_end()) return "expected `because` and the reason";
  return "";
}

/// The line that a comment speaks of: its own where code stands before it, else the first below that is more than a
/// comment.
std::uint32_t line_of(const grammar::SourceFile& file, std::size_t begin) {
  std::uint32_t line = file.place(static_cast<std::uint32_t>(begin)).line;
  const auto code_of = [&](std::uint32_t number) {
    const std::string_view text = file.line(number);
    const std::size_t first = text.find_first_not_of(blank);
    return first == std::string_view::npos ? std::string_view() : text.substr(first);
  };
  if (!code_of(line).starts_with("//")) return line;
  do ++line;
  while (line <= file.line_count() && code_of(line).starts_with("//"));
  return line;
}

/// Takes a comment away: with its line, where nothing else stands on it.
grammar::Edit removal_of(const grammar::SourceFile& file, Span comment) {
  const std::string_view text = file.text();
  std::size_t begin = comment.begin;
  while (begin > 0 && blank.find(text[begin - 1]) != std::string_view::npos) --begin;
  const bool alone = begin == 0 || text[begin - 1] == '\n';
  const std::size_t end = alone && comment.end < text.size() ? comment.end + 1 : comment.end;
  return {{comment.file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)}, ""};
}

}  // namespace

std::vector<Allowance> allowances_in(const grammar::Sources& sources, std::uint32_t file, grammar::Diagnostics& found) {
  std::vector<Allowance> allowances;
  const grammar::SourceFile& source = sources[file];
  const auto span_of = [&](std::size_t begin, std::size_t end) {
    return Span{file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  };
  for_each_line_comment(source.text(), [&](std::size_t begin, std::size_t end) {
    Reader words(source.text(), begin + 2, end);
    if (!words.take("lint:")) return;
    std::vector<std::pair<std::size_t, std::string_view>> codes;
    const std::string wrong = read(words, codes);
    if (!wrong.empty()) {
      auto& finding =
          add_finding(found, Code::allowance_without_reason, span_of(begin, end), "this allows nothing: " + wrong);
      finding.suggestion = "write `// lint: allow RMPL0514 because …`";
      return;
    }
    const std::uint32_t line = line_of(source, begin);
    for (const auto& [at, code] : codes) {
      allowances.push_back({*grammar::find_code(code), span_of(at, at + code.size()), span_of(begin, end), line});
    }
  });
  return allowances;
}

grammar::Diagnostics without_allowed(const grammar::Diagnostics& found, const grammar::Sources& sources,
                                     std::span<const File> files) {
  grammar::Diagnostics left;
  std::vector<Allowance> allowances;
  std::map<std::tuple<std::uint32_t, std::uint32_t, Code>, bool> allowed;  // file, line, code: whether it was met
  for (const File& file : files) {
    if (file.kind == Kind::document) continue;
    for (const Allowance& one : allowances_in(sources, file.index, left)) {
      allowances.push_back(one);
      allowed.emplace(std::tuple(file.index, one.line, one.code), false);
    }
  }
  for (const Diagnostic& finding : found.all()) {
    const std::uint32_t line = sources[finding.span.file].place(finding.span.begin).line;
    const auto one = allowed.find({finding.span.file, line, finding.code});
    if (one == allowed.end() || finding.severity == grammar::Severity::error) {
      left.add(finding);
    } else {
      one->second = true;
    }
  }
  for (const Allowance& one : allowances) {
    if (allowed.at({one.span.file, one.line, one.code})) continue;
    auto& finding = add_finding(left, Code::unused_allowance, one.span,
                                to_string(one.code) + " is not found on the line that this speaks of");
    const auto same_comment = [&](const Allowance& other) { return other.comment == one.comment; };
    if (std::count_if(allowances.begin(), allowances.end(), same_comment) > 1) continue;
    finding.suggestion = "take it out";
    finding.fix.push_back(removal_of(sources[one.comment.file], one.comment));
  }
  return left;
}

}  // namespace rmpl::compiler
