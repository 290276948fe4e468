// Sentences of the grammars: the parsers take them, they can be formatted, and what comes out is settled.
// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "compiler/format/format.hpp"
#include "grammar/source/render.hpp"
#include "tests/sentences/sentences.hpp"

using namespace rmpl;

namespace {

constexpr compiler::Kind kinds[] = {compiler::Kind::program, compiler::Kind::plant, compiler::Kind::scenario,
                                    compiler::Kind::properties};

/// What is wrong with a text, or nothing. That a layout holds the tokens, the comments and the tree of its text is
/// checked by the formatter itself, which throws.
std::string complaint(const std::string& text, compiler::Kind kind, std::string& formatted) {
  grammar::Findings findings;
  const auto file = findings.sources.add("sentence", text);
  const auto once = compiler::format(findings.sources, file, kind, findings.diagnostics);
  if (!once) return "is refused:\n" + grammar::render_text(findings, false);
  const auto twice = compiler::format(*once, kind);
  if (!twice) return "is refused once it is formatted:\n" + *once;
  if (*twice != *once) return "is formatted to\n" + *once + "and that to\n" + *twice;
  formatted = *once;
  return {};
}

/// Whether a sentence is as it should be, with blanks and comments of whatever kind. Tells where it is not.
bool try_sentence(const sentences::Sentences& grammar, compiler::Kind kind, sentences::Random& random) {
  const auto tokens = grammar.draw(kind, random);
  const std::string plain = sentences::plain_text(tokens);
  const std::string scattered = sentences::scattered_text(tokens, false, random);
  const std::string commented = sentences::scattered_text(tokens, true, random);
  std::string formatted, again, with_comments;
  const auto fails = [&](const std::string& text, std::string& result) {
    std::string wrong;
    try {
      wrong = complaint(text, kind, result);
    } catch (const std::exception& error) {
      wrong = error.what();
    }
    if (!wrong.empty()) std::cout << "the sentence\n" << text << "\n" << wrong << "\n";
    return !wrong.empty();
  };
  if (fails(plain, formatted) || fails(scattered, again) || fails(commented, with_comments)) return false;
  if (formatted == again) return true;
  std::cout << "the layout depends on blanks: of\n" << scattered << "\nit is\n" << again << "and else\n" << formatted;
  return false;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::cerr << "usage: sentences COUNT SEED\n";
    return 2;
  }
  const unsigned long long sentences = std::strtoull(arguments[1], nullptr, 10);
  rmpl::sentences::Random random(std::strtoull(arguments[2], nullptr, 10));
  const rmpl::sentences::Sentences grammar;
  unsigned long long failures = 0;
  for (unsigned long long i = 0; i < sentences && failures < 10; ++i) {
    if (!try_sentence(grammar, kinds[i % 4], random)) ++failures;
  }
  std::cout << sentences << " sentences, " << failures << " failures\n";
  return failures == 0 ? 0 : 1;
}
