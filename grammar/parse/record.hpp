// How rules fill trees: directives that parse into the members of the rule's attribute, name by name.
//
// X3's own sequences fill tuples by position. Here a rule is `record[...]`, and inside it `field<&T::m>[p]` says which
// member p fills, so that clauses can come in any order, be optional, or repeat; no semantic actions, no Fusion.
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/spirit/home/x3.hpp>
#include <type_traits>
#include <utility>

#include "grammar/parse/scan.hpp"
#include "grammar/parse/state.hpp"

namespace rmpl::grammar {

namespace x3 = boost::spirit::x3;

using Iterator = const char*;
struct StateTag;
/// The context of every rule: the state, and nothing else (tokens skip blanks themselves).
using Context = x3::context<StateTag, ParseState>;

template <class AnyContext>
ParseState& state_of(const AnyContext& context) {
  return x3::get<StateTag>(context);
}

template <class Subject, class AnyContext>
using AttributeOf = typename x3::traits::attribute_of<Subject, AnyContext>::type;

struct DirectiveBase {};

/// Parses with the attribute's members as targets, and gives it its span, from the first token to the last.
template <class Subject>
struct Record : DirectiveBase, x3::unary_parser<Subject, Record<Subject>> {
  using x3::unary_parser<Subject, Record<Subject>>::unary_parser;
  static constexpr bool has_attribute = true;

  template <class C, class R, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const C& context, R&, Attribute& attribute) const {
    const Iterator start = skip_blank(first, last);
    if (!this->subject.parse(first, last, context, attribute, x3::unused)) return false;
    if constexpr (requires { attribute.span; }) attribute.span = state_of(context).span(start, first);
    return true;
  }
};

/// What does not give an attribute of its own, but writes into the record around it.
template <class Derived, class Subject>
struct IntoRecord : DirectiveBase, x3::unary_parser<Subject, Derived> {
  using x3::unary_parser<Subject, Derived>::unary_parser;
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;
};

/// Parses into a member; where the member is a variant, an optional or a box, by assignment.
template <auto Member, class Subject>
struct Field : IntoRecord<Field<Member, Subject>, Subject> {
  using IntoRecord<Field<Member, Subject>, Subject>::IntoRecord;

  template <class C, class R, class Unused>
  bool parse(Iterator& first, const Iterator& last, const C& context, R& target, Unused&) const {
    using Value = AttributeOf<Subject, C>;
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(target.*Member)>, Value>) {
      return this->subject.parse(first, last, context, target, target.*Member);
    } else {
      Value value{};
      if (!this->subject.parse(first, last, context, target, value)) return false;
      target.*Member = std::move(value);
      return true;
    }
  }
};

/// Parses one more element of a member that is a vector.
template <auto Member, class Subject>
struct Append : IntoRecord<Append<Member, Subject>, Subject> {
  using IntoRecord<Append<Member, Subject>, Subject>::IntoRecord;

  template <class C, class R, class Unused>
  bool parse(Iterator& first, const Iterator& last, const C& context, R& target, Unused&) const {
    AttributeOf<Subject, C> value{};
    if (!this->subject.parse(first, last, context, target, value)) return false;
    (target.*Member).emplace_back(std::move(value));
    return true;
  }
};

/// Parses into the members of the last element of a member that is a vector.
template <auto Member, class Subject>
struct Last : IntoRecord<Last<Member, Subject>, Subject> {
  using IntoRecord<Last<Member, Subject>, Subject>::IntoRecord;

  template <class C, class R, class Unused>
  bool parse(Iterator& first, const Iterator& last, const C& context, R& target, Unused&) const {
    return this->subject.parse(first, last, context, (target.*Member).back(), x3::unused);
  }
};

/// Sets a member to a constant where the subject matches.
template <auto Member, auto Value, class Subject>
struct Set : IntoRecord<Set<Member, Value, Subject>, Subject> {
  using IntoRecord<Set<Member, Value, Subject>, Subject>::IntoRecord;

  template <class C, class R, class Unused>
  bool parse(Iterator& first, const Iterator& last, const C& context, R& target, Unused&) const {
    if (!this->subject.parse(first, last, context, target, x3::unused)) return false;
    target.*Member = Value;
    return true;
  }
};

/// One level of nesting deeper; beyond the limit the parse is abandoned with a diagnostic.
template <class Subject>
struct Nested : DirectiveBase, x3::unary_parser<Subject, Nested<Subject>> {
  using x3::unary_parser<Subject, Nested<Subject>>::unary_parser;
  static constexpr bool has_attribute = Subject::has_attribute;
  static constexpr bool is_pass_through_unary = true;

  template <class C, class R, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const C& context, R& target, Attribute& attribute) const {
    const ParseState::Level level(state_of(context), first);
    return this->subject.parse(first, last, context, target, attribute);
  }
};

/// Where the subject is not found, reports it and goes on behind the statement as if it had been.
template <Resume How, class Subject>
struct Recovering : DirectiveBase, x3::unary_parser<Subject, Recovering<How, Subject>> {
  using x3::unary_parser<Subject, Recovering<How, Subject>>::unary_parser;
  static constexpr bool has_attribute = Subject::has_attribute;
  static constexpr bool is_pass_through_unary = true;

  template <class C, class R, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const C& context, R& target, Attribute& attribute) const {
    const Iterator start = first;
    try {
      return x3::expect[this->subject].parse(first, last, context, target, attribute);
    } catch (const x3::expectation_failure<Iterator>& failure) {
      state_of(context).report_unexpected(failure.where(), failure.which());
      first = state_of(context).resume(start, failure.where(), How);
      return true;
    }
  }
};

/// `directive[parser]`: applies a family of directives to a parser.
template <class Family>
struct Directive {
  template <class Subject>
  constexpr auto operator[](const Subject& subject) const {
    using Parser = typename x3::extension::as_parser<Subject>::value_type;
    return typename Family::template Applied<Parser>(x3::as_parser(subject));
  }
};

struct RecordFamily {
  template <class Subject>
  using Applied = Record<Subject>;
};
template <auto Member>
struct FieldFamily {
  template <class Subject>
  using Applied = Field<Member, Subject>;
};
template <auto Member>
struct AppendFamily {
  template <class Subject>
  using Applied = Append<Member, Subject>;
};
template <auto Member>
struct LastFamily {
  template <class Subject>
  using Applied = Last<Member, Subject>;
};
template <auto Member, auto Value>
struct SetFamily {
  template <class Subject>
  using Applied = Set<Member, Value, Subject>;
};
struct NestedFamily {
  template <class Subject>
  using Applied = Nested<Subject>;
};
template <Resume How>
struct RecoveringFamily {
  template <class Subject>
  using Applied = Recovering<How, Subject>;
};

inline constexpr Directive<RecordFamily> record;
template <auto Member>
inline constexpr Directive<FieldFamily<Member>> field;
template <auto Member>
inline constexpr Directive<AppendFamily<Member>> append;
template <auto Member>
inline constexpr Directive<LastFamily<Member>> last_of;
template <auto Member, auto Value>
inline constexpr Directive<SetFamily<Member, Value>> set;
inline constexpr Directive<NestedFamily> nested;
template <Resume How>
inline constexpr Directive<RecoveringFamily<How>> recovering;

}  // namespace rmpl::grammar

/// A directive is called what its subject is called.
template <class Parser>
requires requires {
  typename Parser::subject_type;
  requires std::is_base_of_v<rmpl::grammar::DirectiveBase, Parser>;
}
struct boost::spirit::x3::get_info<Parser> {
  using result_type = std::string;
  std::string operator()(const Parser& parser) const { return what(parser.subject); }
};
