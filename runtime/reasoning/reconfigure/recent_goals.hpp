// The goals asked of late, each with what is remembered of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <list>

#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/goal.hpp"

namespace rmpl::runtime {

/// A program asserts few goals, again and again; beyond `limit` of them the one asked least recently is forgotten, and
/// so is its memory. Keeps a reference.
template <class Memory>
class RecentGoals {
 public:
  struct Entry {
    Goal goal;
    Memory memory;
  };
  static constexpr std::size_t limit = 64;

  explicit RecentGoals(automata::PlantStep& step) : step_(step) {}

  /// Lasts until another goal is asked for.
  Entry& find(const automata::Formula& goal) {
    const auto known =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.goal.formula() == goal; });
    if (known != entries_.end()) {
      entries_.splice(entries_.begin(), entries_, known);
    } else {
      entries_.push_front({Goal(goal, step_.plant(), step_.theory()), {}});
      if (entries_.size() > limit) entries_.pop_back();
    }
    return entries_.front();
  }

 private:
  automata::PlantStep& step_;
  std::list<Entry> entries_;  ///< the last asked first
};

}  // namespace rmpl::runtime
