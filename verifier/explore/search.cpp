// Breadth-first search with inclusion checking.
// SPDX-License-Identifier: MIT
#include "verifier/explore/search.hpp"

#include <algorithm>
#include <deque>

#include "verifier/explore/passed.hpp"

namespace verifier {
namespace {

class Search {
 public:
  Search(TransitionSystem& system, SearchOrder order, Meter& meter)
      : system_(system), order_(order), meter_(meter), passed_(system) {}

  std::optional<std::vector<PathState>> run() {
    system_.initial([&](SymbolicState&& state, const Label& label) { add(state, label, Passed::none, 0); });
    while (!found_ && !queue_.empty()) {
      const std::uint32_t parent = queue_.front();
      queue_.pop_front();
      if (order_ == SearchOrder::any && passed_[parent].covered) continue;
      const std::uint32_t steps = passed_[parent].steps;
      meter_.at(steps, queue_.size());
      meter_.poll();
      system_.successors(passed_.state(parent), [&](SymbolicState&& next, const Label& label) {
        if (!found_) add(next, label, parent, label.silent ? steps : steps + 1);
      });
    }
    if (!found_) return std::nullopt;
    return path(*found_);
  }

 private:
  void add(const SymbolicState& state, const Label& label, std::uint32_t parent, std::uint32_t steps) {
    const std::uint32_t number = passed_.add(state, label, parent, steps);
    if (number == Passed::none) return;
    meter_.count_state();
    if (system_.accepts(state)) found_ = number;
    if (label.silent) {
      queue_.push_front(number);
    } else {
      queue_.push_back(number);
    }
  }

  [[nodiscard]] std::vector<PathState> path(std::uint32_t last) const {
    std::vector<PathState> result;
    for (std::uint32_t n = last; n != Passed::none; n = passed_[n].parent) {
      result.push_back({passed_[n].discrete, passed_[n].label});
    }
    std::reverse(result.begin(), result.end());
    return result;
  }

  TransitionSystem& system_;
  SearchOrder order_;
  Meter& meter_;
  Passed passed_;
  std::deque<std::uint32_t> queue_;
  std::optional<std::uint32_t> found_;
};

}  // namespace

std::optional<std::vector<PathState>> find_path(TransitionSystem& system, SearchOrder order, Meter& meter) {
  return Search(system, order, meter).run();
}

}  // namespace verifier
