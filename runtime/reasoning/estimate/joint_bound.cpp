// Branch and bound over the components in which sources differ.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/joint_bound.hpp"

#include <algorithm>

namespace rmpl::runtime {

using automata::ModeId;

void JointBound::look_at(std::span<const Source> sources) {
  contested_.clear();
  promise_.assign(1, {});
  excluded_.clear();
  if (sources.empty()) return;
  for (const Conflict& conflict : sources.front().extensions->conflicts()) {
    if (conflict.size() == 1) excluded_.push_back(conflict.front());
  }
  std::sort(excluded_.begin(), excluded_.end());
  for (const Source& source : sources) {
    promise_.front().push_back(source.weight * source.extensions->greatest_factor());
  }
  for (std::size_t c = 0; c < sources.front().modes->size(); ++c) contest(sources, c);
  std::stable_sort(contested_.begin(), contested_.end(),
                   [](const Contested& a, const Contested& b) { return a.dissent > b.dissent; });
  promise_.resize(contested_.size() + 1, std::vector<double>(sources.size()));
}

JointBound::Best JointBound::best(const Source& source, std::size_t component) {
  ModeId mode(0u);
  double greatest = -1;
  for (const OptimalSearch::PricedValue& choice : source.extensions->choices(component)) {
    const double promise = source.extensions->promise(component, ModeId(choice.value));
    if (promise <= greatest) continue;
    greatest = promise;
    mode = ModeId(choice.value);
  }
  return {mode, std::max(greatest, 0.0)};
}

/// Adds the component where the sources do not agree on its best mode. Modes that are best in none count as one, in
/// which each source has the best of them. Most components are in most sources as they are in the first.
void JointBound::contest(std::span<const Source> sources, std::size_t component) {
  const Source& first = sources.front();
  const auto as_in_first = [&](const Source& source) {
    return source.extensions->moves_as(*first.extensions, component);
  };
  bests_.assign(1, best(first, component));
  std::vector<ModeId> places{bests_.front().mode};
  Contested contested;
  for (std::size_t s = 0; s < sources.size(); ++s) {
    if (s > 0) bests_.push_back(as_in_first(sources[s]) ? bests_.front() : best(sources[s], component));
    promise_.front()[s] *= bests_[s].promise;
    if (bests_[s].mode == places.front()) continue;
    contested.dissent += sources[s].weight;
    if (std::find(places.begin(), places.end(), bests_[s].mode) == places.end()) places.push_back(bests_[s].mode);
  }
  if (places.size() < 2) return;
  contested.options.assign(places.size() + 1, std::vector<double>(sources.size(), 0.0));
  bool others = false;
  for (std::size_t s = 0; s < sources.size(); ++s) {
    if (s > 0 && as_in_first(sources[s])) {
      for (std::vector<double>& option : contested.options) option[s] = option.front();
      continue;
    }
    for (const OptimalSearch::PricedValue& choice : sources[s].extensions->choices(component)) {
      const ModeId mode(choice.value);
      const Decision decision{static_cast<std::uint32_t>(component), choice.value};
      if (std::binary_search(excluded_.begin(), excluded_.end(), decision)) continue;
      const double most = bests_[s].promise;
      const double share = most > 0 ? sources[s].extensions->promise(component, mode) / most : 0.0;
      const auto own = std::find(places.begin(), places.end(), mode) - places.begin();
      double& option = contested.options[static_cast<std::size_t>(own)][s];
      option = std::max(option, share);
    }
    others = others || contested.options.back()[s] > 0;
  }
  if (!others) contested.options.pop_back();
  contested_.push_back(std::move(contested));
}

bool JointBound::reaches(std::span<const double> fronts, double enough, std::size_t nodes) {
  fronts_ = fronts;
  enough_ = enough;
  nodes_ = nodes;
  return reaches(0);
}

bool JointBound::reaches(std::size_t depth) {
  if (nodes_ == 0) return true;
  --nodes_;
  double sum = 0;
  for (std::size_t s = 0; s < fronts_.size() && sum < enough_; ++s) sum += std::min(fronts_[s], promise_[depth][s]);
  if (sum < enough_) return false;
  if (depth == contested_.size()) return true;
  for (const std::vector<double>& option : contested_[depth].options) {
    for (std::size_t s = 0; s < fronts_.size(); ++s) promise_[depth + 1][s] = promise_[depth][s] * option[s];
    if (reaches(depth + 1)) return true;
  }
  return false;
}

}  // namespace rmpl::runtime
