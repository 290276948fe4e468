// What follows symbolic states of the loop, remembered from one search to the next.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "verifier/search/system.hpp"

namespace rmpl::verifier {

/// Several questions about one program explore the same states: each row of a table of faults has the way to its fault
/// in common with all others, and what comes after it with its own other questions. What a move leads to depends on
/// the state alone, so long as searches watch the same clocks and leave the same faults; which moves are looked at is
/// up to each search. A search that is answered from here meets the same states in the same order as one that works
/// everything out: verdicts, witnesses and the number of states do not depend on it.
///
/// Bounded: what does not fit any more is worked out each time.
class StepMemory {
 public:
  /// What all memories of one loop may take together.
  class Room {
   public:
    [[nodiscard]] bool is_left() const { return words_ < most_words; }
    void take(std::size_t words) { words_ += words; }

   private:
    static constexpr std::size_t most_words = std::size_t{1} << 23;  ///< 64 MiB
    std::size_t words_ = 0;
  };
  /// Keeps a reference.
  explicit StepMemory(Room& room) : room_(room) {}

  struct Step {
    SymbolicState state;
    Label label;
  };
  /// What one move leads to.
  struct Move {
    bool known = false;
    std::vector<Step> steps;
  };
  /// What follows a state.
  struct Entry {
    std::vector<Move> moves;  ///< by move; as long as a search found it
    Move end;                 ///< what cuts a run off there
  };

  /// An entry for the state, perhaps an empty one. Null where there is none and no room, or where caches are off.
  Entry* find(const SymbolicState& state);
  /// Notes what a step in an entry takes.
  void count(const Step& step);

 private:
  struct Key {
    std::uint64_t discrete;
    unsigned faults;
    std::vector<Units> zone;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const noexcept;
  };

  std::unordered_map<Key, Entry, KeyHash> entries_;  ///< looked up, never iterated
  Room& room_;
};

}  // namespace rmpl::verifier
