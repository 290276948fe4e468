// Comma-separated values (RFC 4180), a row at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rmpl::runtime {

/// One row. Its cells are stretches of one text, so that a row costs no memory of its own.
class CsvRow {
 public:
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] std::string_view operator[](std::size_t cell) const {
    return std::string_view(text_).substr(cells_[cell].first, cells_[cell].second);
  }
  /// The line of the file on which it begins, from 1.
  [[nodiscard]] std::size_t line() const { return line_; }
  /// Whether the cells are the same, wherever they stand.
  [[nodiscard]] bool same_cells(const CsvRow& other) const;

 private:
  friend class CsvReader;
  std::string text_;
  std::vector<std::pair<std::size_t, std::size_t>> cells_;  ///< begin and length
  std::size_t line_ = 0;
};

/// Reads rows as RFC 4180 has them: cells in double quotes may hold the delimiter, line breaks and doubled quotes;
/// lines end with CRLF or LF. A byte order mark at the start and blank lines are passed over. Time and memory are
/// linear in a row.
class CsvReader {
 public:
  /// `name` is the file's, for messages. Without a delimiter it is the one of `,`, `;` and the tabulator that the first
  /// row has most of, outside of quotes; of equals the first. Keeps a reference to `in`.
  CsvReader(std::istream& in, std::string name, std::optional<char> delimiter = std::nullopt);

  /// The next row; null at the end. It stays until the next call. Throws base::InputError where a quote is not closed,
  /// stands in the middle of a cell or has something behind it, or where a byte is NUL.
  const CsvRow* next();
  /// The row that `next` will give, which it gives nevertheless.
  const CsvRow* peek();

 private:
  bool read(CsvRow& row);
  bool get_line(CsvRow& row);
  void split(CsvRow& row);
  void split_plain(CsvRow& row) const;
  void refuse_nul(const CsvRow& row) const;
  [[noreturn]] void fail(const CsvRow& row, const std::string& what) const;

  std::istream& in_;
  std::string name_;
  std::optional<char> delimiter_;
  CsvRow row_, ahead_;
  bool has_ahead_ = false;
  std::size_t lines_ = 0;
};

}  // namespace rmpl::runtime
