// Other programs: what they print, how they end, and that they end.
// SPDX-License-Identifier: MIT
#include "tools/shared/child_process.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace rmpl::tools {
namespace {

using std::chrono::duration;

TEST(ChildProcess, TellsWhatItPrintsAndHowItEnds) {
  const auto end = run_child({{"sh", "-c", "cat; echo oh >&2; exit 3"}, "in"});
  ASSERT_TRUE(end);
  EXPECT_EQ(end->status, 3);
  EXPECT_EQ(end->output, "in");
  EXPECT_EQ(end->errors, "oh\n");
  EXPECT_FALSE(end->late);
}

TEST(ChildProcess, TellsThatASignalEndedIt) {
  const auto end = run_child({{"sh", "-c", "kill -KILL $$"}});
  ASSERT_TRUE(end);
  EXPECT_FALSE(end->status);
  EXPECT_EQ(end->signal, SIGKILL);
}

TEST(ChildProcess, IsAskedToEndWhereItsTimeIsOver) {
  const auto end = run_child({.arguments = {"sh", "-c", "trap 'echo bye; exit 3' TERM; while :; do sleep 0.01; done"},
                              .time_limit = duration<double>(0.2)});
  ASSERT_TRUE(end);
  EXPECT_TRUE(end->late);
  EXPECT_EQ(end->status, 3);
  EXPECT_EQ(end->output, "bye\n");
}

TEST(ChildProcess, IsAskedToEndAfterAnInterruption) {
  const auto end = run_child({.arguments = {"sleep", "60"}, .interrupted = [] { return true; }});
  ASSERT_TRUE(end);
  EXPECT_FALSE(end->late);
  EXPECT_EQ(end->signal, SIGTERM);
}

TEST(ChildProcess, IsNoneWhereThereIsNoSuchProgram) { EXPECT_FALSE(run_child({{"there-is-no-such-program"}})); }

}  // namespace
}  // namespace rmpl::tools
