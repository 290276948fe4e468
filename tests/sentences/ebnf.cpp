// Reading EBNF: by recursive descent, a character at a time.
// SPDX-License-Identifier: MIT
#include "tests/sentences/ebnf.hpp"

#include <cctype>
#include <stdexcept>

namespace rmpl::sentences {
namespace {

using Kind = Expression::Kind;

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  void read(Grammar& grammar) {
    for (skip(); at_ < text_.size(); skip()) {
      const std::string name = read_name();
      expect('=');
      if (!grammar.emplace(name, read_choice()).second) throw std::runtime_error("two rules are called " + name);
      expect(';');
    }
  }

 private:
  /// White space and comments.
  void skip() {
    while (at_ < text_.size()) {
      if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        ++at_;
      } else if (text_.substr(at_, 2) == "(*") {
        at_ = text_.find("*)", at_) + 2;
      } else {
        return;
      }
    }
  }

  bool take(char symbol) {
    skip();
    if (at_ == text_.size() || text_[at_] != symbol) return false;
    ++at_;
    return true;
  }

  void expect(char symbol) {
    if (!take(symbol)) throw std::runtime_error(std::string("expected ") + symbol + " before " + rest());
  }

  [[nodiscard]] std::string rest() const { return std::string(text_.substr(at_, 40)); }

  std::string read_name() {
    skip();
    const std::size_t start = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '-'))
      ++at_;
    if (at_ == start) throw std::runtime_error("expected a name before " + rest());
    return std::string(text_.substr(start, at_ - start));
  }

  /// What stands up to a closing quotation or question mark.
  std::string read_quoted(char mark) {
    const std::size_t end = text_.find(mark, at_);
    if (end == std::string_view::npos) throw std::runtime_error("not closed: " + rest());
    const std::string quoted(text_.substr(at_, end - at_));
    at_ = end + 1;
    return quoted;
  }

  Expression read_choice() { return read_parts(Kind::choice, '|', &Reader::read_sequence); }
  Expression read_sequence() { return read_parts(Kind::sequence, ',', &Reader::read_exception); }

  Expression read_parts(Kind kind, char separator, Expression (Reader::*read_part)()) {
    Expression all{kind, "", {(this->*read_part)()}};
    while (take(separator)) all.parts.push_back((this->*read_part)());
    if (all.parts.size() > 1) return all;
    Expression only = std::move(all.parts.front());
    return only;
  }

  Expression read_exception() {
    Expression all = read_factor();
    if (!take('-')) return all;
    return {Kind::exception, "", {std::move(all), read_factor()}};
  }

  Expression read_factor() {
    if (take('"')) return {Kind::terminal, read_quoted('"'), {}};
    if (take('\'')) return {Kind::terminal, read_quoted('\''), {}};
    if (take('?')) return {Kind::special, read_quoted('?'), {}};
    if (take('[')) return read_bracketed(Kind::optional, ']');
    if (take('{')) return read_bracketed(Kind::repeated, '}');
    if (take('(')) return read_bracketed(Kind::sequence, ')');
    return {Kind::rule, read_name(), {}};
  }

  Expression read_bracketed(Kind kind, char close) {
    Expression all{kind, "", {read_choice()}};
    expect(close);
    return all;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

void read_ebnf(std::string_view text, Grammar& grammar) { Reader(text).read(grammar); }

}  // namespace rmpl::sentences
