// What is thrown inside a program, by the exit code that scripts see.
// SPDX-License-Identifier: MIT
#include "tools/shared/program.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/limit_error.hpp"

namespace rmpl::tools {
namespace {

/// A program whose one subcommand throws, up to its exit.
template <class Error>
void end_by(const Error& error) {
  Program program("program", "1.0", "a program", "");
  const Command command = program.add_command("check", "throws");
  program.add({command, [&error]() -> ExitStatus { throw error; }});
  const char* const arguments[] = {"program", "check"};
  std::exit(program.run(2, arguments));
}

TEST(ProgramDeathTest, AWitnessThatFailsIsAnInternalErrorAndNoVerdict) {
  EXPECT_EXIT(end_by(base::InternalError("a witness fails: the step is not possible at 3 s")),
              testing::ExitedWithCode(4),
              "program: internal error, so there is no result: a witness fails: the step is not possible at 3 s");
}

TEST(ProgramDeathTest, AWrongInputIsTold) {
  EXPECT_EXIT(end_by(base::InputError("model.tcca: no such file")), testing::ExitedWithCode(2),
              "program: model.tcca: no such file");
}

TEST(ProgramDeathTest, LimitsAndLackOfMemoryDecideNothing) {
  EXPECT_EXIT(end_by(base::LimitError("the model is too large")), testing::ExitedWithCode(3), "too large");
  EXPECT_EXIT(end_by(std::bad_alloc()), testing::ExitedWithCode(3), "program: out of memory");
}

}  // namespace
}  // namespace rmpl::tools
