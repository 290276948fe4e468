// A trellis group by group; then the product of the groups.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/marking_window.hpp"

#include <algorithm>
#include <utility>

#include "base/check.hpp"
#include "runtime/reasoning/estimate/best_tuples.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/marking_parts.hpp"
#include "runtime/reasoning/estimate/order.hpp"

namespace rmpl::runtime {

using automata::Marking;
using automata::MarkingStep;

MarkingWindow::MarkingWindow(const automata::MarkingGroups& groups, std::size_t updates, std::size_t k)
    : groups_(groups), updates_(updates), k_(k), trellis_(groups.size()) {
  for (std::size_t g = 0; g < groups.size(); ++g) steps_.emplace_back(groups[g].program, Trellis::most);
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

void MarkingWindow::begin(std::size_t group) {
  steps_[group].forget_but({});
  std::vector<std::pair<Trellis::Number, double>> belief;
  for (const auto& [marking, probability] : from_.front()[group]) {
    belief.emplace_back(steps_[group].number(marking), probability);
  }
  trellis_[group].begin(belief);
}

bool MarkingWindow::extend(std::size_t group, const Told& told, Reading reading) {
  MarkingStep& step = steps_[group];
  step.command(told.commands[group]);
  step.observe(told.observations[group]);
  const std::vector<Trellis::Number>& last = trellis_[group].last();
  std::vector<Trellis::Arrival> arrivals;
  for (std::uint32_t from = 0; from < last.size(); ++from) {
    const MarkingStep::Ways& ways = step.ways(last[from]);
    if (!ways) throw TooManyStates("a marking may go on in more ways than a window can follow");
    for (const auto& way : *ways) {
      const double p = reading == Reading::seen ? way.probability * step.factor(way.target) : way.probability;
      if (p > 0) arrivals.push_back({way.target, from, p});
    }
  }
  return trellis_[group].extend(std::move(arrivals));
}

std::vector<MarkingTrajectory> MarkingWindow::trajectories() {
  const std::size_t size = groups_.size();
  for (std::size_t g = 0; g < size; ++g) begin(g);
  for (const Told& told : told_) {
    const auto extended = [&](Reading reading) {
      bool all = true;
      for (std::size_t g = 0; g < size; ++g) all = extend(g, told, reading) && all;
      return all;
    };
    const bool goes_on = extended(Reading::seen) || extended(Reading::unseen);
    for (Trellis& trellis : trellis_) goes_on ? trellis.advance() : trellis.stand();
  }
  std::vector<std::vector<Trellis::Path>> paths;
  std::vector<Probabilities> lists;
  for (std::size_t g = 0; g < size; ++g) {
    Probabilities& list = lists.emplace_back();
    for (const auto& path : paths.emplace_back(trellis_[g].best(k_))) list.push_back(path.probability);
  }
  std::vector<MarkingTrajectory> result;
  std::vector<const Marking*> parts(size);
  for (const Tuple& tuple : best_tuples(lists, k_)) {
    MarkingTrajectory& trajectory = result.emplace_back(MarkingTrajectory{tuple.probability, {}});
    for (std::size_t t = 0; t <= told_.size(); ++t) {
      for (std::size_t g = 0; g < size; ++g) parts[g] = &steps_[g].whole(paths[g][tuple.places[g]].states[t]);
      trajectory.markings.push_back(joined(groups_, parts));
    }
  }
  put_in_order(result, [](const MarkingTrajectory& a, const MarkingTrajectory& b) { return a.markings < b.markings; });
  if (result.size() > k_) result.resize(k_);
  return result;
}

}  // namespace rmpl::runtime
