// Forward sums and maxima, backward best first, group by group; then the product of the groups.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/marking_window.hpp"

#include <algorithm>
#include <queue>
#include <utility>

#include "base/check.hpp"
#include "runtime/reasoning/estimate/best_tuples.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/marking_parts.hpp"
#include "runtime/reasoning/estimate/order.hpp"

namespace rmpl::runtime {
namespace {

using automata::Marking;
using automata::MarkingStep;

constexpr std::size_t most_in_layer = std::size_t{1} << 14;

}  // namespace

MarkingWindow::MarkingWindow(const MarkingGroups& groups, std::size_t updates, std::size_t k)
    : groups_(groups), updates_(updates), k_(k), trellis_(groups.size()) {
  for (std::size_t g = 0; g < groups.size(); ++g) steps_.emplace_back(groups[g].program, most_in_layer);
}

void MarkingWindow::start(std::vector<GroupBelief> belief) {
  told_.clear();
  from_.clear();
  from_.push_back(std::move(belief));
}

void MarkingWindow::update(std::vector<automata::Command> commands, std::vector<automata::Observation> observations,
                           std::vector<GroupBelief> belief) {
  CHECK(!from_.empty());
  told_.push_back({std::move(commands), std::move(observations)});
  from_.push_back(std::move(belief));
  if (told_.size() <= updates_) return;
  told_.pop_front();
  from_.pop_front();
}

MarkingWindow::Layer MarkingWindow::first(std::size_t group) {
  steps_[group].forget_but({});
  Layer layer;
  for (const auto& [marking, probability] : from_.front()[group]) {
    layer.markings.push_back(steps_[group].number(marking));
    layer.sum.push_back(probability);
    layer.best.push_back(probability);
  }
  layer.into.resize(layer.markings.size());
  return layer;
}

/// The layer after the last one; false where nothing leads there.
bool MarkingWindow::extend(std::size_t group, const Told& told, Reading reading, Layer& next) {
  MarkingStep& step = steps_[group];
  step.command(told.commands[group]);
  step.observe(told.observations[group]);
  const Layer& last = trellis_[group].back();
  next = {};
  std::vector<std::pair<Number, Edge>> edges;
  double total = 0;
  for (std::uint32_t from = 0; from < last.markings.size(); ++from) {
    const MarkingStep::Ways& ways = step.ways(last.markings[from]);
    if (!ways) throw TooManyStates("a marking may go on in more ways than a window can follow; expected no --window");
    for (const auto& way : *ways) {
      const double p = reading == Reading::seen ? way.probability * step.factor(way.target) : way.probability;
      if (p > 0) edges.push_back({way.target, {from, p}});
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [target, edge] : edges) {
    if (next.markings.empty() || next.markings.back() != target) {
      next.markings.push_back(target);
      next.into.emplace_back();
      next.sum.push_back(0);
      next.best.push_back(0);
    }
    next.into.back().push_back(edge);
    const double p = last.sum[edge.from] * edge.probability;
    next.sum.back() += p;
    next.best.back() = std::max(next.best.back(), last.best[edge.from] * edge.probability);
    total += p;
  }
  if (next.markings.size() > most_in_layer) {
    throw TooManyStates("a window of one group of threads has more than " + std::to_string(most_in_layer) +
                        " markings at one time; expected no --window");
  }
  if (!(total > 0)) return false;
  for (std::size_t i = 0; i < next.markings.size(); ++i) {
    next.sum[i] /= total;
    next.best[i] /= total;
    for (Edge& edge : next.into[i]) edge.probability /= total;
  }
  return true;
}

/// No step is possible: everything stays as it was.
void MarkingWindow::stand(std::size_t group, Layer& next) {
  next = trellis_[group].back();
  for (std::uint32_t i = 0; i < next.markings.size(); ++i) next.into[i] = {{i, 1.0}};
}

/// The best ways through a group's trellis, best first, from the end: what leads to a marking at its best is known.
std::vector<MarkingWindow::Path> MarkingWindow::paths(std::size_t group) {
  const Trellis& trellis = trellis_[group];
  struct Suffix {
    double bound;                       ///< of all that ends so
    double probability;                 ///< of what is behind `places`' first
    std::vector<std::uint32_t> places;  ///< from the last layer backwards
    bool operator<(const Suffix& other) const { return bound < other.bound; }
  };
  std::priority_queue<Suffix> open;
  for (std::uint32_t i = 0; i < trellis.back().markings.size(); ++i) open.push({trellis.back().best[i], 1, {i}});
  std::vector<Path> result;
  // Ties with the k-th are told apart by the caller; of very many, the first that come.
  while (!open.empty() && result.size() < 2 * k_ + 64) {
    Suffix suffix = open.top();
    open.pop();
    if (result.size() >= k_ && suffix.bound < result[k_ - 1].probability * (1 - tie_tolerance)) break;
    if (suffix.places.size() == trellis.size()) {
      Path& path = result.emplace_back(Path{suffix.bound, {}});
      for (std::size_t t = 0; t < trellis.size(); ++t) {
        path.markings.push_back(trellis[t].markings[suffix.places[trellis.size() - 1 - t]]);
      }
      continue;
    }
    const std::size_t layer = trellis.size() - suffix.places.size();
    for (const Edge& edge : trellis[layer].into[suffix.places.back()]) {
      Suffix longer{0, suffix.probability * edge.probability, suffix.places};
      longer.bound = longer.probability * trellis[layer - 1].best[edge.from];
      longer.places.push_back(edge.from);
      if (longer.bound > 0) open.push(std::move(longer));
    }
  }
  return result;
}

std::vector<MarkingTrajectory> MarkingWindow::trajectories() {
  const std::size_t size = groups_.size();
  for (std::size_t g = 0; g < size; ++g) trellis_[g] = {first(g)};
  for (const Told& told : told_) {
    std::vector<Layer> next(size);
    const auto extended = [&](Reading reading) {
      bool all = true;
      for (std::size_t g = 0; g < size; ++g) all = extend(g, told, reading, next[g]) && all;
      return all;
    };
    const bool goes_on = extended(Reading::seen) || extended(Reading::unseen);
    for (std::size_t g = 0; g < size; ++g) {
      if (!goes_on) stand(g, next[g]);
      trellis_[g].push_back(std::move(next[g]));
    }
  }
  std::vector<std::vector<Path>> paths;
  std::vector<Probabilities> lists;
  for (std::size_t g = 0; g < size; ++g) {
    Probabilities& list = lists.emplace_back();
    for (const Path& path : paths.emplace_back(this->paths(g))) list.push_back(path.probability);
  }
  std::vector<MarkingTrajectory> result;
  std::vector<const Marking*> parts(size);
  for (const Tuple& tuple : best_tuples(lists, k_)) {
    MarkingTrajectory& trajectory = result.emplace_back(MarkingTrajectory{tuple.probability, {}});
    for (std::size_t t = 0; t <= told_.size(); ++t) {
      for (std::size_t g = 0; g < size; ++g) parts[g] = &steps_[g].whole(paths[g][tuple.places[g]].markings[t]);
      trajectory.markings.push_back(joined(groups_, parts));
    }
  }
  put_in_order(result, [](const MarkingTrajectory& a, const MarkingTrajectory& b) { return a.markings < b.markings; });
  if (result.size() > k_) result.resize(k_);
  return result;
}

}  // namespace rmpl::runtime
