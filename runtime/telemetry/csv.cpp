// Rows are split in place: quotes that go leave room for what comes behind them.
// SPDX-License-Identifier: MIT
#include "runtime/telemetry/csv.hpp"

#include <algorithm>
#include <array>

#include "base/error.hpp"

namespace rmpl::runtime {
namespace {

/// The delimiter that stands in a first line most often, outside of quotes.
char delimiter_of(std::string_view line) {
  constexpr std::array<char, 3> candidates{',', ';', '\t'};
  std::array<std::size_t, candidates.size()> counts{};
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    const auto* const found = std::find(candidates.begin(), candidates.end(), c);
    if (!quoted && found != candidates.end()) ++counts[static_cast<std::size_t>(found - candidates.begin())];
  }
  return candidates[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin())];
}

}  // namespace

bool CsvRow::same_cells(const CsvRow& other) const {
  if (size() != other.size()) return false;
  for (std::size_t cell = 0; cell < size(); ++cell) {
    if ((*this)[cell] != other[cell]) return false;
  }
  return true;
}

CsvReader::CsvReader(std::istream& in, std::string name, std::optional<char> delimiter)
    : in_(in), name_(std::move(name)), delimiter_(delimiter) {}

const CsvRow* CsvReader::next() {
  if (has_ahead_) {
    has_ahead_ = false;
    std::swap(row_, ahead_);
    return &row_;
  }
  return read(row_) ? &row_ : nullptr;
}

const CsvRow* CsvReader::peek() {
  if (!has_ahead_) has_ahead_ = read(ahead_);
  return has_ahead_ ? &ahead_ : nullptr;
}

void CsvReader::fail(const CsvRow& row, const std::string& what) const {
  throw base::InputError(name_ + ":" + std::to_string(row.line_) + ": " + what);
}

/// Adds the next line to the row's text, without its end.
bool CsvReader::get_line(CsvRow& row) {
  std::string line;
  std::string& into = row.text_.empty() ? row.text_ : line;
  if (!std::getline(in_, into)) return false;
  ++lines_;
  if (&into == &line) row.text_ += line;
  return true;
}

bool CsvReader::read(CsvRow& row) {
  do {
    row.text_.clear();
    if (!get_line(row)) {
      if (in_.bad()) throw base::InputError(name_ + ": cannot be read");
      return false;
    }
    if (lines_ == 1 && row.text_.starts_with("\xEF\xBB\xBF")) row.text_.erase(0, 3);
  } while (row.text_.empty() || row.text_ == "\r");
  row.line_ = lines_;
  if (!delimiter_) delimiter_ = delimiter_of(row.text_);
  split(row);
  return true;
}

void CsvReader::split(CsvRow& row) {
  std::string& text = row.text_;
  row.cells_.clear();
  if (text.find('"') == std::string::npos) return split_plain(row);
  std::size_t at = 0;   // what is looked at
  std::size_t end = 0;  // of what is kept
  for (bool more = true; more;) {
    const std::size_t begin = end;
    if (at < text.size() && text[at] == '"') {
      for (++at;;) {
        if (at == text.size()) {
          // The cell goes on in the next line.
          text.resize(end);
          text += '\n';
          at = ++end;
          if (!get_line(row)) fail(row, "a quote is not closed");
          continue;
        }
        if (text[at] == '"') {
          ++at;
          if (at >= text.size() || text[at] != '"') break;
        }
        text[end++] = text[at++];
      }
      if (at + 1 == text.size() && text[at] == '\r') ++at;
      if (at < text.size() && text[at] != *delimiter_) fail(row, "expected the delimiter behind a closing quote");
    } else {
      while (at < text.size() && text[at] != *delimiter_) {
        if (text[at] == '"')
          fail(row, "a quote within a cell: expected the whole cell in quotes, and this one doubled");
        text[end++] = text[at++];
      }
      if (at == text.size() && end > begin && text[end - 1] == '\r') --end;
    }
    row.cells_.emplace_back(begin, end - begin);
    more = at < text.size();
    ++at;
  }
  text.resize(end);
  refuse_nul(row);
}

/// A line without quotes: every delimiter ends a cell.
void CsvReader::split_plain(CsvRow& row) const {
  std::string& text = row.text_;
  if (text.ends_with('\r')) text.pop_back();
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = text.find(*delimiter_, begin)) != std::string::npos; begin = end + 1) {
    row.cells_.emplace_back(begin, end - begin);
  }
  row.cells_.emplace_back(begin, text.size() - begin);
  refuse_nul(row);
}

void CsvReader::refuse_nul(const CsvRow& row) const {
  if (row.text_.find('\0') != std::string::npos) fail(row, "expected text, found a NUL byte");
}

}  // namespace rmpl::runtime
