// Sums over stages where the ways are few, else a search.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/marking/marking_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/marking/marking_search.hpp"
#include "runtime/reasoning/estimate/marking/marking_shares.hpp"
#include "runtime/reasoning/estimate/order.hpp"
#include "runtime/reasoning/estimate/product.hpp"

namespace rmpl::runtime {
namespace {

using automata::MarkingStages;
using automata::MarkingStep;

constexpr std::size_t least_summed = 256;
constexpr std::size_t summed_for_each = 64;
constexpr std::size_t greatest_summed = std::size_t{1} << 14;
constexpr std::size_t most_listed = 64;  // sources, and ways of each

double normalise(NumberedBelief& belief) {
  double sum = 0;
  for (const NumberedEntry& entry : belief) sum += entry.probability;
  if (!(sum > 0)) return sum;
  for (NumberedEntry& entry : belief) entry.probability /= sum;
  return sum;
}

[[noreturn]] void refuse() {
  throw TooManyStates("the belief of one group of threads has more than " + std::to_string(most_states) + " markings");
}

/// By variable: whether what is told, or a constraint, speaks of it.
std::vector<bool> told_of(const automata::ModelProgram& program) {
  std::vector<bool> result(program.variables.size(), false);
  const auto note = [&](const automata::Formula& formula) {
    for (const automata::VariableId v : automata::variables_of(formula)) result[v.index()] = true;
  };
  for (const automata::ModelLocation& location : program.locations) note(location.told);
  for (const automata::Interconnection& constraint : program.constraints) note(constraint.constraint);
  return result;
}

}  // namespace

MarkingFilter::MarkingFilter(const automata::ModelProgram& program, const MarkingOptions& options)
    : options_(options), step_(program), stages_(step_), told_of_(told_of(program)) {
  if (options_.most_summed == 0)
    options_.most_summed = std::clamp(summed_for_each * options_.k, least_summed, greatest_summed);
}

Conditioned MarkingFilter::start(const automata::Observation& observation) {
  const MarkingStep::Ways initial = step_.initial();
  if (!initial) refuse();
  reached_.clear();
  for (const auto& way : *initial) reached_.push_back(way.target);
  summed_ = true;
  const auto take = [&](const automata::Observation& seen) {
    step_.observe(seen);
    seen_ = seen;
    next_.clear();
    for (const auto& way : *initial) weigh(way.target, way.probability);
    return !next_.empty();
  };
  Conditioned result;
  if (!take(observation)) {
    result.set_aside = to_set_aside(observation).value_or(observation);
    result.follows = take(without(observation, result.set_aside));
  }
  missing_ratio_ = lost_ = 0;
  weighed_ = true;
  keep_best();
  adopt();
  return result;
}

void MarkingFilter::forget() {
  std::vector<MarkingStep::Number> kept;
  for (const NumberedEntry& entry : belief_) kept.push_back(entry.marking);
  if (!step_.forget_but(kept)) return stages_.clear_where_full();
  for (std::size_t i = 0; i < belief_.size(); ++i) belief_[i].marking = static_cast<MarkingStep::Number>(i);
  prior_.clear();
  stages_.clear();
}

void MarkingFilter::resume(const GroupBelief& belief, double missing) {
  next_.clear();
  lost_ = 0;
  weighed_ = false;
  for (const auto& [marking, probability] : belief) next_.push_back({step_.number(marking), probability});
  keep_best();
  missing_ratio_ = missing < 1 ? missing / (1 - missing) : std::numeric_limits<double>::infinity();
  adopt();
}

GroupBelief MarkingFilter::by_marking() const {
  GroupBelief result;
  for (const NumberedEntry& entry : belief_) result.emplace_back(step_[entry.marking], entry.probability);
  return result;
}

Conditioned MarkingFilter::update(const automata::Command& command, const automata::Observation& observation) {
  forget();
  step_.command(command);
  cut_ = false;
  checked_ = 0;
  Conditioned result;
  if (!work_out(observation)) {
    // What was not kept earlier, or not looked at, might have explained it.
    if (cut_ || missing_ratio_ > 0) missing_ratio_ = std::numeric_limits<double>::infinity();
    result.set_aside = to_set_aside(observation).value_or(observation);
    if (!work_out(without(observation, result.set_aside))) {
      result.set_aside = observation;
      result.follows = work_out({});
    }
  }
  if (result.follows) adopt();
  return result;
}

std::optional<automata::Observation> MarkingFilter::to_set_aside(const automata::Observation& observation) {
  const auto explained = [&](const automata::Observation& readings) { return explains(readings); };
  return readings_to_set_aside(observation,
                               [&](const automata::Observation& readings) -> std::optional<automata::Observation> {
                                 if (explains(readings)) return std::nullopt;
                                 return minimal_conflict(readings, explained);
                               });
}

/// Whether some marking of those that are predicted does.
bool MarkingFilter::explains(const automata::Observation& readings) {
  step_.observe(readings);
  if (summed_) {
    return std::any_of(reached_.begin(), reached_.end(),
                       [&](MarkingStep::Number marking) { return step_.factor(marking) > 0; });
  }
  return !best_markings(step_, belief_, Worth::posterior, 1, options_.candidates).found.empty();
}

void MarkingFilter::adopt() {
  belief_.swap(next_);
  missing_mass_ = lost_ > 0 ? lost_ / (lost_ + kept_) : 0;
  const double factor = weighed_ ? greatest_factor() : 1;
  missing_ratio_ = missing_ratio_ > 0 || lost_ > 0 ? (missing_ratio_ * factor + lost_) / kept_ : 0;
}

double MarkingFilter::missing_total() const {
  return std::isfinite(missing_ratio_) ? missing_ratio_ / (1 + missing_ratio_) : 1.0;
}

/// Of any marking: a reading of what nothing speaks of is as good as another one.
double MarkingFilter::greatest_factor() const {
  double factor = 1;
  for (const automata::Assignment& reading : seen_) {
    if (told_of_[reading.variable.index()]) continue;
    factor /= static_cast<double>(step_.program().variables[reading.variable].values.size());
  }
  return factor;
}

/// Whether no source has more ways than so many.
bool MarkingFilter::few_ways(std::size_t most) {
  return std::all_of(belief_.begin(), belief_.end(), [&](const NumberedEntry& source) {
    if (!step_.permits(source.marking)) return true;
    std::size_t ways = 1;
    for (const auto& part : step_.moves(source.marking).parts) {
      ways = std::min(ways * part.size(), most + 1);
    }
    return ways <= most;
  });
}

void MarkingFilter::add(MarkingStep::Number marking, double probability) {
  if (prior_.size() <= marking) prior_.resize(std::max<std::size_t>(2 * prior_.size(), marking + 1), 0.0);
  if (!(prior_[marking] > 0)) reached_.push_back(marking);
  prior_[marking] += probability;
  if (reached_.size() > most_states) refuse();
}

/// Few ways are remembered one by one, which is faster from cycle to cycle.
void MarkingFilter::add_listed() {
  for (const NumberedEntry& source : belief_) {
    // What cannot happen is not among the ways; the rest is scaled to 1.
    double possible = 0;
    for (const auto& way : *step_.ways(source.marking)) possible += way.probability;
    for (const auto& way : *step_.ways(source.marking)) {
      add(way.target, source.probability * way.probability / possible);
    }
  }
}

/// The prediction, into `prior_`; false where the sources have too little in common to be summed.
bool MarkingFilter::sum() {
  try {
    add_all();
    return true;
  } catch (const automata::TooManyOutcomes& error) {
    if (exact()) throw TooManyStates(error.what());
  }
  stages_.clear();
  way_.clear();
  prior_.clear();
  return false;
}

void MarkingFilter::add_all() {
  reached_.clear();
  if (belief_.size() <= most_listed && few_ways(most_listed)) return add_listed();
  std::vector<MarkingStages::Place> begins;
  std::vector<double> weights;
  for (const NumberedEntry& source : belief_) {
    if (!step_.permits(source.marking)) continue;
    begins.push_back(stages_.begin(source.marking));
    weights.push_back(source.probability);
  }
  if (add_stages(begins, weights)) return;
  // Some outcomes cannot happen: the others of their source are worth more.
  for (const MarkingStep::Number marking : reached_) prior_[marking] = 0;
  reached_.clear();
  const std::vector<double> shares = possible_shares(stages_, step_, begins);
  for (std::size_t i = 0; i < begins.size(); ++i) weights[i] = shares[i] > 0 ? weights[i] / shares[i] : 0;
  add_stages(begins, weights);
}

/// Adds what the step leads to from places that weigh so much; whether all of that is possible.
bool MarkingFilter::add_stages(const std::vector<MarkingStages::Place>& begins, const std::vector<double>& weights) {
  const auto at = [&](MarkingStages::Place place) -> double& {
    if (way_.size() <= place) way_.resize(std::max(2 * way_.size(), stages_.size()), 0.0);
    return way_[place];
  };
  for (std::size_t i = 0; i < begins.size(); ++i) at(begins[i]) += weights[i];
  bool possible = true;
  stages_.for_each_reached(begins, [&](MarkingStages::Place place, std::span<const MarkingStages::Edge> edges) {
    const double p = std::exchange(at(place), 0.0);
    for (const MarkingStages::Edge& edge : edges) at(edge.to) += p * edge.probability;
    if (!stages_.ended(place) || !(p > 0)) return;
    const MarkingStep::Number target = stages_.marking(place);
    const bool own = step_.possible(target);
    possible = possible && own;
    if (own) add(target, p);
  });
  return possible;
}

/// Notes what a marking that was predicted is worth, where it explains what is seen.
void MarkingFilter::weigh(MarkingStep::Number marking, double prior) {
  const double factor = step_.factor(marking);
  const bool beam = options_.kind == MarkingOptions::Kind::beam;
  if (factor > 0) next_.push_back({marking, beam ? prior : prior * factor});
}

/// The belief after the step given some readings, into `next_`; false where nothing explains them.
bool MarkingFilter::work_out(const automata::Observation& observation) {
  step_.observe(observation);
  seen_ = observation;
  next_.clear();
  lost_ = 0;
  weighed_ = true;
  summed_ = (exact() || few_ways(options_.most_summed)) && sum();
  if (summed_) {
    for (const MarkingStep::Number marking : reached_) weigh(marking, std::exchange(prior_[marking], 0.0));
    checked_ += reached_.size();
  } else {
    const bool beam = options_.kind == MarkingOptions::Kind::beam;
    BestMarkings best =
        best_markings(step_, belief_, beam ? Worth::beam : Worth::posterior, options_.k, options_.candidates);
    next_ = std::move(best.found);
    cut_ = cut_ || best.cut;
    checked_ += best.checked;
    lost_ = best.unfound * greatest_factor();
  }
  keep_best();
  return !next_.empty();
}

/// Of what was found the best, normalised; what the rest is worth is lost. A beam is weighed by the readings then.
void MarkingFilter::keep_best() {
  const auto put = [&] {
    put_in_order(next_, [&](const NumberedEntry& a, const NumberedEntry& b) {
      if (a.marking == b.marking) return false;
      const automata::Marking first = step_.whole(a.marking);
      return first < step_.whole(b.marking);
    });
  };
  put();
  const bool beam = weighed_ && options_.kind == MarkingOptions::Kind::beam;
  const auto posterior = [&](const NumberedEntry& entry) {
    return beam ? entry.probability * step_.factor(entry.marking) : entry.probability;
  };
  if (!exact() && next_.size() > options_.k) {
    for (std::size_t i = options_.k; i < next_.size(); ++i) lost_ += posterior(next_[i]);
    next_.resize(options_.k);
  }
  if (beam) {
    for (NumberedEntry& entry : next_) entry.probability = posterior(entry);
    put();
  }
  kept_ = normalise(next_);
}

}  // namespace rmpl::runtime
