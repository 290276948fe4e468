// A queue of tasks and the threads that take from it.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/flights.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <optional>
#include <system_error>
#include <thread>

#include "tools/shared/interruption.hpp"

namespace rmpl::tools {
namespace {

class Flights {
 public:
  Flights(const std::vector<Task>& tasks, const FlightOptions& options, const Common& common)
      : tasks_(tasks),
        options_(options),
        common_(common),
        voices_(tasks.size()),
        flown_(tasks.size()),
        failures_(tasks.size()) {}

  std::vector<std::optional<Flown>> fly_all() {
    std::vector<std::thread> others;
    const std::size_t jobs = std::min<std::size_t>(options_.jobs, tasks_.size());
    try {
      for (std::size_t j = 1; j < jobs; ++j) others.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      // The system gives no more threads: those that there are do it.
    }
    work();
    for (std::thread& other : others) other.join();
    for (const std::exception_ptr& failure : failures_) {
      if (failure) std::rethrow_exception(failure);
    }
    return std::move(flown_);
  }

 private:
  void work() {
    while (!failed_ && !interrupted()) {
      const std::size_t task = next_++;
      if (task >= tasks_.size()) return;
      try {
        flown_[task] = fly(tasks_[task], options_, common_, voices_, task, tasks_.size());
        if (flown_[task]->result.interrupted) return;  // it keeps the word: no other flight is told
        voices_.done(task);
      } catch (...) {
        // Tasks before this one have been begun, and go on to their ends; the word stays here.
        failures_[task] = std::current_exception();
        failed_ = true;
      }
    }
  }

  const std::vector<Task>& tasks_;
  const FlightOptions& options_;
  const Common& common_;
  InTurn voices_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::vector<std::optional<Flown>> flown_;
  std::vector<std::exception_ptr> failures_;
};

}  // namespace

std::vector<std::optional<Flown>> fly_all(const std::vector<Task>& tasks, const FlightOptions& options,
                                          const Common& common) {
  return Flights(tasks, options, common).fly_all();
}

}  // namespace rmpl::tools
