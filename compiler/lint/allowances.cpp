// Finding the comments, reading them, and taking out what they allow.
// SPDX-License-Identifier: MIT
#include "compiler/lint/allowances.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/lint.hpp"
#include "compiler/lint/removal.hpp"

namespace rmpl::compiler {

using grammar::Code;
using grammar::Diagnostic;
using grammar::Span;

namespace {

constexpr std::string_view blank = " \t\r\n";

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
  /// What is left, with single spaces between its words.
  std::string rest() {
    std::string result;
    for (skip(); at_ < text_.size(); skip()) {
      const std::size_t end = std::min(text_.find_first_of(blank, at_), text_.size());
      result += (result.empty() ? "" : " ") + std::string(text_.substr(at_, end - at_));
      at_ = end;
    }
    return result;
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
    if (!known || !code.starts_with("RMPL")) return "expected a code such as RMPL0514, found " + backquoted(code);
    if (find_lint_code(*known) == nullptr) return std::string(code) + " is not a lint code, so it cannot be allowed";
  }
  if (!words.take("because") || words.at_end()) return "expected `because` and the reason";
  return "";
}

/// The line that a comment before a token speaks of: where code stands before or behind it, its own, else the first
/// below that is more than a comment.
std::uint32_t line_of(const grammar::SourceFile& file, const Tokens& tokens, std::size_t token, std::size_t comment) {
  const auto comments = tokens.comments_before(token);
  const auto line_at = [&](std::size_t byte) { return file.place(static_cast<std::uint32_t>(byte)).line; };
  std::uint32_t line = line_at(comments[comment].begin);
  if (!comments[comment].starts_line) return line;
  for (;; ++comment) {
    line = line_at(comments[comment].begin + comments[comment].text.size());
    const bool last = comment + 1 == comments.size();
    const bool blank_line = last ? tokens[token].behind_blank_line : comments[comment + 1].behind_blank_line;
    if (blank_line) return line + 1;
    if (last) return line_at(tokens[token].begin);
  }
}

/// Takes a comment away: with its line, where nothing else stands on it.
grammar::Edit removal_of_comment(const grammar::SourceFile& file, Span comment) {
  const std::string_view text = file.text();
  std::size_t begin = comment.begin;
  while (begin > 0 && blank.find(text[begin - 1]) != std::string_view::npos) --begin;
  const bool alone = begin == 0 || text[begin - 1] == '\n';
  std::size_t end = std::min(text.find_first_not_of(" \t\r", comment.end), text.size());
  if (end < text.size() && text[end] == '\n') end += alone ? 1 : 0;
  return {{comment.file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)}, ""};
}

/// Takes a code out of its comment, with a comma; the comment, where it allows nothing else.
grammar::Edit removal_of(const grammar::SourceFile& file, const std::vector<Allowance>& all, const Allowance& one) {
  const Allowance* before = nullptr;
  for (const Allowance& other : all) {
    if (other.comment != one.comment || other.span == one.span) continue;
    if (one.span < other.span && before == nullptr) return {{one.span.file, one.span.begin, other.span.begin}, ""};
    if (other.span < one.span) before = &other;
  }
  if (before == nullptr) return removal_of_comment(file, one.comment);
  return {{one.span.file, before->span.end, one.span.end}, ""};
}

}  // namespace

std::vector<Allowance> allowances_in(const grammar::Sources& sources, std::uint32_t file, grammar::Diagnostics& found) {
  std::vector<Allowance> allowances;
  const grammar::SourceFile& source = sources[file];
  const auto span_of = [&](std::size_t begin, std::size_t end) {
    return Span{file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  };
  const auto look_at = [&](const Comment& comment, const auto& line) {
    if (!speaks_to_lint(comment.text)) return;
    const std::size_t end = comment.begin + comment.text.size();
    Reader words(source.text(), comment.begin + 2, comment.to_end_of_line ? end : end - 2);
    words.take("lint:");
    std::vector<std::pair<std::size_t, std::string_view>> codes;
    const std::string wrong = read(words, codes);
    if (!wrong.empty()) {
      auto& finding = add_finding(found, Code::allowance_without_reason, span_of(comment.begin, end),
                                  "this comment allows nothing: " + wrong);
      finding.suggestion = "write `// lint: allow RMPL0514 because …`";
      return;
    }
    const std::string reason = words.rest();
    for (const auto& [at, code] : codes) {
      allowances.push_back(
          {*grammar::find_code(code), span_of(at, at + code.size()), span_of(comment.begin, end), line(), reason});
    }
  };
  const Tokens tokens(source.text());
  for (std::size_t t = 0; t < tokens.count(); ++t) {
    const auto comments = tokens.comments_before(t);
    for (std::size_t c = 0; c < comments.size(); ++c) {
      look_at(comments[c], [&] { return line_of(source, tokens, t, c); });
    }
  }
  return allowances;
}

grammar::Diagnostics without_allowed(const grammar::Diagnostics& found, const grammar::Sources& sources,
                                     std::span<const File> files, std::vector<grammar::AllowedFinding>& allowed) {
  grammar::Diagnostics left;
  std::vector<Allowance> allowances;
  std::set<std::uint32_t> named;
  std::map<std::tuple<std::uint32_t, std::uint32_t, Code>, bool> met;  // by file, line, code: whether there was one
  for (const File& file : files) {
    if (file.kind == Kind::document) continue;
    if (file.named) named.insert(file.index);
    for (const Allowance& one : allowances_in(sources, file.index, left)) {
      allowances.push_back(one);
      met.emplace(std::tuple(file.index, one.line, one.code), false);
    }
  }
  for (const Diagnostic& finding : found.all()) {
    const std::uint32_t line = sources[finding.span.file].place(finding.span.begin).line;
    const auto one = met.find({finding.span.file, line, finding.code});
    if (one == met.end() || finding.severity == grammar::Severity::error) {
      left.add(finding);
      continue;
    }
    one->second = true;
    const auto by = std::find_if(allowances.begin(), allowances.end(), [&](const Allowance& a) {
      return a.span.file == finding.span.file && a.line == line && a.code == finding.code;
    });
    allowed.push_back({finding, by->reason, by->comment});
  }
  for (const Allowance& one : allowances) {
    if (met.at({one.span.file, one.line, one.code})) continue;
    auto& finding = add_finding(left, Code::unused_allowance, one.span,
                                to_string(one.code) + " is not found on the line that this comment covers");
    // What others have in common may need it there: lint of one input set cannot know.
    if (!named.contains(one.span.file)) {
      finding.severity = grammar::Severity::note;
      finding.message = "in this input set " + finding.message;
      finding.suggestion = "to check the comment, name this file and all input sets that share it on the command line";
      continue;
    }
    finding.suggestion = "remove it";
    finding.fix.push_back(removal_of(sources[one.comment.file], allowances, one));
  }
  return left;
}

}  // namespace rmpl::compiler
