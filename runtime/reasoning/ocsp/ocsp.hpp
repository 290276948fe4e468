// Optimal constraint satisfaction by conflict-directed best-first search (thesis 6.2.3; livingstone Fig. 3; OpSat).
//
// An OCSP <x, f, C> has decision variables with finite domains, a cost for each value (the objective is their sum, so
// it is mutually preferentially independent), and a check that says of a full assignment that it satisfies C, or names
// a conflict: a part of it that cannot hold. Solutions come in nondecreasing cost.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace rmpl::runtime {

/// Decision variable `variable` takes `value`; both are positions in the table of costs.
struct Decision {
  std::uint32_t variable;
  std::uint32_t value;
  auto operator<=>(const Decision&) const = default;
};

/// Decisions that cannot hold together. An empty one says that nothing is possible.
using Conflict = std::vector<Decision>;

/// Conflicts that are known. Searches over the same variables and values may share one, whatever their costs.
class ConflictSet {
 public:
  /// Keeps a conflict, in order of variable; one that is there already is not kept twice.
  void add(Conflict conflict);
  [[nodiscard]] const std::vector<Conflict>& conflicts() const { return conflicts_; }

 private:
  std::vector<Conflict> conflicts_;
};

/// One search. Each node stands for a set of assignments, and these sets never overlap: the values below the node's are
/// excluded for some variables, others are fixed. A node's candidate takes the cheapest value that is left for each
/// variable. A node whose candidate holds a conflict is split on it: the i-th child keeps the first i - 1 decisions and
/// gives up the i-th; a solution is split likewise on all its decisions. Children come in order of cost, so a pop adds
/// at most two nodes to the queue: its next sibling and its first child. A candidate that holds a known conflict is
/// never checked, and a value that is a conflict by itself is no way out of another.
///
/// Each conflict is watched at its first decision that is not the cheapest of its variable: a candidate can hold it
/// only if that is among its deviations from the cheapest. A pop looks at the conflicts watched at the variables that
/// deviate, and at those that speak of cheapest values alone; its cost does not grow with the number of variables.
class OptimalSearch {
 public:
  /// `costs[x][v]`: what value v of variable x costs, at least 0; +infinity where x cannot take it.
  using Costs = std::vector<std::vector<double>>;
  using Units = std::int64_t;
  /// A value that a variable can take.
  struct PricedValue {
    std::uint32_t value;
    Units units;
    double cost;
  };
  /// What a variable can take: in order of cost in units of 2^exponent, then of declaration. Searches may share one.
  class Domain {
   public:
    static constexpr int finest = -40;
    explicit Domain(std::span<const double> costs, int exponent = finest);

    [[nodiscard]] std::span<const PricedValue> choices() const { return choices_; }
    [[nodiscard]] double greatest() const { return greatest_; }
    [[nodiscard]] int exponent() const { return exponent_; }

   private:
    std::vector<PricedValue> choices_;
    double greatest_ = 0;
    int exponent_;
  };
  /// Nothing when the candidate (a value per variable) is consistent; else a conflict, which must be a part of it.
  using Check = std::function<std::optional<Conflict>(std::span<const std::uint32_t> candidate)>;
  enum class Outcome {
    solution,   ///< `values` and `cost` tell it
    exhausted,  ///< there is no further solution
    budget      ///< the last check that it allows was made; `set_budget` and `next` go on from here
  };

  /// `conflicts` may be shared with other searches and is added to; without it the search has its own. Sums of costs
  /// are kept as integers, in units of 2^-40 (coarser where the total would not fit), so that equal sums are equal in
  /// whatever order they came about.
  explicit OptimalSearch(const Costs& costs, std::shared_ptr<ConflictSet> conflicts = nullptr);
  OptimalSearch(OptimalSearch&&) = default;
  OptimalSearch& operator=(OptimalSearch&&) = default;
  /// Begins anew with another problem, in the memory of the last. The domains must outlive the search.
  void restart(std::span<const Domain* const> domains, std::shared_ptr<ConflictSet> conflicts);

