// This thread works too: where the system gives no other, all is done all the same.
// SPDX-License-Identifier: MIT
#include "base/work_together.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace rmpl::base {

void work_together(std::size_t threads, FunctionRef<void()> work) {
  std::mutex mutex;
  std::exception_ptr failure;
  const auto guarded = [&] {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  try {
    for (std::size_t t = 1; t < threads; ++t) others.emplace_back(guarded);
  } catch (const std::system_error&) {
    // The system gives no more threads: those that there are do it.
  }
  guarded();
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

void share_tasks(std::size_t threads, std::size_t count, FunctionRef<void(std::size_t task, std::size_t thread)> task) {
  std::atomic<std::size_t> next = 0, thread = 0;
  std::atomic<bool> failed = false;
  std::vector<std::exception_ptr> failures(count);
  work_together(std::min(threads, count), [&] {
    const std::size_t own = thread++;
    while (!failed) {
      const std::size_t one = next++;
      if (one >= count) return;
      try {
        task(one, own);
      } catch (...) {
        failures[one] = std::current_exception();
        failed = true;
      }
    }
  });
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace rmpl::base
