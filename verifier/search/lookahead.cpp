// Lookahead: successors worked out by other threads.
// SPDX-License-Identifier: MIT
#include "verifier/search/lookahead.hpp"

#include <chrono>
#include <system_error>
#include <utility>

namespace rmpl::verifier {

Lookahead::Lookahead(CopyableSystem& system, unsigned threads, Meter& meter) : system_(system), meter_(meter) {
  limits_.interrupted = &stopped_;
  workers_.reserve(threads - 1);
  try {
    while (workers_.size() + 1 < threads) workers_.emplace_back([this] { work(); });
  } catch (const std::system_error&) {
    // The system gives no more threads: those that there are do, the result is the same.
  }
}

Lookahead::~Lookahead() {
  stopped_ = true;
  {
    const std::lock_guard lock(mutex_);
    queue_.clear();
  }
  waiting_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void Lookahead::announce(std::uint32_t node, SymbolicState state) {
  auto task = std::make_shared<Task>(
      Task{system_.key(state.discrete), state.faults, std::move(state.zone), Task::Progress::waiting, {}, nullptr});
  tasks_.emplace(node, task);
  announced_.push_back(std::move(task));
}

void Lookahead::begin() {
  if (announced_.empty()) return;
  {
    const std::lock_guard lock(mutex_);
    queue_.insert(queue_.end(), announced_.begin(), announced_.end());
  }
  announced_.clear();
  waiting_.notify_all();
}

void Lookahead::forget(std::uint32_t node) {
  const auto known = tasks_.find(node);
  if (known == tasks_.end()) return;
  {
    const std::lock_guard lock(mutex_);
    if (known->second->progress == Task::Progress::waiting) known->second->progress = Task::Progress::taken;
  }
  tasks_.erase(known);
}

void Lookahead::successors(std::uint32_t node, const SymbolicState& state, const TransitionSystem::Visit& visit) {
  const auto known = tasks_.find(node);
  if (known == tasks_.end()) return system_.successors(state, visit);
  const std::shared_ptr<Task> task = std::move(known->second);
  tasks_.erase(known);
  std::unique_lock lock(mutex_);
  if (task->progress == Task::Progress::waiting) {
    task->progress = Task::Progress::taken;
    while (!queue_.empty() && queue_.front()->progress != Task::Progress::waiting) queue_.pop_front();
    lock.unlock();
    return system_.successors(state, visit);
  }
  while (task->progress != Task::Progress::done) {
    done_.wait_for(lock, std::chrono::milliseconds(20));
    meter_.poll();
  }
  lock.unlock();
  if (task->failure) std::rethrow_exception(task->failure);
  for (Successor& next : task->successors) {
    visit({system_.number(next.key), next.faults, std::move(next.zone)}, next.label);
  }
}

void Lookahead::work() {
  std::unique_ptr<CopyableSystem> copy;
  while (true) {
    std::shared_ptr<Task> task;
    {
      std::unique_lock lock(mutex_);
      waiting_.wait(lock, [this] { return stopped_ || !queue_.empty(); });
      if (stopped_) return;
      // The last one: the search comes to the first ones itself before they would be done here.
      task = std::move(queue_.back());
      queue_.pop_back();
      if (task->progress != Task::Progress::waiting) continue;
      task->progress = Task::Progress::taken;
    }
    try {
      if (!copy) copy = system_.copy(limits_);
      work_out(*copy, *task);
    } catch (...) {
      task->failure = std::current_exception();
    }
    {
      const std::lock_guard lock(mutex_);
      task->progress = Task::Progress::done;
    }
    done_.notify_all();
  }
}

void Lookahead::work_out(CopyableSystem& copy, Task& task) {
  copy.successors({copy.number(task.key), task.faults, std::move(task.zone)},
                  [&](SymbolicState&& next, const Label& label) {
                    task.successors.push_back({copy.key(next.discrete), next.faults, std::move(next.zone), label});
                  });
}

}  // namespace rmpl::verifier
