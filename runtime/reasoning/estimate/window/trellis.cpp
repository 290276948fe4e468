// Forward sums and maxima, backward best first.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/window/trellis.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <string>

#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/order.hpp"

namespace rmpl::runtime {

void Trellis::begin(const std::vector<std::pair<Number, double>>& belief) {
  layers_.clear();
  edges_ = 0;
  Layer& layer = layers_.emplace_back();
  for (const auto& [state, probability] : belief) {
    layer.states.push_back(state);
    layer.sum.push_back(probability);
    layer.best.push_back(probability);
  }
  layer.ends.assign(belief.size(), 0);
}

std::vector<std::pair<Trellis::Number, double>> Trellis::forward(std::size_t layer) const {
  const Layer& own = layers_[layer];
  std::vector<std::pair<Number, double>> result;
  double total = 0;
  for (std::size_t i = 0; i < own.states.size(); ++i) total += own.sum[own.between() + i];
  for (std::size_t i = 0; i < own.states.size(); ++i) {
    result.emplace_back(own.states[i], own.sum[own.between() + i] / total);
  }
  return result;
}

/// The node whose edges were added last.
void Trellis::close(const Layer& last) {
  double sum = 0, best = 0;
  for (std::size_t e = next_.ends.empty() ? 0 : next_.ends.back(); e < next_.edges.size(); ++e) {
    const Edge& edge = next_.edges[e];
    const bool of_last = edge.from < last.states.size();
    const Layer& from = of_last ? last : next_;
    const std::size_t place = of_last ? last.between() + edge.from : edge.from - last.states.size();
    sum += from.sum[place] * edge.probability;
    best = std::max(best, from.best[place] * edge.probability);
  }
  next_.ends.push_back(next_.edges.size());
  next_.sum.push_back(sum);
  next_.best.push_back(best);
}

bool Trellis::extend(std::vector<Arrival> arrivals, const std::vector<std::vector<Edge>>& between) {
  const Layer& last = layers_.back();
  next_ = {};
  for (const std::vector<Edge>& into : between) {
    next_.edges.insert(next_.edges.end(), into.begin(), into.end());
    close(last);
  }
  std::stable_sort(arrivals.begin(), arrivals.end(),
                   [](const Arrival& a, const Arrival& b) { return a.target < b.target; });
  for (std::size_t a = 0; a < arrivals.size(); ++a) {
    next_.edges.push_back({arrivals[a].from, arrivals[a].probability});
    if (a + 1 < arrivals.size() && arrivals[a + 1].target == arrivals[a].target) continue;
    next_.states.push_back(arrivals[a].target);
    close(last);
  }
  if (next_.states.size() > most || edges_ + next_.edges.size() > most_edges) {
    throw TooManyStates("the window of one independent group has more than " + std::to_string(most) +
                        " states at one time, or more than " + std::to_string(most_edges) + " steps between states");
  }
  const std::size_t first = next_.between();
  double total = 0;
  for (std::size_t i = first; i < next_.sum.size(); ++i) total += next_.sum[i];
  if (!(total > 0)) return false;
  for (std::size_t i = first; i < next_.sum.size(); ++i) {
    next_.sum[i] /= total;
    next_.best[i] /= total;
  }
  for (std::size_t e = first == 0 ? 0 : next_.ends[first - 1]; e < next_.edges.size(); ++e) {
    next_.edges[e].probability /= total;
  }
  return true;
}

void Trellis::advance() {
  edges_ += next_.edges.size();
  layers_.push_back(std::move(next_));
}

void Trellis::stand() {
  const Layer& last = layers_.back();
  Layer same;
  same.states = last.states;
  for (std::uint32_t i = 0; i < same.states.size(); ++i) {
    same.edges.push_back({i, 1.0});
    same.ends.push_back(i + 1);
    same.sum.push_back(last.sum[last.between() + i]);
    same.best.push_back(last.best[last.between() + i]);
  }
  next_ = std::move(same);
  advance();
}

std::vector<Trellis::Path> Trellis::best(std::size_t k) const {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  /// What a way ends with, from a node on; `place` as in `Layer::sum`.
  struct Suffix {
    double probability;  ///< of what is behind the node
    std::uint32_t layer, place, behind;
  };
  struct Open {
    double bound;  ///< of all that ends so
    std::uint32_t suffix;
    bool operator<(const Open& other) const { return bound < other.bound; }
  };
  std::vector<Suffix> suffixes;
  std::priority_queue<Open> open;
  const auto push = [&](const Suffix& suffix) {
    const double bound = suffix.probability * layers_[suffix.layer].best[suffix.place];
    if (!(bound > 0)) return;
    suffixes.push_back(suffix);
    open.push({bound, static_cast<std::uint32_t>(suffixes.size() - 1)});
  };
  const auto top = static_cast<std::uint32_t>(layers_.size() - 1);
  for (std::size_t i = 0; i < last().size(); ++i) {
    push({1, top, static_cast<std::uint32_t>(layers_[top].between() + i), none});
  }
  std::vector<Path> result;
  while (!open.empty() && result.size() < 2 * k + 64) {
    const Open next = open.top();
    open.pop();
    if (result.size() >= k && next.bound < result[k - 1].probability * (1 - tie_tolerance)) break;
    const Suffix suffix = suffixes[next.suffix];
    if (suffix.layer == 0) {
      Path& path = result.emplace_back(Path{next.bound, {}});
      for (std::uint32_t s = next.suffix; s != none; s = suffixes[s].behind) {
        const Layer& layer = layers_[suffixes[s].layer];
        if (suffixes[s].place >= layer.between()) {
          path.states.push_back(layer.states[suffixes[s].place - layer.between()]);
        }
      }
      continue;
    }
    const Layer& layer = layers_[suffix.layer];
    const Layer& before = layers_[suffix.layer - 1];
    for (std::size_t e = suffix.place == 0 ? 0 : layer.ends[suffix.place - 1]; e < layer.ends[suffix.place]; ++e) {
      const Edge& edge = layer.edges[e];
      const bool of_before = edge.from < before.states.size();
      const std::size_t place = of_before ? before.between() + edge.from : edge.from - before.states.size();
      push({suffix.probability * edge.probability, of_before ? suffix.layer - 1 : suffix.layer,
            static_cast<std::uint32_t>(place), next.suffix});
    }
  }
  return result;
}

}  // namespace rmpl::runtime
