// Random sentences of a grammar, token by token.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/session/kind.hpp"
#include "tests/sentences/ebnf.hpp"

namespace rmpl::sentences {

using Random = std::mt19937_64;

/// Draws sentences of the four languages, from grammar/*.ebnf as they stand. What these say between question marks and
/// in comments is programmed here.
class Sentences {
 public:
  /// Throws std::runtime_error where the files are no EBNF, or refer to a rule that there is not.
  Sentences();

  /// The tokens of a whole file. No two of them are one when blanks stand between them.
  [[nodiscard]] std::vector<std::string> draw(compiler::Kind kind, Random& random) const;

 private:
  class Drawing;
  Grammar grammar_;
  std::map<std::string, std::size_t> depths_;  ///< of the shallowest sentence of each rule
  std::vector<std::string> keywords_;          ///< that are not reserved

  [[nodiscard]] std::size_t depth_of(const Expression& expression) const;
  void find_depths();
  void find_keywords(const Expression& expression);
};

/// The tokens with a blank or the end of a line between any two.
std::string plain_text(const std::vector<std::string>& tokens);
/// The same with blanks and ends of lines here and there; with `comments` also comments and blank lines.
std::string scattered_text(const std::vector<std::string>& tokens, bool comments, Random& random);

}  // namespace rmpl::sentences
