// A trellis group by group; then the product of the groups.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/marking/marking_window.hpp"

#include <algorithm>
#include <utility>

#include "base/check.hpp"
#include "runtime/reasoning/estimate/best_tuples.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/marking/marking_parts.hpp"
#include "runtime/reasoning/estimate/marking/marking_shares.hpp"
#include "runtime/reasoning/estimate/order.hpp"
#include "runtime/reasoning/estimate/set_aside.hpp"

namespace rmpl::runtime {

using automata::Marking;
using automata::MarkingStages;
using automata::MarkingStep;
using automata::Observation;

MarkingWindow::MarkingWindow(const automata::MarkingGroups& groups, const MarkingOptions& options)
    : groups_(groups), options_(options) {
  for (std::size_t g = 0; g < groups.size(); ++g) parts_.emplace_back(groups[g].program);
}

void MarkingWindow::start(std::vector<GroupBelief> belief) {
  told_.clear();
  for (Part& part : parts_) part.own.reset();
  from_.clear();
  from_.push_back(std::move(belief));
}

void MarkingWindow::update(std::vector<automata::Command> commands, std::vector<Observation> observations,
                           std::vector<GroupBelief> belief, const std::vector<std::size_t>& set_aside) {
  CHECK(!from_.empty());
  told_.push_back({std::move(commands), std::move(observations)});
  std::vector<GroupBelief> given = belief;
  std::vector<std::size_t> missed = set_aside;
  for (std::size_t g = 0; g < parts_.size(); ++g) {
    if (!parts_[g].own) continue;
    missed[g] = parts_[g].own->update(told_.back().commands[g], told_.back().observations[g]).set_aside.size();
    belief[g] = parts_[g].own->by_marking();
  }
  from_.push_back(std::move(belief));
  if (told_.size() > options_.window) {
    told_.pop_front();
    from_.pop_front();
  }
  for (std::size_t g = 0; g < parts_.size(); ++g) {
    if (missed[g] > 0) set_right(g, missed[g], set_aside[g], std::move(given[g]));
  }
}

/// The last belief of a group set readings aside: where the histories of the window set fewer aside, the beliefs are
/// what these come to. Else the estimator's may still be better than the window's own.
void MarkingWindow::set_right(std::size_t group, std::size_t set_aside, std::size_t set_aside_by_given,
                              GroupBelief given) {
  build(group);
  Part& part = parts_[group];
  if (part.counted.back().left_out(told_.back().observations[group]) < set_aside) {
    if (!part.own) part.own.emplace(groups_[group].program, options_);
    for (std::size_t t = 1; t < from_.size(); ++t) {
      GroupBelief& belief = from_[t][group];
      belief.clear();
      for (const auto& [number, probability] : part.trellis.forward(t)) {
        if (probability > 0) belief.emplace_back(part.step[number], probability);
      }
    }
    part.own->resume(from_.back()[group], 0);
  } else if (part.own && set_aside_by_given < set_aside) {
    part.own.reset();
    from_.back()[group] = std::move(given);
  }
}

void MarkingWindow::begin(std::size_t group) {
  Part& part = parts_[group];
  if (part.step.forget_but({})) {
    part.stages.clear();
  } else {
    part.stages.clear_where_full();
  }
  std::vector<std::pair<Trellis::Number, double>> belief;
  for (const auto& [marking, probability] : from_.front()[group]) {
    belief.emplace_back(part.step.number(marking), probability);
  }
  part.trellis.begin(belief);
}

bool MarkingWindow::extend(std::size_t group, const automata::Command& command, const Observation& readings) {
  Part& part = parts_[group];
  MarkingStep& step = part.step;
  step.command(command);
  step.observe(readings);
  const std::vector<Trellis::Number> last = part.trellis.last();
  const auto into = [&](MarkingStages::Place place) -> std::vector<Trellis::Edge>& {
    if (part.into.size() <= place) part.into.resize(std::max(2 * part.into.size(), part.stages.size()));
    return part.into[place];
  };
  std::vector<MarkingStages::Place> begins;
  std::vector<std::uint32_t> sources;
  for (std::uint32_t from = 0; from < last.size(); ++from) {
    if (!step.permits(last[from])) continue;
    begins.push_back(part.stages.begin(last[from]));
    sources.push_back(from);
  }
  const std::vector<double> shares = possible_shares(part.stages, step, begins);
  for (std::size_t i = 0; i < begins.size(); ++i) {
    if (shares[i] > 0) into(begins[i]).push_back({sources[i], 1 / shares[i]});
  }
  std::vector<std::vector<Trellis::Edge>> between;
  std::vector<Trellis::Arrival> arrivals;
  const auto visit = [&](MarkingStages::Place place, std::span<const MarkingStages::Edge> edges) {
    std::vector<Trellis::Edge> here = std::exchange(into(place), {});
    if (!part.stages.ended(place)) {
      const auto own = static_cast<std::uint32_t>(last.size() + between.size());
      between.push_back(std::move(here));
      for (const MarkingStages::Edge& edge : edges) into(edge.to).push_back({own, edge.probability});
      return;
    }
    const MarkingStep::Number target = part.stages.marking(place);
    if (!step.possible(target)) return;
    const double factor = step.factor(target);
    for (const Trellis::Edge& edge : here) {
      if (factor > 0) arrivals.push_back({target, edge.from, edge.probability * factor});
    }
  };
  part.stages.for_each_reached(begins, visit);
  return part.trellis.extend(std::move(arrivals), between);
}

/// Works out the next layer, and how the update counts.
Counted MarkingWindow::count(std::size_t group, const Told& told) {
  const Observation& seen = told.observations[group];
  const auto goes_on = [&](const Observation& readings) { return extend(group, told.commands[group], readings); };
  if (goes_on(seen)) return {};
  const auto aside = readings_to_set_aside(seen, [&](const Observation& readings) -> std::optional<Observation> {
    if (goes_on(readings)) return std::nullopt;
    return minimal_conflict(readings, goes_on);
  });
  if (!aside || !goes_on(without(seen, *aside))) return {{}, true};
  return {*aside, false};
}

/// The trellis of a group.
void MarkingWindow::build(std::size_t group) {
  Part& part = parts_[group];
  part.counted.clear();
  begin(group);
  for (const Told& told : told_) {
    part.counted.push_back(count(group, told));
    part.counted.back().stands ? part.trellis.stand() : part.trellis.advance();
  }
}

std::vector<Observation> MarkingWindow::set_aside() const {
  std::vector<Observation> result;
  for (std::size_t t = 0; t < told_.size(); ++t) {
    Observation& all = result.emplace_back();
    for (std::size_t g = 0; g < parts_.size(); ++g) {
      const Counted& counted = parts_[g].counted[t];
      for (const automata::Assignment& reading : counted.stands ? told_[t].observations[g] : counted.set_aside) {
        all.push_back({groups_[g].variables[reading.variable.index()], reading.value});
      }
    }
    std::sort(all.begin(), all.end());
  }
  return result;
}

std::vector<MarkingTrajectory> MarkingWindow::trajectories() {
  const std::size_t size = groups_.size();
  for (std::size_t g = 0; g < size; ++g) build(g);
  std::vector<std::vector<Trellis::Path>> paths;
  std::vector<Probabilities> lists;
  for (std::size_t g = 0; g < size; ++g) {
    Probabilities& list = lists.emplace_back();
    for (const auto& path : paths.emplace_back(parts_[g].trellis.best(options_.k))) list.push_back(path.probability);
  }
  std::vector<MarkingTrajectory> result;
  std::vector<const Marking*> parts(size);
  for (const Tuple& tuple : best_tuples(lists, options_.k)) {
    MarkingTrajectory& trajectory = result.emplace_back(MarkingTrajectory{tuple.probability, {}});
    for (std::size_t t = 0; t <= told_.size(); ++t) {
      for (std::size_t g = 0; g < size; ++g) parts[g] = &parts_[g].step.whole(paths[g][tuple.places[g]].states[t]);
      trajectory.markings.push_back(joined(groups_, parts));
    }
  }
  put_in_order(result, [](const MarkingTrajectory& a, const MarkingTrajectory& b) { return a.markings < b.markings; });
  if (result.size() > options_.k) result.resize(options_.k);
  return result;
}

}  // namespace rmpl::runtime
