// What may happen at an instant in the closed loop: for the search for standstills.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "base/function_ref.hpp"
#include "verifier/closed_loop/loop.hpp"
#include "verifier/plant/instant_clocks.hpp"
#include "verifier/search/standstill.hpp"

namespace rmpl::verifier {

/// From one state on, node 0. A node is a state with what its program clocks are: some that the root has, or started
/// since, so that they read 0. What is due moves in the next cycle. Steps that exist only at one instant do not count
/// (semantics 7, "an instant saves no run"). Keeps references.
class LoopInstants : public Instants {
 public:
  /// `others` clocks come before those of the program in the zone. What leads to states that `ends` holds for leads on;
  /// it is kept as long as this object is.
  LoopInstants(Loop& loop, LoopStateId root, std::size_t others, base::FunctionRef<bool(const LoopState&)> ends);

  const std::vector<ZoneBox>& waits(std::uint64_t node) override;
  const Instant* step(std::uint64_t node, std::size_t number) override;
  [[nodiscard]] LoopStateId state_of(std::uint64_t node) const { return nodes_[node]->first; }

 private:
  const std::vector<Instant>& steps(std::uint64_t node);
  /// For each group of a state 1 + the position at the root of the one that it is, or 0: it has started since.
  using Sources = std::vector<std::size_t>;

  /// The clock of the root that a group of a node reads, by its position there; none: it has started since, and reads
  /// 0.
  [[nodiscard]] std::optional<std::size_t> group_clock(std::uint64_t node, std::size_t group) const;
  std::uint64_t number(LoopStateId state, Sources sources);
  /// The node that the outcome leads to; nothing where it cannot come back from there.
  std::optional<std::uint64_t> target(const Outcome& outcome, std::uint64_t from);
  void add_step(const Outcome& outcome, std::uint32_t move, std::uint64_t from, std::vector<Instant>& result);

  Loop& loop_;
  std::size_t others_;
  base::FunctionRef<bool(const LoopState&)> ends_;
  InstantClocks clocks_;
  bool at_bound_ = false;    ///< where time stops at the root, it does at a bound
  bool own_clocks_ = false;  ///< the program has some: what has started can be forgotten again
  std::map<std::pair<LoopStateId, Sources>, std::uint64_t> numbers_;
  std::vector<const std::pair<LoopStateId, Sources>*> nodes_;  ///< by number
  std::map<std::uint64_t, std::vector<ZoneBox>> waits_;
  std::map<std::uint64_t, std::vector<Instant>> steps_;
};

}  // namespace rmpl::verifier
