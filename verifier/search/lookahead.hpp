// Lookahead: the successors of states that a search will come to, worked out by other threads.
//
// The search itself stays one thread's, in one order: it takes each state's successors from here, where another thread
// may have worked them out already, and else works them out itself. What is found, how it is numbered and in which
// order is therefore the same for any number of threads.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <vector>

#include "verifier/search/limits.hpp"
#include "verifier/search/system.hpp"

namespace rmpl::verifier {

class Lookahead {
 public:
  /// `threads` counts the caller's. Each of the others works with a copy of the system; none is started where the
  /// system has none. Keeps references; the meter is polled, by the caller's thread alone.
  Lookahead(CopyableSystem& system, unsigned threads, Meter& meter);
  Lookahead(const Lookahead&) = delete;
  Lookahead& operator=(const Lookahead&) = delete;
  ~Lookahead();

  /// How many states it is worth naming ahead.
  [[nodiscard]] std::size_t window() const { return workers_.empty() ? 0 : states_a_thread * (workers_.size() + 1); }
  /// Whether few of the states that were announced are left.
  [[nodiscard]] bool runs_dry() const { return 2 * tasks_.size() < window(); }
  [[nodiscard]] bool knows(std::uint32_t node) const { return tasks_.contains(node); }
  /// The state, a node of the search, will be come to, in the order of these calls.
  void announce(std::uint32_t node, SymbolicState state);
  /// Lets the other threads have what was announced.
  void begin();
  /// It will not.
  void forget(std::uint32_t node);
  /// Visits the successors of a node, announced or not. Throws what working them out throws.
  void successors(std::uint32_t node, const SymbolicState& state, const TransitionSystem::Visit& visit);

 private:
  static constexpr std::size_t states_a_thread = 32;

  struct Successor {
    CopyableSystem::Key key;
    unsigned faults;
    Zone zone;
    Label label;
  };
  struct Task {
    CopyableSystem::Key key;
    unsigned faults;
    Zone zone;
    enum class Progress { waiting, taken, done } progress = Progress::waiting;
    std::vector<Successor> successors;
    std::exception_ptr failure;
  };

  void work();
  void work_out(CopyableSystem& copy, Task& task);

  CopyableSystem& system_;
  Meter& meter_;
  std::atomic<bool> stopped_ = false;
  Limits limits_;  ///< of the copies
  std::unordered_map<std::uint32_t, std::shared_ptr<Task>> tasks_;
  std::vector<std::shared_ptr<Task>> announced_;  ///< not yet in the queue

  // Between the threads, under the mutex:
  std::mutex mutex_;
  std::condition_variable waiting_, done_;
  std::deque<std::shared_ptr<Task>> queue_;

  std::vector<std::thread> workers_;
};

}  // namespace rmpl::verifier
