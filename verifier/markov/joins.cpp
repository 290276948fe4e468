// Where components are joined.
// SPDX-License-Identifier: MIT
#include "verifier/markov/joins.hpp"

namespace rmpl::verifier {

Joins::Spot Joins::spot(const ListNumbers::List& list) {
  const Spot result = numbers_.number(list);
  if (result == barred_.size()) {
    barred_.push_back(false);
    before_.emplace_back();
  }
  return result;
}

bool Joins::learn() {
  if (failed_.empty()) return false;
  std::vector<bool> seen(barred_.size(), false);
  while (!failed_.empty()) {
    const Spot spot = failed_.back();
    failed_.pop_back();
    if (seen[spot]) continue;
    seen[spot] = true;
    barred_[spot] = true;
    failed_.insert(failed_.end(), before_[spot].begin(), before_[spot].end());
  }
  return true;
}

}  // namespace rmpl::verifier
