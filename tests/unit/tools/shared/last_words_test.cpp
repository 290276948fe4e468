// A program that ends where nothing may be thrown says why, and its exit code is no verdict.
// SPDX-License-Identifier: MIT
#include "tools/shared/last_words.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>

#include "base/check.hpp"

namespace rmpl::tools {
namespace {

/// As a destructor would, that needs memory or has another problem.
template <class Error>
void fail(const Error& error) noexcept {
  std::rethrow_exception(std::make_exception_ptr(error));
}

TEST(LastWordsDeathTest, LackOfMemoryIsALimit) {
  EXPECT_EXIT(fail(std::bad_alloc()), testing::ExitedWithCode(3), "unit_tools: out of memory");
}

TEST(LastWordsDeathTest, AFailedCheckIsAnInternalError) {
  EXPECT_EXIT(fail(base::InternalError("base/x.cpp:1: expected order")), testing::ExitedWithCode(4),
              "unit_tools: internal error, nothing is claimed: base/x.cpp:1: expected order");
}

TEST(LastWordsDeathTest, SoIsAnythingElse) {
  EXPECT_EXIT(fail(std::logic_error("a mistake")), testing::ExitedWithCode(4), "unit_tools: internal error.*a mistake");
}

TEST(LastWordsDeathTest, ALibraryThatExitsGivesNoVerdict) {
  const auto as_bliss_does = [] {
    exit_is_a_failure();
    std::exit(1);
  };
  EXPECT_EXIT(as_bliss_does(), testing::ExitedWithCode(3), "unit_tools: out of memory");
}

}  // namespace
}  // namespace rmpl::tools
