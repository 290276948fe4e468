// Minimal cut sets by one exploration, fewest faults first.
// SPDX-License-Identifier: MIT
#include "verifier/cut_set/cut_sets.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <set>

#include "verifier/search/passed.hpp"

namespace rmpl::verifier {
namespace {

class Exploration {
 public:
  Exploration(TransitionSystem& system, const FaultSets& sets, Meter& meter,
              base::FunctionRef<bool(const CutPath&)> found)
      : system_(system), sets_(sets), meter_(meter), take_(found), passed_(system, false) {}

  CutPaths run() {
    CutPaths result;
    try {
      explore();
    } catch (const LimitReached& reached) {
      result.limit = reached.limit;
    }
    // Where a limit was hit a smaller set may be found yet, after a fault that comes twice. And a set found early can
    // hold one that was found later, in a run on which a fault comes twice.
    const FaultSetTree open = result.limit ? open_sets() : FaultSetTree();
    for (const FaultSet& cut : found_) {
      if (open.holds_proper_subset_of(cut.faults) || known_.holds_proper_subset_of(cut.faults)) continue;
      result.sets.push_back(cut);
    }
    std::sort(result.sets.begin(), result.sets.end(), told_before);
    return result;
  }

 private:
  void explore() {
    system_.initial([&](SymbolicState&& state, const Label& label) { add(state, label, Passed::none, 0); });
    // Levels are emptied in turn: what a level adds is on it or above it.
    while (!levels_.empty() && !refused_) {
      auto& level = levels_.begin()->second;
      if (level.empty()) {
        levels_.erase(levels_.begin());
        continue;
      }
      visited_ = level.front();
      level.pop_front();
      visit(visited_);
    }
  }

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
    meter_.used_faults(levels_.begin()->first);
    meter_.poll();
    if (passed_[node].covered || superfluous(passed_[node].faults)) return;
    const SymbolicState state = passed_.state(node);
    if (system_.accepts(state)) {
      refused_ = !take_({sets_[state.faults], passed_.path(node), state});
      found_.push_back(sets_[state.faults]);
      known_.add(found_.back().faults);
      return;
    }
    system_.successors(state, [&](SymbolicState&& next, const Label& label) {
      add(next, label, node, label.silent ? steps : steps + 1);
    });
  }

  [[nodiscard]] bool superfluous(unsigned faults) const { return known_.holds_subset_of(sets_[faults].faults); }

  /// The sets of the states that are yet to be explored, with that which a limit left half explored.
  [[nodiscard]] FaultSetTree open_sets() const {
    std::set<unsigned> numbers;
    if (visited_ != Passed::none) numbers.insert(passed_[visited_].faults);
    for (const auto& [count, level] : levels_) {
      for (const std::uint32_t node : level) {
        if (!passed_[node].covered) numbers.insert(passed_[node].faults);
      }
    }
    FaultSetTree result;
    for (const unsigned number : numbers) result.add(sets_[number].faults);
    return result;
  }

  TransitionSystem& system_;
  const FaultSets& sets_;
  Meter& meter_;
  base::FunctionRef<bool(const CutPath&)> take_;
  Passed passed_;
  std::map<unsigned, std::deque<std::uint32_t>> levels_;  ///< by number of faults
  std::vector<FaultSet> found_;
  FaultSetTree known_;  ///< the same
  bool refused_ = false;
  std::uint32_t visited_ = Passed::none;  ///< the last one
};

}  // namespace

CutPaths minimal_cut_sets(TransitionSystem& system, const FaultSets& sets, Meter& meter,
                          base::FunctionRef<bool(const CutPath&)> found) {
  return Exploration(system, sets, meter, found).run();
}

}  // namespace rmpl::verifier
