// A program that ends where nothing may be thrown says why, and its exit code is no verdict.
// SPDX-License-Identifier: MIT
#include "tools/shared/last_words.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <exception>
#include <limits>
#include <new>
#include <pugixml.hpp>
#include <stdexcept>
#include <system_error>

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

TEST(LastWordsDeathTest, SoIsACallOfTheSystemThatLacksIt) {
  const std::system_error error(std::make_error_code(std::errc::not_enough_memory), "cannot make absolute path");
  EXPECT_EXIT(fail(error), testing::ExitedWithCode(3), "unit_tools: out of memory");
}

/// It would go on without what it was to add.
TEST(LastWordsDeathTest, SoIsAnXmlDocumentThatLacksIt) {
  if (RMPL_SANITIZED) GTEST_SKIP() << "the sanitizer ends what asks for so much";
  constexpr auto too_much = std::numeric_limits<std::ptrdiff_t>::max();
  EXPECT_EXIT(pugi::get_memory_allocation_function()(too_much), testing::ExitedWithCode(3),
              "unit_tools: out of memory");
}

TEST(LastWordsDeathTest, AFailedCheckIsAnInternalError) {
  EXPECT_EXIT(fail(base::InternalError("base/x.cpp:1: expected order")), testing::ExitedWithCode(4),
              "unit_tools: internal error, so there is no result: base/x.cpp:1: expected order");
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
