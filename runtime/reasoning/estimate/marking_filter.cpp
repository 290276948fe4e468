// Sums over listed ways where they are few, else a search.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/marking_filter.hpp"

#include <algorithm>
#include <string>

#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/marking_search.hpp"
#include "runtime/reasoning/estimate/order.hpp"
#include "runtime/reasoning/estimate/product.hpp"

namespace rmpl::runtime {
namespace {

using automata::MarkingStep;

void normalise(NumberedBelief& belief) {
  double sum = 0;
  for (const NumberedEntry& entry : belief) sum += entry.probability;
  if (!(sum > 0)) return;
  for (NumberedEntry& entry : belief) entry.probability /= sum;
}

[[noreturn]] void refuse() {
  throw TooManyStates("the belief of one group of threads has more than " + std::to_string(most_states) + " markings");
}

}  // namespace

MarkingFilter::MarkingFilter(const automata::ModelProgram& program, const MarkingOptions& options)
    : options_(options),
      step_(program, options.kind == MarkingOptions::Kind::exact ? most_states : options.most_summed) {}

bool MarkingFilter::start(const automata::Observation& observation) {
  step_.observe(observation);
  const MarkingStep::Ways initial = step_.initial();
  if (!initial) refuse();
  next_.clear();
  for (const auto& way : *initial) {
    const double worth = way.probability * step_.factor(way.target);
    if (worth > 0) next_.push_back({way.target, worth});
  }
  const bool explained = !next_.empty();
  if (!explained) {
    for (const auto& way : *initial) next_.push_back({way.target, way.probability});
  }
  keep_best();
  adopt();
  return explained;
}

void MarkingFilter::forget() {
  std::vector<MarkingStep::Number> kept;
  for (const NumberedEntry& entry : belief_) kept.push_back(entry.marking);
  if (!step_.forget_but(kept)) return;
  for (std::size_t i = 0; i < belief_.size(); ++i) belief_[i].marking = static_cast<MarkingStep::Number>(i);
  prior_.clear();
}

bool MarkingFilter::condition(const automata::Command& command, const automata::Observation& observation) {
  forget();
  step_.command(command);
  step_.observe(observation);
  cut_ = false;
  checked_ = 0;
  return work_out(true);
}

bool MarkingFilter::predict() { return work_out(false); }

void MarkingFilter::adopt() { belief_.swap(next_); }

void MarkingFilter::add(MarkingStep::Number marking, double probability) {
  if (prior_.size() <= marking) prior_.resize(std::max<std::size_t>(2 * prior_.size(), marking + 1), 0.0);
  if (!(prior_[marking] > 0)) reached_.push_back(marking);
  prior_[marking] += probability;
}

/// The prediction, into `prior_`; false where some source has too many ways.
bool MarkingFilter::sum(const NumberedBelief& sources) {
  for (const NumberedEntry& source : sources) {
    const MarkingStep::Ways& ways = step_.ways(source.marking);
    if (!ways) return false;
    for (const auto& way : *ways) add(way.target, source.probability * way.probability);
  }
  return true;
}

bool MarkingFilter::work_out(bool seen) {
  next_.clear();
  reached_.clear();
  const bool listed = sum(belief_);
  for (const MarkingStep::Number marking : reached_) {
    if (listed) {
      const double worth = seen ? prior_[marking] * step_.factor(marking) : prior_[marking];
      if (worth > 0) next_.push_back({marking, worth});
    }
    prior_[marking] = 0;
  }
  if (listed) {
    checked_ += reached_.size();
    if (next_.size() > most_states) refuse();
  } else {
    if (options_.kind == MarkingOptions::Kind::exact) refuse();
    BestMarkings best = best_markings(step_, belief_, seen, options_.k, options_.candidates);
    next_ = std::move(best.found);
    cut_ = cut_ || best.cut;
    checked_ += best.checked;
  }
  keep_best();
  return !next_.empty();
}

void MarkingFilter::keep_best() {
  put_in_order(next_, [&](const NumberedEntry& a, const NumberedEntry& b) {
    if (a.marking == b.marking) return false;
    const automata::Marking first = step_.whole(a.marking);
    return first < step_.whole(b.marking);
  });
  if (options_.kind != MarkingOptions::Kind::exact && next_.size() > options_.k) next_.resize(options_.k);
  normalise(next_);
}

}  // namespace rmpl::runtime
