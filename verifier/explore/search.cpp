// Search with inclusion checking.
// SPDX-License-Identifier: MIT
#include "verifier/explore/search.hpp"

#include <deque>
#include <map>

namespace verifier {
namespace {

class Search {
 public:
  Search(TransitionSystem& system, SearchOrder order, Meter& meter)
      : system_(system), order_(order), meter_(meter), passed_(system, order == SearchOrder::fewest_steps) {}

  std::optional<std::vector<PathState>> run() {
    system_.initial([&](SymbolicState&& state, const Label& label) { add(state, label, Passed::none, 0); });
    while (!found_ && !queues_.empty()) {
      const auto queue = queues_.begin();
      if (queue->second.empty()) {
        queues_.erase(queue);
        continue;
      }
      const std::uint32_t parent = queue->second.front();
      queue->second.pop_front();
      if (order_ == SearchOrder::covering && passed_[parent].covered) continue;
      const std::uint32_t steps = passed_[parent].steps;
      meter_.at(steps, queue->second.size());
      meter_.used_faults(system_.fault_count(passed_[parent].faults));
      meter_.poll();
      system_.successors(passed_.state(parent), [&](SymbolicState&& next, const Label& label) {
        if (!found_) add(next, label, parent, label.silent ? steps : steps + 1);
      });
    }
    if (!found_) return std::nullopt;
    return passed_.path(*found_);
  }

 private:
  void add(const SymbolicState& state, const Label& label, std::uint32_t parent, std::uint32_t steps) {
    const std::uint32_t number = passed_.add(state, label, parent, steps);
    if (number == Passed::none) return;
    meter_.count_state();
    if (system_.accepts(state)) found_ = number;
    auto& queue = queues_[order_ == SearchOrder::covering ? system_.fault_count(state.faults) : 0];
    if (label.silent) {
      queue.push_front(number);
    } else {
      queue.push_back(number);
    }
  }

  TransitionSystem& system_;
  SearchOrder order_;
  Meter& meter_;
  Passed passed_;
  std::map<unsigned, std::deque<std::uint32_t>> queues_;  ///< by number of faults where that is the order
  std::optional<std::uint32_t> found_;
};

}  // namespace

std::optional<std::vector<PathState>> find_path(TransitionSystem& system, SearchOrder order, Meter& meter) {
  return Search(system, order, meter).run();
}

}  // namespace verifier
