// A program that runs out of memory where nothing may be thrown says so, and ends as one that hit a limit.
// SPDX-License-Identifier: MIT
#include "base/out_of_memory.hpp"

#include <gtest/gtest.h>

#include <exception>
#include <new>
#include <stdexcept>

#include "base/check.hpp"

namespace rmpl::base {
namespace {

/// As a destructor would, that needs memory or has another problem.
template <class Error>
void fail(const Error& error) noexcept {
  std::set_terminate([] { base::end_for_lack_of_memory("program"); });
  std::rethrow_exception(std::make_exception_ptr(error));
}

TEST(OutOfMemoryDeathTest, IsALimit) {
  EXPECT_EXIT(fail(std::bad_alloc()), testing::ExitedWithCode(3), "program: out of memory");
}

TEST(OutOfMemoryDeathTest, AFailedCheckIsAnInternalError) {
  EXPECT_EXIT(fail(InternalError("base/x.cpp:1: expected order")), testing::ExitedWithCode(4),
              "program: internal error, nothing is claimed: base/x.cpp:1: expected order");
}

TEST(OutOfMemoryDeathTest, AnythingElseIsOurFault) {
  EXPECT_DEATH(fail(std::logic_error("a mistake")), "program: a mistake");
}

}  // namespace
}  // namespace rmpl::base
