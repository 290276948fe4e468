// The one style on random texts: all that is said stays, comments stay, and what is formatted is settled.
// SPDX-License-Identifier: MIT
#include "compiler/format/format.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/property/generate.hpp"
#include "tests/sentences/sentences.hpp"

namespace rmpl::property {
namespace {

/// That tokens, comments and tree stay, the formatter checks by itself: it throws where they do not.
void is_settled(const std::string& text, compiler::Kind kind) {
  RC_LOG() << text << std::endl;
  const auto once = compiler::format(text, kind);
  RC_ASSERT(once.has_value());
  RC_LOG() << *once << std::endl;
  RC_ASSERT(compiler::format(*once, kind) == once);
}

RC_GTEST_PROP(Format, ProgramsAreSettled, ()) {
  const Model model = *models();
  is_settled((*sources(model.plant)).text, compiler::Kind::program);
}

RC_GTEST_PROP(Format, CommentsInEveryPlaceStay, ()) {
  static const sentences::Sentences grammar;
  const auto kind = *rc::gen::element(compiler::Kind::program, compiler::Kind::plant, compiler::Kind::scenario,
                                      compiler::Kind::properties);
  sentences::Random random(*rc::gen::arbitrary<std::uint64_t>());
  is_settled(sentences::scattered_text(grammar.draw(kind, random), true, random), kind);
}

}  // namespace
}  // namespace rmpl::property
