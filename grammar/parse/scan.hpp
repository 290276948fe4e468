// Tokens in plain characters: blanks, identifiers, numbers, operators (language.md "Lexical").
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "grammar/ast/token.hpp"
#include "grammar/parse/state.hpp"

namespace rmpl::grammar {

bool is_space(char c);
/// Behind white space and comments. An unclosed comment is not skipped: it is then found where something else was
/// expected.
const char* skip_blank(const char* first, const char* last);

/// The identifier, reserved or not, that starts exactly at `first`; empty where there is none.
std::string_view identifier_at(const char* first, const char* last);
/// Whether a word is reserved everywhere.
bool is_reserved(std::string_view word);
/// The longest operator or bracket that starts exactly at `first`; empty where there is none.
std::string_view operator_at(const char* first, const char* last);
/// The decimal number without sign that starts exactly at `first`; empty where there is none.
std::string_view number_at(const char* first, const char* last);
/// The token of whatever kind that starts exactly at `first` (not at the end): at least one code point.
std::string_view token_at(const char* first, const char* last);

// Each skips blanks, and on success sets the token and moves `first` behind it; else leaves `first` alone.

bool scan_name(const char*& first, ParseState& state, Name& name);
/// A name, or `true` or `false`.
bool scan_value(const char*& first, ParseState& state, Name& value);
/// ns us ms s min mins h d w weeks.
bool scan_unit(const char*& first, ParseState& state, Name& unit);
/// Reports a number beyond the range of a double, and goes on.
bool scan_number(const char*& first, ParseState& state, Number& number);
/// The same with an optional `+` or `-` before it.
bool scan_signed_number(const char*& first, ParseState& state, Number& number);
/// Digits only; reports a number of 2^64 or more, and goes on.
bool scan_whole_number(const char*& first, ParseState& state, std::uint64_t& number);
bool scan_duration(const char*& first, ParseState& state, Duration& duration);
/// A duration, or `inf`.
bool scan_bound(const char*& first, ParseState& state, Duration& bound);
/// A string on one line.
bool scan_string(const char*& first, ParseState& state, String& string);
/// The number `0`, as it stands.
bool scan_zero(const char*& first, ParseState& state);
/// The word with its end: `do` is not the start of `donext`.
bool scan_word(const char*& first, ParseState& state, std::string_view word);
/// The operator: `<` is not the start of `<=`.
bool scan_operator(const char*& first, ParseState& state, std::string_view symbol);
/// The end of the text.
bool scan_end(const char*& first, ParseState& state);

}  // namespace rmpl::grammar
