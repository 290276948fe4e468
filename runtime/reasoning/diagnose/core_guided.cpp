// OLL: cores, totalizers, and the bound made permanent.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/core_guided.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::runtime {

using automata::Literal;

bool CoreGuided::minimise() {
  while (true) {
    if (sat_.solve(active_)) {
      // Bounds on cores wait until no core is left without them: cores that share nothing come first, and are small.
      if (waiting_.empty()) return true;
      active_.insert(active_.end(), waiting_.begin(), waiting_.end());
      waiting_.clear();
      continue;
    }
    std::vector<Literal> core = core_of(active_);
    if (core.empty()) return false;
    // Asked again for the core alone, the solver often blames fewer. To leave out one after the other has it find a
    // model for each that is needed, which costs more than the smaller totalizer saves.
    const bool possible = sat_.solve(core);
    CHECK(!possible && "a core is inconsistent");
    (void)possible;
    relax(core_of(core));
  }
}

std::vector<Literal> CoreGuided::core_of(const std::vector<Literal>& assumptions) const {
  std::vector<Literal> core;
  for (const Literal soft : assumptions) {
    if (sat_.failed(soft)) core.push_back(soft);
  }
  return core;
}

void CoreGuided::relax(const std::vector<Literal>& core) {
  ++cost_;
  std::vector<Literal> broken;
  for (const Literal soft : core) {
    broken.push_back(-soft);
    active_.erase(std::find(active_.begin(), active_.end(), soft));
    // A bound that gives way lets one input more hold: the next output of its totalizer takes its place.
    const auto bound_at = bounds_.find(soft);
    if (bound_at == bounds_.end()) continue;
    const auto [totalizer, limit] = bound_at->second;
    bounds_.erase(bound_at);
    if (limit + 1 < totalizers_[totalizer].size()) bound(totalizer, limit + 1);
  }
  sat_.add(broken);
  if (broken.size() == 1) return;
  totalizers_.emplace_back(broken);
  bound(totalizers_.size() - 1, 1);
}

void CoreGuided::bound(std::size_t totalizer, std::size_t limit) {
  const Literal soft = -totalizers_[totalizer].more_than(limit, sat_);
  bounds_.emplace(soft, Bound{totalizer, limit});
  waiting_.push_back(soft);
}

void CoreGuided::commit() {
  CHECK(waiting_.empty() && "committed after minimising");
  for (const Literal soft : active_) sat_.add({soft});
  active_.clear();
}

}  // namespace rmpl::runtime
