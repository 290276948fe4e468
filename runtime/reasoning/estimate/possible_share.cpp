// Shares of possible outcomes, cluster by cluster.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/possible_share.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "automata/store/totality.hpp"
#include "base/partition.hpp"

namespace rmpl::runtime {

using automata::Modes;

namespace {

/// Beyond so many remembered sets of moves all are forgotten.
constexpr std::size_t memory_limit = 1u << 14;

constexpr std::size_t outcomes_between_looks = 256;

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
  auto known = excluded_.find(key_);
  if (known == excluded_.end()) {
    if (excluded_.size() >= memory_limit) excluded_.clear();
    Excluded found = excluded(cluster, from, moves);
    known = excluded_.emplace(key_, std::move(found)).first;
  }
  double lost = 0;
  double all = 1;
  for (const std::size_t c : cluster) {
    double sum = 0;
    for (const automata::Move& move : moves(c)) sum += move.probability;
    all *= sum;
  }
  // What is possible is summed where little is: a difference would have no digits left.
  const Excluded& places = known->second;
  if (places.size() / cluster.size() == outcomes) return {0};
  for (std::size_t i = 0; i < places.size(); i += cluster.size()) {
    if (i / cluster.size() % outcomes_between_looks == 0) go_on_();
    double product = 1;
    for (std::size_t j = 0; j < cluster.size(); ++j) product *= moves(cluster[j])[places[i + j]].probability;
    lost += product;
  }
  constexpr double little = 0.5;
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

/// The other components stay where they are, which is possible: only islands of the cluster may exclude anything.
PossibleShare::Excluded PossibleShare::excluded(const Cluster& cluster, const Modes& from, MovesOf moves) {
  Excluded result;
  Modes modes = from;
  std::vector<std::uint32_t> place(cluster.size(), 0);
  for (std::size_t seen = 1;; ++seen) {
    if (seen % outcomes_between_looks == 0) go_on_();
    for (std::size_t j = 0; j < cluster.size(); ++j) modes[cluster[j]] = moves(cluster[j])[place[j]].mode;
    if (!step_.possible(modes)) result.insert(result.end(), place.begin(), place.end());
    std::size_t j = cluster.size();
    while (j > 0 && ++place[j - 1] == moves(cluster[j - 1]).size()) place[--j] = 0;
    if (j == 0) return result;
  }
}

}  // namespace rmpl::runtime
