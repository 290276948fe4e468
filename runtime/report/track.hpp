// What a thing was over time: its changes.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "automata/time/time.hpp"

namespace rmpl::runtime {

template <class Value>
struct Change {
  automata::Ticks time;
  Value value;
};

/// Each value lasts to the next change, the last one to the end. Before the first change nothing is known.
template <class Value>
class Track {
 public:
  /// `time` is not before that of an earlier call. Of several values at one time the last one counts.
  void set(automata::Ticks time, Value value) {
    if (!changes_.empty() && changes_.back().value == value) return;
    if (!changes_.empty() && changes_.back().time == time) {
      changes_.pop_back();
      if (!changes_.empty() && changes_.back().value == value) return;
    }
    changes_.push_back({time, std::move(value)});
  }
  [[nodiscard]] const std::vector<Change<Value>>& changes() const { return changes_; }
  [[nodiscard]] bool empty() const { return changes_.empty(); }

 private:
  std::vector<Change<Value>> changes_;
};

}  // namespace rmpl::runtime
