// A quick scan of JSON texts.
// SPDX-License-Identifier: MIT
#include "automata/json/scan.hpp"

#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>
#include <vector>

#include "base/utf8.hpp"

namespace rmpl::automata {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Each step returns whether it is sure of what it has told.
class Scan {
 public:
  Scan(std::string_view text, nlohmann::json_sax<Json>& handler)
      : at_(text.data()), end_(text.data() + text.size()), handler_(handler) {}

  bool run() {
    bool value_next = true;  // or what comes behind one
    do {
      skip_blank();
      if (!(value_next ? value(value_next) : behind_value(value_next))) return false;
    } while (value_next || !open_.empty());
    skip_blank();
    return at_ == end_;
  }

 private:
  /// What opens an object or an array is followed by its first value, if it has one.
  bool value(bool& value_next) {
    value_next = false;
    switch (here()) {
      case '{':
        return opened('}', handler_.start_object(unknown_size), value_next);
      case '[':
        return opened(']', handler_.start_array(unknown_size), value_next);
      case '"':
        return string() && handler_.string(string_);
      case 't':
        return word("true") && handler_.boolean(true);
      case 'f':
        return word("false") && handler_.boolean(false);
      case 'n':
        return word("null") && handler_.null();
      default:
        return number();
    }
  }

  bool opened(char close, bool told, bool& value_next) {
    open_.push_back(close);
    ++at_;
    skip_blank();
    if (!told || here() == close) return told;
    value_next = true;
    return close == ']' || key();
  }

  bool behind_value(bool& value_next) {
    const char sign = here();
    if (sign == ',') {
      ++at_;
      value_next = true;
      skip_blank();
      return open_.back() == ']' || key();
    }
    if (sign != open_.back()) return false;
    ++at_;
    open_.pop_back();
    return sign == '}' ? handler_.end_object() : handler_.end_array();
  }

  /// With its colon.
  bool key() {
    if (here() != '"' || !string()) return false;
    skip_blank();
    if (here() != ':') return false;
    ++at_;
    return handler_.key(string_);
  }

  bool string() {
    string_.clear();
    ++at_;
    for (const char* begin = at_; at_ < end_;) {
      const char c = *at_;
      if (c == '"') {
        string_.append(begin, at_++);
        return true;
      }
      if (static_cast<unsigned char>(c) < 0x20) return false;
      if (c == '\\') {
        string_.append(begin, at_);
        if (!escape()) return false;
        begin = at_;
        continue;
      }
      if (static_cast<unsigned char>(c) < 0x80) {
        ++at_;
        continue;
      }
      const std::size_t length = base::code_point_length({at_, static_cast<std::size_t>(end_ - at_)});
      if (length == 0) return false;
      at_ += length;
    }
    return false;
  }

  bool escape() {
    constexpr std::string_view signs = "\"\\/bfnrt";
    constexpr std::string_view meant = "\"\\/\b\f\n\r\t";
    ++at_;
    const std::size_t which = signs.find(here());
    if (which == std::string_view::npos) return false;
    string_ += meant[which];
    ++at_;
    return true;
  }

  bool number() {
    const char* const begin = at_;
    const bool negative = here() == '-';
    if (negative) ++at_;
    const bool zero = here() == '0';
    if (!digits() || (zero && at_ - begin > (negative ? 2 : 1))) return false;
    bool whole = true;
    if (here() == '.') {
      whole = false;
      ++at_;
      if (!digits()) return false;
    }
    if (here() == 'e' || here() == 'E') {
      whole = false;
      ++at_;
      if (here() == '+' || here() == '-') ++at_;
      if (!digits()) return false;
    }
    const auto read = [&](auto& number) { return std::from_chars(begin, at_, number).ec == std::errc(); };
    if (!whole) {
      double number = 0;
      return read(number) && handler_.number_float(number, no_text_);
    }
    if (negative) {
      std::int64_t number = 0;
      return read(number) && handler_.number_integer(number);
    }
    std::uint64_t number = 0;
    return read(number) && handler_.number_unsigned(number);
  }

  /// At least one.
  bool digits() {
    const char* const begin = at_;
    while (is_digit(here())) ++at_;
    return at_ > begin;
  }

  bool word(std::string_view expected) {
    if (!std::string_view(at_, static_cast<std::size_t>(end_ - at_)).starts_with(expected)) return false;
    at_ += expected.size();
    return true;
  }

  void skip_blank() {
    while (at_ < end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\r' || *at_ == '\t')) ++at_;
  }

  [[nodiscard]] char here() const { return at_ < end_ ? *at_ : '\0'; }

  static constexpr auto unknown_size = static_cast<std::size_t>(-1);
  const char* at_;
  const char* end_;
  nlohmann::json_sax<Json>& handler_;
  std::vector<char> open_;  ///< what closes each
  std::string string_;
  const std::string no_text_;
};

}  // namespace

bool scan_json(std::string_view text, nlohmann::json_sax<Json>& handler) { return Scan(text, handler).run(); }

}  // namespace rmpl::automata
