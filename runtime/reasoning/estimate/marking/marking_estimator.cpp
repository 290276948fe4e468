// The estimators of model programs: one filter for each independent group of threads, and what they say together.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/marking/marking_estimator.hpp"

#include <algorithm>
#include <deque>
#include <optional>

#include "automata/dependencies/marking_groups.hpp"
#include "base/check.hpp"
#include "runtime/reasoning/estimate/best_tuples.hpp"
#include "runtime/reasoning/estimate/marking/marking_filter.hpp"
#include "runtime/reasoning/estimate/marking/marking_parts.hpp"
#include "runtime/reasoning/estimate/marking/marking_window.hpp"
#include "runtime/reasoning/estimate/order.hpp"

namespace rmpl::runtime {
namespace {

using automata::Command;
using automata::Marking;
using automata::Observation;

class FactoredMarkingEstimator final : public MarkingEstimator {
 public:
  FactoredMarkingEstimator(const automata::ModelProgram& program, const MarkingOptions& options) : options_(options) {
    if (options.kind == MarkingOptions::Kind::beam) {
      filters_.emplace_back(program, options);
    } else {
      groups_.emplace(program);
      for (std::size_t g = 0; g < groups_->size(); ++g) filters_.emplace_back((*groups_)[g].program, options);
      if (options.window > 0) window_.emplace(*groups_, options);
    }
    FactoredMarkingEstimator::start({});
  }

  const MarkingEstimate& start(const Observation& observation) override {
    CHECK(!updated_);
    estimate_ = {};
    const auto seen = divided(observation);
    for (std::size_t g = 0; g < filters_.size(); ++g) {
      note(g, filters_[g].start(seen[g]));
      estimate_.possible = estimate_.possible && !filters_[g].belief().empty();
    }
    tell_missing();
    if (window_) window_->start(by_group());
    return estimate_;
  }

  const MarkingEstimate& update(const Command& command, const Observation& observation) override {
    updated_ = true;
    estimate_ = {};
    const auto commands = divided(command);
    const auto seen = divided(observation);
    std::vector<std::size_t> set_aside;
    for (std::size_t g = 0; g < filters_.size(); ++g) {
      const Conditioned conditioned = filters_[g].update(commands[g], seen[g]);
      set_aside.push_back(conditioned.set_aside.size());
      note(g, conditioned);
      estimate_.cut = estimate_.cut || filters_[g].cut();
      estimate_.checked += filters_[g].checked();
    }
    tell_missing();
    if (window_) window_->update(commands, seen, by_group(), set_aside);
    return estimate_;
  }

  [[nodiscard]] std::vector<MarkingTrajectory> history() override {
    return window_ ? window_->trajectories() : std::vector<MarkingTrajectory>{};
  }

  [[nodiscard]] std::vector<Observation> set_aside_by_history() const override {
    return window_ ? window_->set_aside() : std::vector<Observation>{};
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
      if (groups_) result.push_back({joined(*groups_, parts), tuple.probability, joined(*groups_, values)});
      if (!groups_) result.push_back({*parts.front(), tuple.probability, *values.front()});
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
  template <class Told>
  [[nodiscard]] std::vector<Told> divided(const Told& told) const {
    return groups_ ? groups_->divide(told) : std::vector<Told>{told};
  }

  /// Takes down how an update of a group went.
  void note(std::size_t group, const Conditioned& conditioned) {
    estimate_.possible = estimate_.possible && conditioned.follows;
    estimate_.explained = estimate_.explained && conditioned.follows && conditioned.set_aside.empty();
    if (conditioned.set_aside.empty()) return;
    if (!groups_) {
      estimate_.set_aside = conditioned.set_aside;
      return;
    }
    const std::vector<automata::VariableId>& variables = (*groups_)[group].variables;
    for (const automata::Assignment& reading : conditioned.set_aside) {
      estimate_.set_aside.push_back({variables[reading.variable.index()], reading.value});
    }
    std::sort(estimate_.set_aside.begin(), estimate_.set_aside.end());
  }

  void tell_missing() {
    double kept = 1, kept_of_all = 1;
    for (const MarkingFilter& filter : filters_) {
      kept *= 1 - filter.missing_mass();
      kept_of_all *= 1 - filter.missing_total();
    }
    const bool one = filters_.size() == 1;
    estimate_.missing_mass = one ? filters_.front().missing_mass() : 1 - kept;
    estimate_.missing_total = one ? filters_.front().missing_total() : 1 - kept_of_all;
  }

  std::vector<GroupBelief> by_group() {
    std::vector<GroupBelief> result;
    for (const MarkingFilter& filter : filters_) result.push_back(filter.by_marking());
    return result;
  }

  MarkingOptions options_;
  std::optional<automata::MarkingGroups> groups_;  ///< none of the beam, which is one of whole markings
  std::deque<MarkingFilter> filters_;              ///< a filter stays where it is
  std::optional<MarkingWindow> window_;
  MarkingEstimate estimate_;
  bool updated_ = false;
};

}  // namespace

std::unique_ptr<MarkingEstimator> make_marking_estimator(const automata::ModelProgram& program,
                                                         const MarkingOptions& options) {
  return std::make_unique<FactoredMarkingEstimator>(program, options);
}

}  // namespace rmpl::runtime
