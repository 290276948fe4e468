// What was probably meant where a text does not follow the grammar: habits of other languages, slips of the pen.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rmpl::grammar {

/// A place where something else was expected.
struct Unexpected {
  std::string_view before;    ///< the text up to the token
  std::string_view found;     ///< the token, as `token_at` cuts it
  std::string_view behind;    ///< the text from its end on
  std::string_view expected;  ///< what could have stood there; keywords and signs between backquotes
  bool clocks = true;         ///< the text may speak of clocks
};

/// What to do about it.
struct Hint {
  std::string suggestion;     ///< as a sentence
  std::string_view replaced;  ///< the part of the text that is to be replaced; empty where there is none
  std::string text;           ///< by this
};

/// Nothing where nothing is near.
std::optional<Hint> hint(const Unexpected& place);

}  // namespace rmpl::grammar
