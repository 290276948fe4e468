// Minimal cut sets by one exploration, fewest faults first.
// SPDX-License-Identifier: MIT
#include "verifier/plant/cut_sets.hpp"

#include <algorithm>
#include <deque>
#include <map>

#include "verifier/search/passed.hpp"

namespace rmpl::verifier {
namespace {

class Exploration {
 public:
  Exploration(TransitionSystem& system, const FaultSets& sets, Meter& meter)
      : system_(system), sets_(sets), meter_(meter), passed_(system, false) {}

  std::vector<CutPath> run() {
    system_.initial([&](SymbolicState&& state, const Label& label) { add(state, label, Passed::none, 0); });
    // Levels are emptied in turn: what a level adds is on it or above it.
    while (!levels_.empty()) {
      auto& level = levels_.begin()->second;
      if (level.empty()) {
        levels_.erase(levels_.begin());
        continue;
      }
      const std::uint32_t node = level.front();
      level.pop_front();
      visit(node);
    }
    return minimal();
  }

 private:
  void add(const SymbolicState& state, const Label& label, std::uint32_t parent, std::uint32_t steps) {
    if (superfluous(state.faults)) return;
    const std::uint32_t node = passed_.add(state, label, parent, steps);
    if (node == Passed::none) return;
    meter_.count_state();
    auto& level = levels_[sets_[state.faults].count];
    if (label.silent) {
      level.push_front(node);
    } else {
      level.push_back(node);
    }
  }

  void visit(std::uint32_t node) {
    const std::uint32_t steps = passed_[node].steps;
    meter_.at_faults(levels_.begin()->first, levels_.begin()->second.size());
    meter_.poll();
    if (passed_[node].covered || superfluous(passed_[node].faults)) return;
    const SymbolicState state = passed_.state(node);
    if (system_.accepts(state)) {
      found_.push_back({sets_[state.faults], passed_.path(node), state});
      return;
    }
    system_.successors(state, [&](SymbolicState&& next, const Label& label) {
      add(next, label, node, label.silent ? steps : steps + 1);
    });
  }

  [[nodiscard]] bool superfluous(unsigned faults) const {
    return std::any_of(found_.begin(), found_.end(),
                       [&](const CutPath& cut) { return subset(cut.set, sets_[faults]); });
  }

  /// A set found early can hold one that was found later, in a run on which a fault comes twice.
  std::vector<CutPath> minimal() {
    std::vector<CutPath> result;
    for (const CutPath& cut : found_) {
      const bool holds_another = std::any_of(found_.begin(), found_.end(), [&](const CutPath& other) {
        return other.set.faults != cut.set.faults && subset(other.set, cut.set);
      });
      if (!holds_another) result.push_back(cut);
    }
    std::sort(result.begin(), result.end(), [](const CutPath& a, const CutPath& b) {
      return std::pair(a.set.faults.size(), a.set.faults) < std::pair(b.set.faults.size(), b.set.faults);
    });
    return result;
  }

  TransitionSystem& system_;
  const FaultSets& sets_;
  Meter& meter_;
  Passed passed_;
  std::map<unsigned, std::deque<std::uint32_t>> levels_;  ///< by number of faults
  std::vector<CutPath> found_;
};

}  // namespace

std::vector<CutPath> minimal_cut_sets(TransitionSystem& system, const FaultSets& sets, Meter& meter) {
  return Exploration(system, sets, meter).run();
}

}  // namespace rmpl::verifier
