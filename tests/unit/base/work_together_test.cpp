// Threads that share tasks.
// SPDX-License-Identifier: MIT
#include "base/work_together.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace rmpl::base {
namespace {

TEST(WorkTogether, EveryThreadDoesIt) {
  std::atomic<int> calls = 0;
  work_together(4, [&] { ++calls; });
  EXPECT_EQ(calls, 4);
  work_together(0, [&] { ++calls; });
  EXPECT_EQ(calls, 5) << "this thread always does";
}

TEST(WorkTogether, OthersEndBeforeAFailureIsThrown) {
  std::atomic<int> calls = 0;
  const auto work = [&] {
    if (++calls == 2) throw std::runtime_error("second");
  };
  EXPECT_THROW(work_together(4, work), std::runtime_error);
  EXPECT_EQ(calls, 4);
}

TEST(ShareTasks, EachIsDoneOnceByANumberedThread) {
  std::vector<std::atomic<int>> done(100);
  std::atomic<bool> numbered = true;
  share_tasks(3, done.size(), [&](std::size_t task, std::size_t thread) {
    ++done[task];
    if (thread >= 3) numbered = false;
  });
  for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
  EXPECT_TRUE(numbered);
  share_tasks(3, 0, [](std::size_t, std::size_t) { FAIL() << "there is none"; });
}

TEST(ShareTasks, TheFirstFailureByNumberIsThrown) {
  for (std::size_t threads = 1; threads <= 4; ++threads) {
    std::string told;
    try {
      share_tasks(threads, 50, [](std::size_t task, std::size_t) {
        if (task % 7 == 3) throw std::runtime_error(std::to_string(task));
      });
    } catch (const std::runtime_error& error) {
      told = error.what();
    }
    EXPECT_EQ(told, "3") << threads << " threads";
  }
}

}  // namespace
}  // namespace rmpl::base
