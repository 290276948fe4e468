// Which brackets are open at a place of a text.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

namespace rmpl::grammar {

/// Reads a text once, from place to place, however often it is asked.
class Brackets {
 public:
  explicit Brackets(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

  /// The innermost bracket of this kind, `(`, `[` or `{`, that is open before `place`; null where there is none. Places
  /// are asked for in the order of the text.
  const char* open(char kind, const char* place);

 private:
  void close(char kind);

  const char* at_;
  const char* end_;
  std::vector<const char*> open_;
};

}  // namespace rmpl::grammar
