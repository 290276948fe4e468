// The states that a search has found: packed, and asked whether they cover a new one.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "verifier/search/bounding_forest.hpp"
#include "verifier/search/system.hpp"

namespace rmpl::verifier {

/// One state on the way to an accepted one, with the label that led to it.
struct PathState {
  std::uint64_t discrete;
  Label label;
};

/// Discrete parts that follow each other on the way to an accepted state; initial ones follow `before_all`.
using Corridor = std::set<std::pair<std::uint64_t, std::uint64_t>>;
inline constexpr std::uint64_t before_all = UINT64_MAX;

/// Numbered states with how each came about.
class Passed {
 public:
  static constexpr std::uint32_t none = UINT32_MAX;

  /// What an entry of a zone takes: two bytes, or four or eight where a bound does not fit.
  enum class Width : std::uint8_t { two, four, eight };

  struct Node {
    std::uint64_t discrete;
    std::uint64_t zone;  ///< where its matrix begins
    Label label;
    std::uint32_t parent;
    std::uint32_t steps;
    std::uint32_t faults;
    std::uint32_t next;  ///< another node of the same discrete part
    std::uint16_t dimension;
    Width width;
    bool covered = false;   ///< by a later one
    bool explored = false;  ///< its successors have been asked for, or are about to be
    bool merged = false;    ///< its zone is one of several nodes with this discrete part together
    bool indexed = false;   ///< of the first node of a discrete part: there are so many that a forest holds them
  };

  /// Where steps are counted, a state with more steps does not cover one with fewer.
  Passed(TransitionSystem& system, bool steps_counted);

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
  [[nodiscard]] SymbolicState state(std::uint32_t node) const;
  /// The number of the state, added unless one that was found before covers it: same discrete part, no more faults
  /// and steps, and a zone that covers its zone. The nodes that it covers are marked so.
  std::uint32_t add(const SymbolicState& state, const Label& label, std::uint32_t parent, std::uint32_t steps);
  /// The node is about to be explored: it, or one in its place whose zone also holds those of other nodes with the same
  /// discrete part and as many faults that are not explored yet, where all that it holds is in nodes found so far. None
  /// where such a one is covered.
  std::uint32_t grown(std::uint32_t node);
  /// How the node came about, from an initial state on.
  [[nodiscard]] std::vector<PathState> path(std::uint32_t node) const;
  /// The ways by which the node may have come about, whatever was merged.
  [[nodiscard]] Corridor corridor(std::uint32_t node) const;

 private:
  template <class Entry>
  class Arena {
   public:
    std::uint64_t add(std::span<const Units> matrix);
    [[nodiscard]] const Entry* at(std::uint64_t position) const { return &chunks_[position / chunk][position % chunk]; }

   private:
    static constexpr std::uint64_t chunk = 1u << 18;
    std::vector<std::unique_ptr<Entry[]>> chunks_;
    std::uint64_t used_ = chunk;  ///< of the last one
  };

  /// Adds a matrix; where it begins, and what its entries take.
  std::pair<std::uint64_t, Width> add(std::span<const Units> matrix);
  /// What `use` makes of the first entry of the node's matrix; an entry's greatest value stands for no bound.
  template <class Use>
  auto with_matrix(const Node& node, const Use& use) const;
  [[nodiscard]] bool covered_by(const Node& node, const SymbolicState& state, std::uint32_t steps) const;
  [[nodiscard]] bool covers(const SymbolicState& state, const Node& node) const;
  std::uint32_t& first(std::uint64_t discrete);
  /// Marks the nodes of a list that the state covers, and takes them out of it; its first node stays, which the slot is
  /// found by. How many it looks at.
  std::size_t mark_covered(std::uint32_t head, const SymbolicState& state);
  /// The same by the discrete part's forest, for lists that are long. Covered nodes stay in the list.
  [[nodiscard]] bool forest_covers(const BoundingForest& forest, const SymbolicState& state, std::uint32_t steps) const;
  void mark_covered(const BoundingForest& forest, const SymbolicState& state);
  /// What a forest knows of a node: its zone, its faults, and its steps where these count. What covers a node is no
  /// less in any entry. False where the node is covered.
  bool row_of(std::uint32_t node, std::span<Units> row) const;
  void index(std::uint64_t discrete, std::uint32_t head);

  TransitionSystem& system_;
  bool steps_counted_;
  std::vector<Node> nodes_;
  Arena<std::int16_t> twos_;
  Arena<std::int32_t> fours_;
  Arena<Units> eights_;
  std::vector<std::uint32_t> slots_;  ///< the first node of a discrete part, by open addressing
  std::size_t discretes_ = 0;
  std::vector<ClockLimits> limits_;                            ///< of the state at hand
  std::unordered_map<std::uint64_t, BoundingForest> forests_;  ///< by discrete part
};

}  // namespace rmpl::verifier
