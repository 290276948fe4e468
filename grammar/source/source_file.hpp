// A source text with its name and its lines, and the set of all texts of one run.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/source/span.hpp"

namespace rmpl::grammar {

class Diagnostics;

/// A place as people count: line and column from 1, the column in code points.
struct Place {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  bool operator==(const Place&) const = default;
};

/// An immutable text with a line table. Lines end with `\n`; a `\r` before it belongs to the line end.
/// At most 4 GiB - 1: a longer text is cut there, and the parsers refuse it.
class SourceFile {
 public:
  SourceFile(std::string name, std::string text);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::string_view text() const { return text_; }
  /// Whether the text was too long and lost its end.
  [[nodiscard]] bool is_cut() const { return cut_; }
  /// The number of lines, at least 1.
  [[nodiscard]] std::uint32_t line_count() const { return static_cast<std::uint32_t>(line_starts_.size()); }
  /// The text of a line (from 1) without its line end.
  [[nodiscard]] std::string_view line(std::uint32_t number) const;
  /// Byte offset of the first byte of a line (from 1).
  [[nodiscard]] std::uint32_t line_start(std::uint32_t number) const { return line_starts_[number - 1]; }
  /// The place of a byte offset in [0, size]. Costs a binary search, whatever the length of the line.
  [[nodiscard]] Place place(std::uint32_t offset) const;
  /// The same with the column in UTF-16 code units, from 1: what editors count. Linear in the line up to the offset.
  [[nodiscard]] Place place_utf16(std::uint32_t offset) const;
  /// The byte offset of such a place; beyond the end of a line or of the text, that end.
  [[nodiscard]] std::uint32_t offset_utf16(Place place) const;

 private:
  std::string name_;
  std::string text_;
  bool cut_ = false;
  /// The number of code points before a byte: from the table, and a walk through part of a block.
  [[nodiscard]] std::uint32_t code_points_before(std::size_t offset) const;

  std::vector<std::uint32_t> line_starts_;
  std::vector<std::uint32_t> block_starts_;  ///< per block of bytes, the code points before it
};

/// All source texts of one run, by index. References stay valid as files are added.
class Sources {
 public:
  /// Adds a text under the name by which messages call it, and returns its index.
  std::uint32_t add(std::string name, std::string text);
  [[nodiscard]] const SourceFile& operator[](std::uint32_t file) const { return files_[file]; }
  [[nodiscard]] std::size_t size() const { return files_.size(); }
  /// The text under a span.
  [[nodiscard]] std::string_view text(Span span) const {
    return files_[span.file].text().substr(span.begin, span.end - span.begin);
  }

 private:
  std::deque<SourceFile> files_;
};

/// Whether a text is UTF-8 (RFC 3629: no overlong forms, no surrogates) without NUL bytes. Each run of wrong bytes is
/// reported where it is, at most ten of them.
bool check_encoding(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics);

}  // namespace rmpl::grammar
