// One estimator of markings; what it found is put together line by line.
// SPDX-License-Identifier: MIT
#include "runtime/executive/answer/marking_log_estimator.hpp"

#include <algorithm>
#include <utility>

#include "runtime/executive/cycle/stopwatch.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime {

using automata::Marking;
using automata::Ticks;

namespace {

/// An upper bound of the probability of what is not listed. A belief that is listed in full adds up to 1 but for
/// rounding.
double unlisted(const MarkingEstimate& estimate, const MarkingBelief& belief) {
  constexpr double rounding = 1e-12;
  double total = 0;
  for (const MarkingEntry& entry : belief) total += entry.probability;
  const double missing = 1 - (1 - estimate.missing_total) * std::min(1.0, total);
  return missing > rounding ? missing : estimate.missing_total;
}

}  // namespace

bool is_about_plants(const LogEstimatorOptions& options) {
  return options.thesis || options.ranks || options.live_clocks || options.all_clocks || options.deadline ||
         options.bytes;
}

MarkingOptions marking_options(const LogEstimatorOptions& options, bool beam) {
  using Kind = MarkingOptions::Kind;
  MarkingOptions own;
  const bool exact = options.engine == LogEstimatorOptions::Engine::exact;
  own.kind = beam ? Kind::beam : exact ? Kind::exact : Kind::k_best;
  if (options.k) own.k = own.listed = *options.k;
  own.window = options.window.value_or(0);
  return own;
}

MarkingLogEstimator::MarkingLogEstimator(const automata::ModelProgram& program, const MarkingOptions& options,
                                         const std::atomic<bool>* interruption, std::function<void(double)> took)
    : program_(program),
      options_(options),
      interruption_(interruption),
      took_(std::move(took)),
      estimator_(make_marking_estimator(program, options)) {}

const MarkingAnswer& MarkingLogEstimator::answer(const LogLine& line) {
  MarkingAnswer answer;
  const bool start = !begun_ && line.timed && line.is_of_start();
  if (start) {
    take_in(line.observations);
    estimator_->start(at_start_);
  } else {
    // Cycles that were left out went as the line before says.
    for (std::uint64_t i = 1; i <= line.unchanged; ++i) {
      if (interruption_ != nullptr && *interruption_) throw Interrupted();
      const Stopwatch stopwatch;
      update(before_, line.time_of_unchanged(i));
      if (took_) took_(stopwatch.seconds());
    }
    const Stopwatch stopwatch;
    update(line, line.time);
    if (options_.window > 0) answer.history = estimator_->history();
    if (took_) took_(stopwatch.seconds());
  }
  answer.belief = estimator_->belief();
  answer_ = std::move(answer);
  if (options_.window > 0) tell_history(start);
  answer_.cycle = line.cycle;
  answer_.time = line.time;
  answer_.estimate = estimator_->estimate();
  answer_.missing = unlisted(answer_.estimate, answer_.belief);
  const MarkingEstimate& estimate = answer_.estimate;
  account_.checked += estimate.checked;
  account_.dropped = std::max(account_.dropped, estimate.missing_mass);
  account_.missing = std::max(account_.missing, answer_.missing);
  account_.lacking = std::max({account_.lacking, estimate.missing_total, estimate.missing_mass});
  account_.cut = account_.cut || estimate.cut;
  before_ = line;
  return answer_;
}

void MarkingLogEstimator::update(const LogLine& told, Ticks time) {
  begun_ = true;
  estimator_->update(automata::command_from(program_, told.command), told.observations);
  ++account_.updates;
  times_.push_back(time);
  if (times_.size() > options_.window + 1) times_.erase(times_.begin());
}

void MarkingLogEstimator::tell_history(bool start) {
  answer_.times = times_;
  const auto unexplained = estimator_->set_aside_by_history();
  for (std::size_t t = 0; t < unexplained.size(); ++t) {
    if (!unexplained[t].empty()) answer_.unexplained.push_back({times_[t + 1], unexplained[t]});
  }
  if (start) answer_.history = estimator_->history();
  if (answer_.history.empty()) return;
  const std::vector<Marking>& now = answer_.history.front().markings;
  const std::size_t first = account_.updates + 1 - now.size();  // the update after which it sets out, or 0
  for (std::size_t t = 0; t < now.size(); ++t) {
    if (first + t < last_first_ || first + t >= last_first_ + last_.size()) continue;
    const Marking& before = last_[first + t - last_first_];
    if (before != now[t]) answer_.revised.push_back({times_[t], before, now[t]});
  }
  last_ = now;
  last_first_ = first;
}

/// Of several readings of one variable at the start the last counts.
void MarkingLogEstimator::take_in(const automata::Observation& observation) {
  for (const automata::Assignment& reading : observation) {
    std::erase_if(at_start_, [&](const automata::Assignment& known) { return known.variable == reading.variable; });
    at_start_.push_back(reading);
  }
  std::sort(at_start_.begin(), at_start_.end());
}

}  // namespace rmpl::runtime
