// What one parse knows besides the text: where reports go, how deep it is, and how to go on after an error.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "grammar/parse/brackets.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::grammar {

/// Thrown to leave a parse that is not worth going on with; the reason has been reported.
struct Abandoned {};

/// Where a parse goes on after an error.
enum class Resume {
  after_semicolon,  ///< behind the next `;` or the end of the braces that the statement opened
  at_semicolon,     ///< before it, or before the `,` or `}` that ends a step behind such braces
  over_braces       ///< as `after_semicolon`, and over a `}` that nothing opened: at the top level
};

/// The state of one parse, reached by every rule through the context.
class ParseState {
 public:
  /// `clocks`: whether the language has them, so that messages may speak of them.
  ParseState(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics, bool clocks);

  [[nodiscard]] const char* begin() const { return text_.data(); }
  [[nodiscard]] const char* end() const { return text_.data() + text_.size(); }
  [[nodiscard]] Span span(const char* from, const char* to) const;
  [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }
  [[nodiscard]] bool has_clocks() const { return clocks_; }

  /// Reports that `expected` was not found at `where` (white space is skipped first). One place is reported once.
  /// After a hundred errors throws Abandoned.
  void report_unexpected(const char* where, const std::string& expected);
  /// Where to go on after an error at `where` in the statement that began at `start`. Stops before a `}` that the
  /// statement did not open, or with `over_braces` behind it. Always behind `start`, unless `start` is at such a brace
  /// or at the end.
  [[nodiscard]] const char* resume(const char* start, const char* where, Resume how) const;

  /// Reports a nesting beyond the limit at `where` and throws Abandoned if there would be more than `nesting_limit`
  /// levels, `further` of them below this one.
  void check_depth(const char* where, std::size_t further);

  /// One level of nesting, for as long as it lives.
  class Level {
   public:
    Level(ParseState& state, const char* where) : state_(state) {
      state_.check_depth(where, 1);
      ++state_.depth_;
    }
    ~Level() { --state_.depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    ParseState& state_;
  };

 private:
  [[nodiscard]] bool is_closed_in_line(const char* place) const;
  void report_token(const char* where, std::string_view found, const std::string& expected);
  /// Notes the bracket of this kind that is open at a place, if there is one.
  void note_unclosed(Diagnostic& error, char kind, const char* place);

  std::string_view text_;
  std::uint32_t file_;
  Diagnostics& diagnostics_;
  Brackets brackets_;
  const bool clocks_;
  std::size_t depth_ = 0;
  std::size_t errors_ = 0;
  const char* last_error_ = nullptr;
  const char* next_statement_ = nullptr;  ///< where the statement in error most likely lacks its `;`
};

}  // namespace rmpl::grammar
