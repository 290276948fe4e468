// The tokens as X3 parsers.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "grammar/parse/record.hpp"

namespace rmpl::grammar {

/// A token that a scan function recognises.
template <class Value, bool (*Scan)(const char*&, ParseState&, Value&)>
struct Token : x3::parser<Token<Value, Scan>> {
  using attribute_type = Value;
  static constexpr bool has_attribute = true;
  const char* description;
  constexpr explicit Token(const char* text) : description(text) {}

  template <class C, class R, class Attribute>
  bool parse(Iterator& first, const Iterator&, const C& context, R&, Attribute& attribute) const {
    if constexpr (std::is_same_v<std::remove_const_t<Attribute>, x3::unused_type>) {
      Value ignored{};
      return Scan(first, state_of(context), ignored);
    } else {
      return Scan(first, state_of(context), attribute);
    }
  }
};

inline constexpr Token<Name, scan_name> name{"a name"};
inline constexpr Token<Name, scan_value> value{"a value"};
inline constexpr Token<Name, scan_unit> unit{"a unit of time: ns, us, ms, s, min, h, d or w"};
inline constexpr Token<Number, scan_number> number{"a number"};
inline constexpr Token<Number, scan_signed_number> signed_number{"a number"};
inline constexpr Token<std::uint64_t, scan_whole_number> whole_number{"a whole number"};
inline constexpr Token<Duration, scan_duration> duration{"a duration"};
inline constexpr Token<Duration, scan_bound> bound{"a duration or `inf`"};
inline constexpr Token<String, scan_string> string{"a string in double quotes"};

/// A token without a value: a word, an operator in one of its spellings, the end.
template <class Derived>
struct Mark : x3::parser<Derived> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;

  template <class C, class R, class Attribute>
  bool parse(Iterator& first, const Iterator&, const C& context, R&, Attribute&) const {
    return this->derived().scan(first, state_of(context));
  }
};

/// A keyword with its word end.
struct Keyword : Mark<Keyword> {
  std::string_view word;
  constexpr explicit Keyword(std::string_view text) : word(text) {}
  bool scan(Iterator& first, ParseState& state) const { return scan_word(first, state, word); }
  [[nodiscard]] std::string describe() const { return "`" + std::string(word) + "`"; }
};

/// An operator or bracket; some have a mathematical spelling and a word besides.
struct Symbol : Mark<Symbol> {
  std::string_view ascii, mathematical, word;
  constexpr explicit Symbol(std::string_view a, std::string_view m = {}, std::string_view w = {})
      : ascii(a), mathematical(m), word(w) {}
  bool scan(Iterator& first, ParseState& state) const {
    return scan_operator(first, state, ascii) || (!mathematical.empty() && scan_operator(first, state, mathematical)) ||
           (!word.empty() && scan_word(first, state, word));
  }
  [[nodiscard]] std::string describe() const { return "`" + std::string(ascii) + "`"; }
};

/// The `0` of a clock start.
struct Zero : Mark<Zero> {
  bool scan(Iterator& first, ParseState& state) const { return scan_zero(first, state); }
  [[nodiscard]] std::string describe() const { return "a value, or `0` where a clock starts"; }
};

/// The end of the text.
struct End : Mark<End> {
  bool scan(Iterator& first, ParseState& state) const { return scan_end(first, state); }
  [[nodiscard]] std::string describe() const { return "the end of the text"; }
};

/// Never there: gives an expectation that cannot be met a friendly name.
struct Missing : Mark<Missing> {
  const char* description;
  constexpr explicit Missing(const char* text) : description(text) {}
  bool scan(Iterator&, ParseState&) const { return false; }
  [[nodiscard]] std::string describe() const { return description; }
};

/// One of several parsers, with a friendly name for all of them together.
template <class Subject>
struct Named : x3::unary_parser<Subject, Named<Subject>> {
  static constexpr bool has_attribute = Subject::has_attribute;
  static constexpr bool is_pass_through_unary = true;
  const char* description;
  constexpr Named(const Subject& inner, const char* text)
      : x3::unary_parser<Subject, Named<Subject>>(inner), description(text) {}

  template <class C, class R, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const C& context, R& target, Attribute& attribute) const {
    return this->subject.parse(first, last, context, target, attribute);
  }
  [[nodiscard]] std::string describe() const { return description; }
};

template <class Subject>
constexpr auto named(const char* text, const Subject& subject) {
  using Parser = typename x3::extension::as_parser<Subject>::value_type;
  return Named<Parser>(x3::as_parser(subject), text);
}

/// One or more, separated by commas.
template <class Element>
constexpr auto comma_list(const Element& element) {
  return element >> *(Symbol(",") > element);
}

inline constexpr Zero zero;
inline constexpr End end_of_text;

inline constexpr Symbol comma{","}, semicolon{";"}, colon{":"}, open_brace{"{"}, close_brace{"}"}, open_paren{"("},
    close_paren{")"}, open_bracket{"["}, close_bracket{"]"}, tilde{"~"}, slash{"/"}, equals{"="}, defined_as{"::"};
inline constexpr Symbol differs{"!=", "≠"}, less{"<"}, at_most{"<=", "≤"}, greater{">"}, at_least{">=", "≥"};
inline constexpr Symbol arrow{"->", "⇒"}, iff_sign{"<->", "⇔"}, and_sign{"&", "∧", "and"}, or_sign{"|", "∨", "or"},
    not_sign{"!", "¬", "not"};

/// What makes a name before it part of a constraint: then it is no keyword.
inline constexpr auto relation = equals | differs | less | at_most | greater | at_least | Keyword("in");

/// A word that begins a statement, and no name that happens to be spelled so: then an operator would follow.
constexpr auto statement(std::string_view word) {
  return Keyword(word) >> !(arrow | comma | colon | open_paren | relation);
}

/// What can only stand at the top level, as braces before it show: then one before it is not closed.
inline constexpr auto at_top_level = (Keyword("component") | Keyword("module") | Keyword("plant") |
                                      Keyword("scenario") | Keyword("property")) >>
                                     (name | string) >> open_brace;

/// A statement among others between braces, or at the top level: on an error, the next one is tried.
template <class Alternatives>
constexpr auto statements_of_file(const char* text, const Alternatives& alternatives) {
  return *(!end_of_text >> recovering<Resume::over_braces>[named(text, alternatives)]) >> end_of_text;
}
template <class Alternatives>
constexpr auto statements_in_braces(const char* text, const Alternatives& alternatives) {
  return open_brace > *(!(close_brace | end_of_text | at_top_level) >>
                        recovering<Resume::after_semicolon>[named(text, alternatives)]) > close_brace;
}

}  // namespace rmpl::grammar

template <class Value, bool (*Scan)(const char*&, rmpl::grammar::ParseState&, Value&)>
struct boost::spirit::x3::get_info<rmpl::grammar::Token<Value, Scan>> {
  using result_type = std::string;
  std::string operator()(const rmpl::grammar::Token<Value, Scan>& token) const { return token.description; }
};

template <class Parser>
requires requires(const Parser& parser) { parser.describe(); }
struct boost::spirit::x3::get_info<Parser> {
  using result_type = std::string;
  std::string operator()(const Parser& parser) const { return parser.describe(); }
};

/// A sequence is called what it begins with.
template <class Left, class Right>
struct boost::spirit::x3::get_info<boost::spirit::x3::sequence<Left, Right>> {
  using result_type = std::string;
  std::string operator()(const sequence<Left, Right>& parser) const { return what(parser.left); }
};
