// Branch and bound over the components in which sources differ.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/joint_bound.hpp"

#include <algorithm>

namespace rmpl::runtime {
namespace {

using automata::ModeId;

constexpr std::size_t most_nodes = 512;

double greatest_promise(const Extensions& extensions, std::size_t component) {
  double greatest = 0;
  for (const OptimalSearch::PricedValue& choice : extensions.choices(component)) {
    greatest = std::max(greatest, extensions.promise(component, ModeId(choice.value)));
  }
  return greatest;
}

ModeId best_mode(const Extensions& extensions, std::size_t component) {
  ModeId best(0u);
  double greatest = -1;
  for (const OptimalSearch::PricedValue& choice : extensions.choices(component)) {
    const double promise = extensions.promise(component, ModeId(choice.value));
    if (promise > greatest) {
      greatest = promise;
      best = ModeId(choice.value);
    }
  }
  return best;
}

}  // namespace

void JointBound::look_at(std::span<const Source> sources) {
  contested_.clear();
  promise_.assign(1, {});
  const std::size_t components = sources.empty() ? 0 : sources.front().state->modes.size();
  for (const Source& source : sources) {
    double best = source.weight * source.extensions->greatest_factor();
    for (std::size_t c = 0; c < components; ++c) best *= greatest_promise(*source.extensions, c);
    promise_.front().push_back(best);
  }
  for (std::size_t c = 0; c < components; ++c) contest(sources, c);
  std::stable_sort(contested_.begin(), contested_.end(),
                   [](const Contested& a, const Contested& b) { return a.dissent > b.dissent; });
  promise_.resize(contested_.size() + 1, std::vector<double>(sources.size()));
}

/// Adds the component where the sources do not agree on its best mode. Modes that are best in none count as one, in
/// which each source has the best of them.
void JointBound::contest(std::span<const Source> sources, std::size_t component) {
  std::vector<ModeId> bests;
  Contested contested;
  for (const Source& source : sources) {
    const ModeId best = best_mode(*source.extensions, component);
    if (std::find(bests.begin(), bests.end(), best) == bests.end()) bests.push_back(best);
    if (best != bests.front()) contested.dissent += source.weight;
  }
  if (bests.size() < 2) return;
  contested.options.resize(bests.size() + 1);
  bool others = false;
  for (const Source& source : sources) {
    const double greatest = greatest_promise(*source.extensions, component);
    const auto share = [&](ModeId mode) {
      return greatest > 0 ? source.extensions->promise(component, mode) / greatest : 0.0;
    };
    double other = 0;
    for (const OptimalSearch::PricedValue& choice : source.extensions->choices(component)) {
      const ModeId mode(choice.value);
      if (std::find(bests.begin(), bests.end(), mode) == bests.end()) other = std::max(other, share(mode));
    }
    others = others || other > 0;
    for (std::size_t i = 0; i < bests.size(); ++i) contested.options[i].push_back(share(bests[i]));
    contested.options.back().push_back(other);
  }
  if (!others) contested.options.pop_back();
  contested_.push_back(std::move(contested));
}

bool JointBound::reaches(std::span<const double> fronts, double enough) {
  fronts_ = fronts;
  enough_ = enough;
  nodes_ = most_nodes;
  return reaches(0);
}

bool JointBound::reaches(std::size_t depth) {
  if (nodes_ == 0) return true;
  --nodes_;
  double sum = 0;
  for (std::size_t s = 0; s < fronts_.size(); ++s) sum += std::min(fronts_[s], promise_[depth][s]);
  if (sum < enough_) return false;
  if (depth == contested_.size()) return true;
  for (const std::vector<double>& option : contested_[depth].options) {
    for (std::size_t s = 0; s < fronts_.size(); ++s) promise_[depth + 1][s] = promise_[depth][s] * option[s];
    if (reaches(depth + 1)) return true;
  }
  return false;
}

}  // namespace rmpl::runtime
