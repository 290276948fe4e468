// What rounds with ever more faults settle of the minimal cut sets.
// SPDX-License-Identifier: MIT
#include "verifier/cut_set/cut_set_rounds.hpp"

#include <algorithm>

#include "verifier/cut_set/fault_sets.hpp"

namespace rmpl::verifier {

bool CutSetRounds::next(const std::vector<CutSet>& sets, unsigned used) {
  const bool none_needed = !sets.empty() && sets.front().faults.empty();
  if (faults_ == most_ || none_needed) return false;
  before_ = sets;
  before_faults_ = faults_;
  faults_ = used < faults_ ? most_ : faults_ + 1;
  return true;
}

/// Whether transitions lead back to the fault mode once it is left.
bool CutSetRounds::may_come_twice(const Fault& fault) const {
  const automata::Component& component = plant_[fault.component];
  std::vector<bool> reached(component.modes.size());
  for (bool more = true; more;) {
    more = false;
    for (const automata::Transition& t : component.transitions) {
      if (t.from == t.to || reached[t.to.index()]) continue;
      if (t.from != fault.mode && !reached[t.from.index()]) continue;
      reached[t.to.index()] = more = true;
    }
  }
  return reached[fault.mode.index()];
}

/// Where each fault comes but once a smaller set takes fewer faults than the set has: the round has looked for it.
bool CutSetRounds::is_settled(const CutSet& cut) const {
  return cut.faults.size() < 2 ||
         std::none_of(cut.faults.begin(), cut.faults.end(), [this](const Fault& f) { return may_come_twice(f); });
}

void CutSetRounds::settle(Answer& answer) const {
  std::vector<CutSet>& sets = answer.cut_sets;
  // In the last round minimal is minimal for good.
  if (faults_ < most_) std::erase_if(sets, [this](const CutSet& cut) { return !is_settled(cut); });
  answer.cut_sets_complete = before_faults_;
  FaultSetTree minimal;
  for (const CutSet& cut : sets) minimal.add(cut.faults);
  std::vector<const CutSet*> unsettled;
  for (const CutSet& cut : before_) {
    if (minimal.holds_subset_of(cut.faults)) continue;
    if (is_settled(cut)) {
      minimal.add(cut.faults);
      sets.push_back(cut);
    } else {
      unsettled.push_back(&cut);
    }
  }
  for (const CutSet* cut : unsettled) {
    if (minimal.holds_subset_of(cut->faults)) continue;
    answer.cut_sets_complete = std::min(*before_faults_, static_cast<unsigned>(cut->faults.size()) - 1);
    break;  // smallest first
  }
  std::sort(sets.begin(), sets.end(), told_before);
}

}  // namespace rmpl::verifier
