// What a thing was over time: its changes.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <iterator>
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
  /// What it is at a time; null before the first change. Logarithmic.
  [[nodiscard]] const Value* at(automata::Ticks time) const {
    const auto after = std::upper_bound(changes_.begin(), changes_.end(), time,
                                        [](automata::Ticks t, const Change<Value>& change) { return t < change.time; });
    return after == changes_.begin() ? nullptr : &std::prev(after)->value;
  }
  [[nodiscard]] bool empty() const { return changes_.empty(); }
  /// Keeps the last change only.
  void forget() {
    if (changes_.size() > 1) changes_.erase(changes_.begin(), std::prev(changes_.end()));
  }

 private:
  std::vector<Change<Value>> changes_;
};

/// When one of the tracks changes: ascending, each time once.
template <class Value>
std::vector<automata::Ticks> times_of(const std::vector<Track<Value>>& tracks) {
  std::vector<automata::Ticks> times;
  for (const auto& track : tracks) {
    for (const Change<Value>& change : track.changes()) times.push_back(change.time);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace rmpl::runtime
