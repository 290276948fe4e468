// Shares of possible outcomes, cluster by cluster.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/possible_share.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "automata/store/totality.hpp"
#include "base/partition.hpp"

namespace rmpl::runtime {

using automata::Modes;

namespace {

/// Beyond so many remembered sets of moves all are forgotten.
constexpr std::size_t memory_limit = 1u << 14;

constexpr std::size_t outcomes_between_looks = 256;

/// Up to so many outcomes all are looked at.
constexpr std::size_t few_outcomes = 256;
/// Of all outcomes, the share that may be passed over.
constexpr double too_little = 0x1p-53;

/// Probabilities in steps of a sixteenth of a power of two, rounded up: what is passed over depends on these alone.
constexpr double steps_of_two = 16;
std::int64_t step_of(double probability) {
  return static_cast<std::int64_t>(std::ceil(std::log2(probability) * steps_of_two));
}
double weight_of_step(std::int64_t step) { return std::exp2(static_cast<double>(step) / steps_of_two); }

}  // namespace

PossibleShare::PossibleShare(automata::PlantStep& step, std::size_t most, std::function<void()> go_on)
    : step_(step), most_(most), go_on_(std::move(go_on)), excluding_(step.plant().components.size(), false) {
  base::Partition together(excluding_.size());
  for (const automata::Island& island : step.locality().islands()) {
    if (island.support.components.empty() || automata::is_total(step.plant(), island)) continue;
    for (const automata::ComponentId c : island.support.components) {
      excluding_[c.index()] = true;
      together.join(island.support.components.front().index(), c.index());
    }
  }
  std::map<std::size_t, Cluster> clusters;
  for (std::size_t c = 0; c < excluding_.size(); ++c) {
    if (excluding_[c]) clusters[together.root(c)].push_back(c);
  }
  cluster_of_.resize(excluding_.size());
  for (auto& [root, cluster] : clusters) {
    for (const std::size_t c : cluster) cluster_of_[c] = clusters_.size();
    all_.push_back(clusters_.size());
    clusters_.push_back(std::move(cluster));
  }
}

PossibleShare::Share PossibleShare::of(const Modes& from, MovesOf moves, const Clusters& clusters) {
  Share share;
  for (const std::size_t k : clusters) {
    const Share own = of_cluster(k, from, moves);
    share = {share.value * own.value, share.exact && own.exact};
    if (share.value == 0) break;
  }
  return share;
}

std::pair<PossibleShare::Clusters, PossibleShare::Clusters> PossibleShare::divide(
    std::span<const std::size_t> components) const {
  std::vector<bool> touched(clusters_.size(), false);
  for (const std::size_t c : components) {
    if (excluding_[c]) touched[cluster_of_[c]] = true;
  }
  std::pair<Clusters, Clusters> result;
  for (const std::size_t k : all_) (touched[k] ? result.first : result.second).push_back(k);
  return result;
}

PossibleShare::Share PossibleShare::of_cluster(std::size_t k, const Modes& from, MovesOf moves) {
  const Cluster& cluster = clusters_[k];
  std::size_t outcomes = 1;
  key_.assign(1, k);
  bool stays = true;
  for (const std::size_t c : cluster) {
    const auto own = moves(c);
    outcomes = own.size() > most_ / outcomes ? most_ + 1 : outcomes * own.size();
    if (outcomes > most_) return {of_likeliest(cluster, from, moves), false};
    stays = stays && own.size() == 1 && own.front().mode == from[c];
    key_.push_back(own.size());
    for (const automata::Move& move : own) key_.push_back(move.mode.value);
  }
  if (stays) return {};  // `from` is possible
  double all = 1;
  for (const std::size_t c : cluster) {
    double sum = 0;
    for (const automata::Move& move : moves(c)) sum += move.probability;
    all *= sum;
  }
  const auto lost_with = [&](const Excluded& places) {
    double lost = 0;
    for (std::size_t i = 0; i < places.size(); i += cluster.size()) {
      if (i / cluster.size() % outcomes_between_looks == 0) go_on_();
      double product = 1;
      for (std::size_t j = 0; j < cluster.size(); ++j) product *= moves(cluster[j])[places[i + j]].probability;
      lost += product;
    }
    return lost;
  };
  constexpr double little = 0.5;
  if (outcomes > few_outcomes) {
    const std::size_t without_weights = key_.size();
    const Weights weights = weigh(cluster, moves, outcomes);
    const double lost = lost_with(excluded(cluster, from, moves, weights));
    if (lost <= little * all) return {all - lost};
    key_.resize(without_weights);
  }
  // What is possible is summed where little is: a difference would have no digits left.
  const Excluded& places = excluded(cluster, from, moves, {});
  if (places.size() / cluster.size() == outcomes) return {0};
  const double lost = lost_with(places);
  if (lost <= little * all) return {all - lost};
  double kept = 0;
  std::vector<std::uint32_t> place(cluster.size(), 0);
  std::size_t next = 0;  // of the excluded combinations, which come in the same order
  for (std::size_t seen = 1;; ++seen) {
    if (seen % outcomes_between_looks == 0) go_on_();
    const bool excluded_here = next < places.size() && std::equal(place.begin(), place.end(),
                                                                  places.begin() + static_cast<std::ptrdiff_t>(next));
    if (excluded_here) {
      next += cluster.size();
    } else {
      double product = 1;
      for (std::size_t j = 0; j < cluster.size(); ++j) product *= moves(cluster[j])[place[j]].probability;
      kept += product;
    }
    std::size_t j = cluster.size();
    while (j > 0 && ++place[j - 1] == moves(cluster[j - 1]).size()) place[--j] = 0;
    if (j == 0) return {kept};
  }
}

/// What is the probability of the likeliest outcome, where that is possible.
double PossibleShare::of_likeliest(const Cluster& cluster, const Modes& from, MovesOf moves) {
  Modes modes = from;
  double probability = 1;
  for (const std::size_t c : cluster) {
    const auto own = moves(c);
    const auto best = std::max_element(own.begin(), own.end(), [](const automata::Move& a, const automata::Move& b) {
      return a.probability < b.probability;
    });
    modes[c] = best->mode;
    probability *= best->probability;
  }
  return step_.possible(modes) ? probability : 0;
}

/// Adds the steps that they depend on to the key.
PossibleShare::Weights PossibleShare::weigh(const Cluster& cluster, MovesOf moves, std::size_t outcomes) {
  Weights result;
  result.floor = too_little / static_cast<double>(outcomes);
  for (const std::size_t c : cluster) {
    auto& own = result.of.emplace_back();
    double least = 0;
    for (const automata::Move& move : moves(c)) {
      const std::int64_t step = step_of(move.probability);
      key_.push_back(static_cast<std::uint64_t>(step));
      own.push_back(weight_of_step(step));
      least += weight_of_step(step - 1);
    }
    result.floor *= least;
  }
  return result;
}

struct PossibleShare::Pass {
  const Cluster& cluster;
  MovesOf moves;
  const Weights& weights;
  std::vector<double> behind;  ///< by member: what those from there on weigh at most
  Modes modes;
  std::vector<std::uint32_t> place;
  std::size_t seen = 0;
  Excluded result = {};
};

/// Of the combinations of a cluster, in order, those that are excluded, without what is passed over. The other
/// components stay where they are, which is possible: only islands of the cluster may exclude anything. Remembered by
/// the key.
const PossibleShare::Excluded& PossibleShare::excluded(const Cluster& cluster, const Modes& from, MovesOf moves,
                                                       const Weights& weights) {
  const auto known = excluded_.find(key_);
  if (known != excluded_.end()) return known->second;
  if (excluded_.size() >= memory_limit) excluded_.clear();
  Pass pass{cluster, moves, weights, {}, from, std::vector<std::uint32_t>(cluster.size())};
  if (!weights.of.empty()) pass.behind.assign(cluster.size() + 1, 1);
  for (std::size_t j = weights.of.size(); j-- > 0;)
    pass.behind[j] = pass.behind[j + 1] * std::accumulate(weights.of[j].begin(), weights.of[j].end(), 0.0);
  exclude(pass, 0, 1);
  return excluded_.emplace(key_, std::move(pass.result)).first->second;
}

void PossibleShare::exclude(Pass& pass, std::size_t member, double weight) {
  const auto& weights = pass.weights.of;
  if (!weights.empty() && weight * pass.behind[member] < pass.weights.floor) return;
  if (member == pass.cluster.size()) {
    if (++pass.seen % outcomes_between_looks == 0) go_on_();
    if (!step_.possible(pass.modes)) pass.result.insert(pass.result.end(), pass.place.begin(), pass.place.end());
    return;
  }
  const auto own = pass.moves(pass.cluster[member]);
  for (std::uint32_t m = 0; m < own.size(); ++m) {
    pass.place[member] = m;
    pass.modes[pass.cluster[member]] = own[m].mode;
    exclude(pass, member + 1, weights.empty() ? weight : weight * weights[member][m]);
  }
}

}  // namespace rmpl::runtime
