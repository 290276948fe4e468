// Forward sums and maxima, backward best first.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/trellis.hpp"

#include <algorithm>
#include <queue>
#include <string>

#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/order.hpp"

namespace rmpl::runtime {

void Trellis::begin(const std::vector<std::pair<Number, double>>& belief) {
  layers_.clear();
  Layer& layer = layers_.emplace_back();
  for (const auto& [state, probability] : belief) {
    layer.states.push_back(state);
    layer.sum.push_back(probability);
    layer.best.push_back(probability);
  }
  layer.into.resize(belief.size());
}

bool Trellis::extend(std::vector<Arrival> arrivals) {
  const Layer& last = layers_.back();
  next_ = {};
  double total = 0;
  std::stable_sort(arrivals.begin(), arrivals.end(),
                   [](const Arrival& a, const Arrival& b) { return a.target < b.target; });
  for (const Arrival& arrival : arrivals) {
    if (next_.states.empty() || next_.states.back() != arrival.target) {
      next_.states.push_back(arrival.target);
      next_.into.emplace_back();
      next_.sum.push_back(0);
      next_.best.push_back(0);
    }
    next_.into.back().push_back({arrival.from, arrival.probability});
    const double p = last.sum[arrival.from] * arrival.probability;
    next_.sum.back() += p;
    next_.best.back() = std::max(next_.best.back(), last.best[arrival.from] * arrival.probability);
    total += p;
  }
  if (next_.states.size() > most) {
    throw TooManyStates("the window of one independent group has more than " + std::to_string(most) +
                        " states at one time");
  }
  if (!(total > 0)) return false;
  for (std::size_t i = 0; i < next_.states.size(); ++i) {
    next_.sum[i] /= total;
    next_.best[i] /= total;
    for (Edge& edge : next_.into[i]) edge.probability /= total;
  }
  return true;
}

void Trellis::advance() { layers_.push_back(std::move(next_)); }

void Trellis::stand() {
  next_ = layers_.back();
  for (std::uint32_t i = 0; i < next_.states.size(); ++i) next_.into[i] = {{i, 1.0}};
  advance();
}

std::vector<Trellis::Path> Trellis::best(std::size_t k) const {
  struct Suffix {
    double bound;                       ///< of all that ends so
    double probability;                 ///< of what is behind its first place
    std::vector<std::uint32_t> places;  ///< from the last layer backwards
    bool operator<(const Suffix& other) const { return bound < other.bound; }
  };
  std::priority_queue<Suffix> open;
  for (std::uint32_t i = 0; i < last().size(); ++i) open.push({layers_.back().best[i], 1, {i}});
  std::vector<Path> result;
  while (!open.empty() && result.size() < 2 * k + 64) {
    Suffix suffix = open.top();
    open.pop();
    if (result.size() >= k && suffix.bound < result[k - 1].probability * (1 - tie_tolerance)) break;
    if (suffix.places.size() == layers_.size()) {
      Path& path = result.emplace_back(Path{suffix.bound, {}});
      for (std::size_t t = 0; t < layers_.size(); ++t) {
        path.states.push_back(layers_[t].states[suffix.places[layers_.size() - 1 - t]]);
      }
      continue;
    }
    const std::size_t layer = layers_.size() - suffix.places.size();
    for (const Edge& edge : layers_[layer].into[suffix.places.back()]) {
      Suffix longer{0, suffix.probability * edge.probability, suffix.places};
      longer.bound = longer.probability * layers_[layer - 1].best[edge.from];
      longer.places.push_back(edge.from);
      if (longer.bound > 0) open.push(std::move(longer));
    }
  }
  return result;
}

}  // namespace rmpl::runtime
