// Source texts, their lines, and whether they are text at all.
// SPDX-License-Identifier: MIT
#include "grammar/source/source_file.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

#include "base/utf8.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::size_t longest_text = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t most_encoding_errors = 10;
constexpr std::size_t block_size = 1024;  // bytes between two entries of the table of code points

/// Whether a byte begins a code point beyond U+FFFF, which takes two units in UTF-16.
bool is_surrogate_pair(char c) { return static_cast<unsigned char>(c) >= 0xF0; }

std::string hexadecimal(char c) {
  std::array<char, 5> text{};
  std::snprintf(text.data(), text.size(), "0x%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
  return text.data();
}

}  // namespace

SourceFile::SourceFile(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
  if (text_.size() > longest_text) {
    text_.resize(longest_text);
    cut_ = true;
  }
  line_starts_.push_back(0);
  for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1))
    line_starts_.push_back(static_cast<std::uint32_t>(at + 1));
  block_starts_.push_back(0);
  for (std::size_t at = 0; at + block_size <= text_.size(); at += block_size) {
    const auto more = base::code_points({text_.data() + at, block_size});
    block_starts_.push_back(block_starts_.back() + static_cast<std::uint32_t>(more));
  }
}

std::string_view SourceFile::line(std::uint32_t number) const {
  const std::size_t begin = line_starts_[number - 1];
  const std::size_t end = number < line_starts_.size() ? line_starts_[number] - 1 : text_.size();
  std::string_view line = std::string_view(text_).substr(begin, end - begin);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

Place SourceFile::place(std::uint32_t offset) const {
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const auto line = static_cast<std::uint32_t>(next - line_starts_.begin());
  const std::size_t end = std::min<std::size_t>(offset, text_.size());
  return {line, code_points_before(end) - code_points_before(line_starts_[line - 1]) + 1};
}

Place SourceFile::place_utf16(std::uint32_t offset) const {
  const Place place = this->place(offset);
  const std::uint32_t start = line_starts_[place.line - 1];
  const std::size_t end = std::min<std::size_t>(offset, text_.size());
  const auto begins = text_.begin() + static_cast<std::ptrdiff_t>(start);
  const auto pairs = std::count_if(begins, text_.begin() + static_cast<std::ptrdiff_t>(end), is_surrogate_pair);
  return {place.line, place.column + static_cast<std::uint32_t>(pairs)};
}

std::uint32_t SourceFile::offset_utf16(Place place) const {
  if (place.line > line_count()) return static_cast<std::uint32_t>(text_.size());
  const std::string_view line = this->line(place.line);
  std::size_t at = 0;
  for (std::uint32_t units = 1; at < line.size() && units < place.column;) {
    units += is_surrogate_pair(line[at]) ? 2 : 1;
    for (++at; at < line.size() && base::is_continuation(line[at]);) ++at;
  }
  return line_starts_[place.line - 1] + static_cast<std::uint32_t>(at);
}

std::uint32_t SourceFile::code_points_before(std::size_t offset) const {
  const std::size_t block = offset / block_size;
  const std::string_view within = std::string_view(text_).substr(block * block_size, offset % block_size);
  const std::size_t more = base::code_points(within);
  return block_starts_[block] + static_cast<std::uint32_t>(more);
}

std::uint32_t Sources::add(std::string name, std::string text) {
  files_.emplace_back(std::move(name), std::move(text));
  return static_cast<std::uint32_t>(files_.size() - 1);
}

bool check_encoding(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics) {
  const std::string_view text = sources[file].text();
  std::size_t errors = 0;
  std::size_t at = 0;
  while (at < text.size() && errors < most_encoding_errors) {
    const std::size_t length = text[at] == '\0' ? 0 : base::code_point_length(text.substr(at));
    if (length > 0) {
      at += length;
      continue;
    }
    const std::size_t begin = at;
    const bool nul = text[at] == '\0';
    do {
      ++at;
    } while (at < text.size() && (nul ? text[at] == '\0' : base::code_point_length(text.substr(at)) == 0));
    const Span span{file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at)};
    diagnostics.error(Code::invalid_encoding, span,
                      nul ? "NUL byte in the text: UTF-8 text was expected"
                          : "byte " + hexadecimal(text[begin]) + " is not UTF-8: text in UTF-8 was expected");
    ++errors;
  }
  return errors == 0;
}

}  // namespace rmpl::grammar
