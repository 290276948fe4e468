// OLL: cores, totalizers, and the bound made permanent.
// SPDX-License-Identifier: MIT
#include "runtime/diagnose/core_guided.hpp"

#include <algorithm>
#include <cassert>

namespace runtime {

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
    assert(!possible && "a core is inconsistent");
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
    const auto bound = bounds_.find(soft);
    if (bound == bounds_.end()) continue;
    const auto [totalizer, limit] = bound->second;
    bounds_.erase(bound);
    if (limit < totalizers_[totalizer].size()) {
      const Literal next = -totalizers_[totalizer][limit];
      bounds_.emplace(next, Bound{totalizer, limit + 1});
      waiting_.push_back(next);
    }
  }
  sat_.add(broken);
  if (broken.size() == 1) return;
  totalizers_.push_back(totalize(broken));
  const Literal second = -totalizers_.back()[1];
  bounds_.emplace(second, Bound{totalizers_.size() - 1, 2});
  waiting_.push_back(second);
}

// Only "inputs imply outputs" is needed: an output may hold without cause, but then it breaks a soft literal for
// nothing.
std::vector<Literal> CoreGuided::totalize(std::span<const Literal> inputs) {
  if (inputs.size() == 1) return {inputs[0]};
  const std::vector<Literal> left = totalize(inputs.first(inputs.size() / 2));
  const std::vector<Literal> right = totalize(inputs.subspan(inputs.size() / 2));
  std::vector<Literal> outputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) outputs.push_back(sat_.fresh());
  for (std::size_t l = 0; l <= left.size(); ++l) {
    for (std::size_t r = 0; r <= right.size(); ++r) {
      if (l + r == 0) continue;
      std::vector<Literal> clause{outputs[l + r - 1]};
      if (l > 0) clause.push_back(-left[l - 1]);
      if (r > 0) clause.push_back(-right[r - 1]);
      sat_.add(clause);
    }
  }
  return outputs;
}

void CoreGuided::commit() {
  assert(waiting_.empty() && "committed after minimising");
  for (const Literal soft : active_) sat_.add({soft});
  active_.clear();
}

}  // namespace runtime
