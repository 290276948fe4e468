// What is to be laid out: tokens in their order, and between them where lines may break and what is aligned.
//
// After Oppen, "Prettyprinting" (TOPLAS 1980) and Wadler, "A prettier printer" (2003): scopes group the places where a
// line may break; a scope that fits on its line has no breaks. It is a stream, not a tree: linear to make and to print,
// and no token can be lost or change its place.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "compiler/format/tokens.hpp"

namespace rmpl::compiler {

/// Where lines break in a scope that does not fit.
enum class Breaks : std::uint8_t {
  all,    ///< wherever they may
  needed  ///< where what stands between one place and the next does not fit
};

/// Where the lines of a scope start.
enum class Margin : std::uint8_t {
  outer,    ///< where the lines around it do
  nested,   ///< two columns further, from its first break on
  aligned,  ///< below its first token
};

/// Statements whose parts stand in columns where they follow each other.
enum class Table : std::uint8_t {
  none,
  domains,
  attributes,
  modes,
  transitions,
  instances,
  controls,
  connections,
  settings
};

enum class EventKind : std::uint8_t { token, line, open, close };

/// One event of the stream.
struct Event {
  EventKind kind = EventKind::token;
  bool space = false;  ///< token, line: a blank stands before the token, if no line breaks there
  bool hard = false;   ///< line: it breaks, whatever fits
  bool lazy = false;   ///< line: breaks only where what stands before the next place, of whatever scope, does not fit
  bool blank = false;  ///< hard line: a blank line of the text stays
  Breaks breaks = Breaks::all;
  Margin margin = Margin::outer;
  std::uint32_t pad = 0;     ///< token: more blanks before it, to its column
  std::uint32_t target = 0;  ///< token: which; line: the next of its scope, or its close; open: its close
};

/// A statement as a row of a table. Its parts end before the first tokens at or behind `stops`; where it has none, it
/// stands as it is.
struct Row {
  std::uint32_t open = 0;     ///< its scope
  std::uint32_t keyword = 0;  ///< behind its keyword, where keywords are a column; else 0
  std::uint32_t stops[2] = {0, 0};
  std::uint32_t margin = 0;  ///< the column where it starts
  std::uint8_t stop_count = 0;
  bool first = false;  ///< of its table
};

/// Makes the stream, token by token.
class Document {
 public:
  explicit Document(const Tokens& tokens) : tokens_(tokens) {}

  // What comes next in the text.
  [[nodiscard]] std::string_view next() const { return tokens_[next_].text; }
  [[nodiscard]] std::string_view behind_next() const { return tokens_[next_ + 1].text; }
  [[nodiscard]] std::uint32_t next_begin() const { return tokens_[next_].begin; }
  [[nodiscard]] bool has_comments_before_next() const { return !tokens_.comments_before(next_).empty(); }

  /// The next token.
  void take();
  /// All tokens that begin before this byte.
  void take_to(std::uint32_t byte);
  /// No blank before the next token.
  void glue() { glued_ = true; }

  /// A line may break before the next token.
  void line() { add_line(false, false); }
  void lazy_line() { add_line(false, true); }
  /// A line breaks before the next token; of blank lines in the text one stays.
  void hard_line();

  void open(Breaks breaks, Margin margin);
  void close();

  /// A statement, at the margin of the block: a scope, and perhaps a row of a table.
  void open_statement(Table table = Table::none);
  void close_statement() { close(); }
  /// The keyword of a row, which is the next token.
  void take_keyword();
  /// The next part of a row starts with the next token.
  void stop();
  /// How deep in braces statements stand.
  void enter_block() { ++depth_; }
  void leave_block() { --depth_; }

  [[nodiscard]] const Tokens& tokens() const { return tokens_; }
  [[nodiscard]] std::vector<Event>& events() { return events_; }
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

 private:
  struct OpenScope {
    std::uint32_t open = 0;
    std::uint32_t last_line = 0;  ///< its last line so far; 0: none
  };

  void add_line(bool hard, bool lazy);
  [[nodiscard]] std::uint32_t here() const { return static_cast<std::uint32_t>(events_.size()); }
  [[nodiscard]] bool space_before_next() const;
  [[nodiscard]] bool line_comment_before_next() const;

  const Tokens& tokens_;
  std::size_t next_ = 0;
  std::vector<Event> events_;
  std::vector<OpenScope> scopes_;
  std::vector<Row> rows_;
  Table table_ = Table::none;
  std::uint32_t depth_ = 0;
  std::uint32_t pending_line_ = no_line;  ///< the line since the last token
  bool glued_ = false;
  static constexpr std::uint32_t no_line = 0xFFFFFFFF;
};

}  // namespace rmpl::compiler
