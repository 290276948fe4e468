// Policies: for each component, what to do next in each mode to get to each other mode (thesis Table 6.2).
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/reasoning/nominal/nominal_graph.hpp"

namespace rmpl::runtime {

/// How long a way is. Steps that cannot be undone weigh more than any number of others (6.3.2).
struct Distance {
  std::uint32_t irreversible = 0;
  std::uint32_t steps = 0;
  auto operator<=>(const Distance&) const = default;
};
constexpr Distance operator+(Distance a, Distance b) { return {a.irreversible + b.irreversible, a.steps + b.steps}; }

/// The policy of one component, where certain irreversible steps are permitted: per current and target
/// mode the first transition of a shortest way, ties in declaration order; of several to the same mode
/// one that takes no time.
class Policy {
 public:
  Policy(const std::vector<NominalTransition>& transitions, std::size_t modes, const std::vector<bool>& permitted);

  /// The transition to take; null in the target mode itself and where no way leads there.
  [[nodiscard]] const NominalTransition* next(automata::ModeId current, automata::ModeId target) const {
    return cell(current, target).next;
  }
  /// Nothing where no way leads there; zero in the target mode itself.
  [[nodiscard]] const std::optional<Distance>& distance(automata::ModeId current, automata::ModeId target) const {
    return cell(current, target).distance;
  }

 private:
  struct Cell {
    const NominalTransition* next = nullptr;
    std::optional<Distance> distance;
  };
  [[nodiscard]] const Cell& cell(automata::ModeId current, automata::ModeId target) const {
    return cells_[target.index() * modes_ + current.index()];
  }

  std::size_t modes_;
  std::vector<Cell> cells_;
};

/// One entry of a policy table.
struct PolicyEntry {
  enum class Kind {
    arrived,  ///< current and target are the same: stay idle
    wait,     ///< idle, the modes of one of `preconditions` achieved: then it is a matter of time, or happens of itself
    command,  ///< achieve one of `preconditions`, its modes before its control values
    failure   ///< no nominal way leads there
  };
  Kind kind = Kind::failure;
  automata::TransitionId transition;        ///< with `wait` and `command`
  bool irreversible = false;                ///< with `wait` and `command`: nothing leads back
  std::vector<Precondition> preconditions;  ///< with `wait` and `command`
};

/// Table 6.2 for any component: `entries[current][target]`, over all modes, every irreversible step permitted: each
/// target is one that a goal may name.
struct PolicyTable {
  std::vector<std::vector<PolicyEntry>> entries;
};
PolicyTable policy_table(const automata::Plant& plant, const NominalGraph& graph, automata::ComponentId component);
PolicyTable policy_table(const automata::Plant& plant, automata::ComponentId component);

}  // namespace rmpl::runtime
