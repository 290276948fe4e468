// The estimators of model programs: one filter for each independent group of threads, and what they say together.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/marking_estimator.hpp"

#include <algorithm>
#include <deque>
#include <optional>

#include "automata/dependencies/marking_groups.hpp"
#include "base/check.hpp"
#include "runtime/reasoning/estimate/best_tuples.hpp"
#include "runtime/reasoning/estimate/marking_beam.hpp"
#include "runtime/reasoning/estimate/marking_filter.hpp"
#include "runtime/reasoning/estimate/marking_parts.hpp"
#include "runtime/reasoning/estimate/marking_window.hpp"
#include "runtime/reasoning/estimate/order.hpp"

namespace rmpl::runtime {
namespace {

using automata::Command;
using automata::Marking;
using automata::Observation;

class FactoredMarkingEstimator final : public MarkingEstimator {
 public:
  FactoredMarkingEstimator(const automata::ModelProgram& program, const MarkingOptions& options)
      : options_(options), groups_(program) {
    for (std::size_t g = 0; g < groups_.size(); ++g) filters_.emplace_back(groups_[g].program, options);
    if (options.window > 0) window_.emplace(groups_, options.window, options.k);
    FactoredMarkingEstimator::start({});
  }

  const MarkingEstimate& start(const Observation& observation) override {
    CHECK(!updated_);
    estimate_ = {};
    const auto seen = groups_.divide(observation);
    for (std::size_t g = 0; g < filters_.size(); ++g) {
      estimate_.explained = filters_[g].start(seen[g]) && estimate_.explained;
    }
    // What one group cannot explain is left out of account in all.
    for (MarkingFilter& filter : filters_) {
      if (!estimate_.explained) filter.start({});
      estimate_.possible = estimate_.possible && !filter.belief().empty();
    }
    if (window_) window_->start(by_group());
    return estimate_;
  }

  const MarkingEstimate& update(const Command& command, const Observation& observation) override {
    updated_ = true;
    estimate_ = {};
    const auto commands = groups_.divide(command);
    const auto seen = groups_.divide(observation);
    for (std::size_t g = 0; g < filters_.size(); ++g) {
      estimate_.explained = filters_[g].condition(commands[g], seen[g]) && estimate_.explained;
    }
    if (!estimate_.explained) {
      for (MarkingFilter& filter : filters_) estimate_.possible = filter.predict() && estimate_.possible;
    }
    for (MarkingFilter& filter : filters_) {
      if (estimate_.possible) filter.adopt();
      estimate_.cut = estimate_.cut || filter.cut();
      estimate_.checked += filter.checked();
    }
    if (window_) window_->update(commands, seen, by_group());
    return estimate_;
  }

  [[nodiscard]] std::vector<MarkingTrajectory> history() override {
    return window_ ? window_->trajectories() : std::vector<MarkingTrajectory>{};
  }

  [[nodiscard]] MarkingBelief belief() override {
    std::vector<Probabilities> lists;
    for (const MarkingFilter& filter : filters_) {
      Probabilities& list = lists.emplace_back();
      for (const NumberedEntry& entry : filter.belief()) list.push_back(entry.probability);
    }
    MarkingBelief result;
    std::vector<const Marking*> parts(filters_.size());
    std::vector<const std::vector<automata::Assignment>*> values(filters_.size());
    const std::size_t most =
        options_.kind == MarkingOptions::Kind::exact ? options_.listed : std::min(options_.k, options_.listed);
    for (const Tuple& tuple : best_tuples(lists, most)) {
      for (std::size_t g = 0; g < filters_.size(); ++g) {
        const auto number = filters_[g].belief()[tuple.places[g]].marking;
        parts[g] = &filters_[g].step().whole(number);
        values[g] = &filters_[g].step().values(number);
      }
      result.push_back({joined(groups_, parts), tuple.probability, joined(groups_, values)});
    }
    put_in_order(result, [](const MarkingEntry& a, const MarkingEntry& b) { return a.marking < b.marking; });
    if (result.size() > most) result.resize(most);
    return result;
  }
  [[nodiscard]] const MarkingEstimate& estimate() const override { return estimate_; }
  [[nodiscard]] std::size_t groups() const override { return filters_.size(); }
  [[nodiscard]] std::size_t questions() override {
    std::size_t sum = 0;
    for (MarkingFilter& filter : filters_) sum += filter.step().store().questions();
    return sum;
  }
  [[nodiscard]] std::size_t solver_calls() override {
    std::size_t sum = 0;
    for (MarkingFilter& filter : filters_) sum += filter.step().store().solver_calls();
    return sum;
  }

 private:
  std::vector<GroupBelief> by_group() {
    std::vector<GroupBelief> result;
    for (MarkingFilter& filter : filters_) {
      GroupBelief& belief = result.emplace_back();
      for (const NumberedEntry& entry : filter.belief()) {
        belief.emplace_back(filter.step()[entry.marking], entry.probability);
      }
    }
    return result;
  }

  MarkingOptions options_;
  automata::MarkingGroups groups_;
  std::deque<MarkingFilter> filters_;  ///< a filter stays where it is
  std::optional<MarkingWindow> window_;
  MarkingEstimate estimate_;
  bool updated_ = false;
};

}  // namespace

std::unique_ptr<MarkingEstimator> make_marking_estimator(const automata::ModelProgram& program,
                                                         const MarkingOptions& options) {
  if (options.kind == MarkingOptions::Kind::beam) return make_marking_beam(program, options);
  return std::make_unique<FactoredMarkingEstimator>(program, options);
}

}  // namespace rmpl::runtime
