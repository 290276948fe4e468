// Breadth-first search with inclusion checking.
// SPDX-License-Identifier: MIT
#include "verifier/explore/search.hpp"

#include <algorithm>
#include <deque>
#include <unordered_map>

namespace verifier {
namespace {

constexpr std::uint32_t no_parent = UINT32_MAX;

struct Node {
  SymbolicState state;
  Label label;
  std::uint32_t parent;
  std::uint32_t steps;
};

class Search {
 public:
  Search(TransitionSystem& system, Meter& meter) : system_(system), meter_(meter) {}

  std::optional<std::vector<PathState>> run() {
    system_.initial([&](SymbolicState&& state, const Label& label) { add(std::move(state), label, no_parent, 0); });
    while (!found_ && !queue_.empty()) {
      const std::uint32_t parent = queue_.front();
      queue_.pop_front();
      const std::uint32_t steps = nodes_[parent].steps;
      meter_.poll();
      // A copy, as `nodes_` grows meanwhile; a deque would keep references good at the price of scattered nodes.
      const SymbolicState state = nodes_[parent].state;
      system_.successors(state, [&](SymbolicState&& next, const Label& label) {
        if (!found_) add(std::move(next), label, parent, steps);
      });
    }
    if (!found_) return std::nullopt;
    return path(*found_);
  }

 private:
  void add(SymbolicState&& state, const Label& label, std::uint32_t parent, std::uint32_t steps) {
    std::vector<std::uint32_t>& known = by_discrete_[state.discrete];
    const auto includes = [](const SymbolicState& a, const SymbolicState& b) {
      return a.faults <= b.faults && a.zone.includes(b.zone);
    };
    if (std::any_of(known.begin(), known.end(), [&](std::uint32_t k) { return includes(nodes_[k].state, state); })) {
      return;
    }
    // What the new state includes is not compared with any more; it stays in the queue, as it may be fewer steps away.
    std::erase_if(known, [&](std::uint32_t k) { return includes(state, nodes_[k].state); });
    meter_.count_state();
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    known.push_back(number);
    if (system_.accepts(state)) found_ = number;
    const bool counts = !label.silent && parent != no_parent;
    nodes_.push_back({std::move(state), label, parent, counts ? steps + 1 : steps});
    if (label.silent) {
      queue_.push_front(number);
    } else {
      queue_.push_back(number);
    }
    meter_.at(steps, queue_.size());
  }

  [[nodiscard]] std::vector<PathState> path(std::uint32_t last) const {
    std::vector<PathState> result;
    for (std::uint32_t node = last; node != no_parent; node = nodes_[node].parent) {
      result.push_back({nodes_[node].state.discrete, nodes_[node].label});
    }
    std::reverse(result.begin(), result.end());
    return result;
  }

  TransitionSystem& system_;
  Meter& meter_;
  std::vector<Node> nodes_;
  std::deque<std::uint32_t> queue_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> by_discrete_;  ///< looked up, never iterated
  std::optional<std::uint32_t> found_;
};

}  // namespace

std::optional<std::vector<PathState>> shortest_path(TransitionSystem& system, Meter& meter) {
  return Search(system, meter).run();
}

}  // namespace verifier
