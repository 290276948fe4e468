// What may happen at an instant in the closed loop: for the search for standstills.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "base/function_ref.hpp"
#include "verifier/closed_loop/loop.hpp"
#include "verifier/plant/instant_clocks.hpp"
#include "verifier/search/standstill.hpp"

namespace rmpl::verifier {

/// From one state on; nodes are numbers of states. Keeps references.
class LoopInstants : public Instants {
 public:
  /// `others` clocks come before those of the program in the zone. What leads to modes that `ends` holds for leads on;
  /// it is kept as long as this object is.
  LoopInstants(Loop& loop, LoopStateId root, std::size_t others, base::FunctionRef<bool(const automata::Modes&)> ends);

  const std::vector<ZoneBox>& waits(std::uint64_t node) override;
  const std::vector<Instant>& steps(std::uint64_t node) override;

 private:
  /// The clock of the root that a group of a node reads, by its position there; none: it has started since, and reads
  /// 0.
  [[nodiscard]] std::optional<std::size_t> group_clock(LoopStateId node, std::size_t group) const;
  /// Whether the outcome leads to a node whose groups read clocks of the root, or none; then `step` restarts those that
  /// start anew.
  bool comes_back(const Outcome& outcome, LoopStateId from, Instant& step);
  void add_step(const Outcome& outcome, std::uint32_t move, LoopStateId from, std::vector<Instant>& result);

  Loop& loop_;
  LoopStateId root_;
  std::size_t others_;
  base::FunctionRef<bool(const automata::Modes&)> ends_;
  InstantClocks clocks_;
  bool own_clocks_ = false;  ///< the program has some: what has started can be forgotten again
  /// By node, for each of its groups: 1 + the position at the root of the one that it is, or 0: it has started since.
  std::map<std::uint64_t, std::vector<std::size_t>> sources_;
  std::map<std::uint64_t, std::vector<ZoneBox>> waits_;
  std::map<std::uint64_t, std::vector<Instant>> steps_;
};

}  // namespace rmpl::verifier
