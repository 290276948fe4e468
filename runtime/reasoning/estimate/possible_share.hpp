// What of the outcomes of a state can happen: those that do not contradict the interconnections.
//
// What cannot happen next is dropped from the outcomes of each state, and the rest is scaled to 1, state by state
// (semantics 3). The share that is left is a product over clusters: components whose modes some island of the store can
// exclude together. Which combinations of modes a cluster excludes is remembered by where its components may go. Of
// many combinations those are passed over that together weigh less than a double can tell: several faults at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "base/function_ref.hpp"
#include "base/hash.hpp"

namespace rmpl::runtime {

class PossibleShare {
 public:
  static constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
  /// Keeps a reference. `most`: outcomes of one cluster that are looked at. `go_on` is called now and then meanwhile;
  /// what it throws ends the question.
  explicit PossibleShare(
      automata::PlantStep& step, std::size_t most = no_limit, std::function<void()> go_on = [] {});

  /// Where a component may go, in order of mode, each with a positive probability.
  using MovesOf = base::FunctionRef<std::span<const automata::Move>(std::size_t component)>;
  struct Share {
    double value = 1;
    bool exact = true;  ///< else it is more, perhaps: a cluster has too many outcomes, and the likeliest counts
  };
  /// The probability that the outcomes of possible modes `from` are possible together. 1 where nothing can be excluded.
  Share of(const automata::Modes& from, MovesOf moves) { return of(from, moves, all_); }
  /// The same of some clusters alone.
  using Clusters = std::vector<std::size_t>;  ///< positions, ascending
  Share of(const automata::Modes& from, MovesOf moves, const Clusters& clusters);
  /// Those that one of the components is part of, and all others.
  [[nodiscard]] std::pair<Clusters, Clusters> divide(std::span<const std::size_t> components) const;
  [[nodiscard]] const Clusters& all() const { return all_; }
  [[nodiscard]] bool has(std::size_t cluster, std::size_t component) const {
    return excluding_[component] && cluster_of_[component] == cluster;
  }
  /// By component: whether some modes of others may exclude a mode of it.
  [[nodiscard]] const std::vector<bool>& excluding() const { return excluding_; }

 private:
  using Cluster = std::vector<std::size_t>;  ///< components, ascending
  struct Pass;
  /// Combinations of modes that are excluded, one after the other, each as places in the moves of its components.
  using Excluded = std::vector<std::uint32_t>;

  Share of_cluster(std::size_t cluster, const automata::Modes& from, MovesOf moves);
  double of_likeliest(const Cluster& cluster, const automata::Modes& from, MovesOf moves);
  /// What combinations weigh at most, and what is passed over.
  struct Weights {
    double floor = 0;                     ///< what weighs less is not looked at
    std::vector<std::vector<double>> of;  ///< by member of the cluster, by place in its moves; empty: all are looked at
  };
  Weights weigh(const Cluster& cluster, MovesOf moves, std::size_t outcomes);
  const Excluded& excluded(const Cluster& cluster, const automata::Modes& from, MovesOf moves, const Weights& weights);
  void exclude(Pass& pass, std::size_t member, double weight);

  automata::PlantStep& step_;
  std::size_t most_;
  std::function<void()> go_on_;
  std::vector<bool> excluding_;
  std::vector<Cluster> clusters_;
  Clusters all_;
  std::vector<std::size_t> cluster_of_;  ///< by component that is part of one
  std::unordered_map<std::vector<std::uint64_t>, Excluded, base::WordsHash> excluded_;  ///< looked up, never iterated
  std::vector<std::uint64_t> key_;
};

}  // namespace rmpl::runtime