  /// The next solution in order of cost; among equal costs the one first in lexicographic order of variable, then
  /// value, as they are declared.
  Outcome next(const Check& check);
  /// The solution that `next` found last.
  [[nodiscard]] const std::vector<std::uint32_t>& values() const { return candidate_; }
  /// Its cost, summed in order of variable.
  [[nodiscard]] double cost() const;

  /// No solution to come costs less than this; +infinity when there is none.
  [[nodiscard]] double bound() const;
  /// How many candidates may still be checked; unlimited to begin with. With none, `next` still drops what holds a
  /// known conflict, and tells `exhausted` where that was all.
  void set_budget(std::size_t candidates) { budget_ = candidates; }
  /// How many candidates were checked.
  [[nodiscard]] std::size_t checked() const { return checked_; }

 private:
  /// One way out of a conflict: `variable` goes on to the choice at `rank`, at an additional cost.
  struct Alternative {
    std::uint32_t variable;
    std::uint32_t rank;
    Units delta;
  };
  /// A part of a pool.
  struct Slice {
    std::uint32_t begin = 0;
    std::uint32_t size = 0;
  };
  /// A variable that is not at its cheapest choice.
  struct Deviation {
    std::uint32_t variable;
    std::uint32_t rank;
  };
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  /// The child at `position` of the split `split`; the root has none.
  struct Node {
    Units cost;
    std::uint32_t split = none;
    std::uint32_t position = 0;
    Slice deviations;
  };
  /// A node that was split, with the ways out in order.
  struct Split {
    Node node;
    Slice alternatives;
    std::uint32_t in_order;  ///< so many of them are; of most splits few are ever wanted
  };

  [[nodiscard]] bool later(const Node& a, const Node& b) const;
  [[nodiscard]] std::uint32_t value(const Deviation& deviation) const;
  [[nodiscard]] std::uint32_t rank_in(const Node& node, std::uint32_t variable) const;
  const Alternative& alternative(std::uint32_t split, std::uint32_t position);
  void take_candidate(const Node& node);
  void watch_new_conflicts();
  [[nodiscard]] const Conflict* known_conflict(const Node& node);
  [[nodiscard]] bool excluded(const Decision& decision) const;
  void split(const Node& node, std::span<const Decision> conflict);
  void push(Node node);
  void push_child(std::uint32_t split, std::uint32_t position);

  std::vector<Domain> own_;  ///< where nobody else has them
  std::shared_ptr<ConflictSet> conflicts_;
  double unit_ = 0;
  std::vector<std::span<const PricedValue>> choices_;  ///< per variable
  std::vector<Node> queue_;                            ///< a heap
  std::vector<Split> splits_;
  std::vector<Alternative> alternatives_;  ///< pool
  std::vector<Deviation> deviations_;      ///< pool; of one node in order of variable
  std::vector<std::uint32_t> candidate_;   ///< of the node that is being looked at
  std::vector<std::uint32_t> rank_;        ///< likewise
  std::vector<std::uint32_t> deviating_;   ///< likewise, the variables whose rank is not 0
  std::vector<std::uint32_t> fixed_in_;    ///< per variable, the last split that it was fixed in
  std::uint32_t split_number_ = 0;
  std::vector<std::uint32_t> of_cheapest_;    ///< conflicts that speak of cheapest values alone, ascending
  std::vector<std::uint32_t> first_watched_;  ///< per variable, the last conflict that is watched there, or none
  std::vector<std::uint32_t> next_watched_;   ///< per conflict, the one before it that is watched at the same variable
  std::vector<Decision> decisions_;           ///< the candidate as decisions, to split a solution on
  std::size_t budget_ = std::numeric_limits<std::size_t>::max();
  std::size_t checked_ = 0;
};

}  // namespace rmpl::runtime
