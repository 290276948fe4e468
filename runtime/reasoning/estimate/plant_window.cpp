// A trellis part by part; then the product of the parts.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/plant_window.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "automata/step/plant_step.hpp"
#include "base/product.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/best_tuples.hpp"
#include "runtime/reasoning/estimate/filter.hpp"
#include "runtime/reasoning/estimate/groups.hpp"
#include "runtime/reasoning/estimate/order.hpp"
#include "runtime/reasoning/estimate/trellis.hpp"

namespace rmpl::runtime {

using automata::ControlAction;
using automata::Observation;
using automata::SystemState;
using automata::Ticks;

/// One update, by part.
struct PlantWindow::Told {
  std::vector<ControlAction> actions;
  std::vector<Observation> observations;
  Ticks before, now;
};

/// A part of the plant with its belief, those it had before, and its trellis.
class PlantWindow::Part {
 public:
  Part(const automata::Plant& plant, const EstimatorOptions& options, bool exact,
       std::vector<automata::ComponentId> members, std::vector<std::size_t> commanded)
      : components(std::move(members)),
        controls(std::move(commanded)),
        step_(plant),
        clocks_(plant, options.live_clocks_only),
        filter(exact ? make_exact_filter(step_, options) : make_k_best_filter(step_, options)) {}

  void begin() {
    states_.clear();
    numbers_.clear();
    std::vector<std::pair<Trellis::Number, double>> belief;
    for (const BeliefEntry& entry : beliefs.front()) belief.emplace_back(number(entry.state), entry.probability);
    trellis.begin(belief);
  }

  /// The next layer; without an observation what it says is left out of account.
  bool extend(const ControlAction& action, const Observation* observation, Ticks before, Ticks now) {
    std::vector<Trellis::Arrival> arrivals;
    const std::vector<Trellis::Number> last = trellis.last();
    for (std::uint32_t from = 0; from < last.size(); ++from) {
      const SystemState source = states_[last[from]];
      const auto moves = step_.moves(source, action, before, now);
      base::for_each_combination(moves, [&](const std::vector<automata::Move>& taken) {
        SystemState target;
        double probability = 1;
        for (std::size_t c = 0; c < taken.size(); ++c) {
          probability *= taken[c].probability;
          target.modes.push_back(taken[c].mode);
          target.clock_starts.push_back(
              clocks_.advance(c, source.modes[c], source.clock_starts[c], taken[c].mode, now));
        }
        if (!step_.possible(target.modes)) return;
        if (observation != nullptr) probability *= step_.observation_factor(target.modes, *observation);
        if (probability > 0) arrivals.push_back({number(target), from, probability});
        if (arrivals.size() > most_arrivals) {
          throw TooManyStates("the window of one independent group has too many ways to go on in one update");
        }
      });
    }
    return trellis.extend(std::move(arrivals));
  }

  [[nodiscard]] const SystemState& state(Trellis::Number number) const { return states_[number]; }

  const std::vector<automata::ComponentId> components;
  const std::vector<std::size_t> controls;

 private:
  static constexpr std::size_t most_arrivals = std::size_t{1} << 18;

  Trellis::Number number(const SystemState& state) {
    const auto [known, fresh] = numbers_.try_emplace(state, static_cast<Trellis::Number>(states_.size()));
    if (fresh) states_.push_back(state);
    return known->second;
  }

  automata::PlantStep step_;
  Clocks clocks_;
  std::vector<SystemState> states_;
  std::unordered_map<SystemState, Trellis::Number, SystemStateHash> numbers_;  ///< looked up, never iterated

 public:
  std::unique_ptr<Filter> filter;
  std::deque<Belief> beliefs;  ///< oldest first
  Trellis trellis;
};

PlantWindow::PlantWindow(const automata::Plant& plant, const EstimatorOptions& options, bool exact, std::size_t updates)
    : updates_(updates), k_(options.k), components_(plant.components.size()), groups_(std::make_unique<Groups>(plant)) {
  // A command that contradicts one group's store would enable every guard everywhere: then there is one part.
  const bool apart = groups_->size() > 1 && std::none_of(groups_->begin(), groups_->end(),
                                                         [](const Group& group) { return group.constrains_controls; });
  if (apart) {
    for (const Group& group : *groups_) {
      parts_.push_back(std::make_unique<Part>(group.plant, options, exact, group.components, group.controls));
    }
  } else {
    groups_.reset();
    std::vector<automata::ComponentId> all;
    for (std::size_t c = 0; c < components_; ++c) all.emplace_back(c);
    parts_.push_back(std::make_unique<Part>(plant, options, exact, all, std::vector<std::size_t>{}));
  }
  start({});
}

PlantWindow::~PlantWindow() = default;

void PlantWindow::start(const Observation& observation) {
  const auto seen = groups_ ? groups_->divide(observation) : std::vector<Observation>{observation};
  bool explained = true;
  for (std::size_t p = 0; p < parts_.size(); ++p) explained = parts_[p]->filter->start(seen[p]) && explained;
  for (const auto& part : parts_) {
    if (!explained) part->filter->start({});
    part->beliefs.assign(1, part->filter->belief());
  }
  told_.clear();
}

void PlantWindow::update(const ControlAction& action, const Observation& observation, Ticks now) {
  Told told{{}, groups_ ? groups_->divide(observation) : std::vector<Observation>{observation}, last_, now};
  for (const auto& part : parts_) {
    ControlAction& own = told.actions.emplace_back();
    for (const std::size_t i : part->controls) own.push_back(action[i]);
    if (!groups_) own = action;
  }
  const auto input = [&](std::size_t p) { return StepInput{told.actions[p], told.observations[p], now, std::nullopt}; };
  bool explained = true, doubtful = false;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    explained = parts_[p]->filter->condition(input(p)) && explained;
    const Estimate& estimate = parts_[p]->filter->estimate();
    doubtful = doubtful || estimate.cut || estimate.missing_total > 0;
  }
  bool goes_on = true;
  for (std::size_t p = 0; !explained && p < parts_.size(); ++p) {
    goes_on = parts_[p]->filter->predict(input(p), doubtful) && goes_on;
  }
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    Filter& filter = *parts_[p]->filter;
    goes_on ? filter.adopt(input(p), explained) : filter.stay(input(p));
    parts_[p]->beliefs.push_back(filter.belief());
    if (told_.size() == updates_) parts_[p]->beliefs.pop_front();
  }
  told_.push_back(std::move(told));
  if (told_.size() > updates_) told_.pop_front();
  last_ = now;
}

std::vector<PlantTrajectory> PlantWindow::trajectories() {
  for (const auto& part : parts_) part->begin();
  for (const Told& told : told_) {
    const auto extended = [&](bool seen) {
      bool all = true;
      for (std::size_t p = 0; p < parts_.size(); ++p) {
        const Observation* observation = seen ? &told.observations[p] : nullptr;
        all = parts_[p]->extend(told.actions[p], observation, told.before, told.now) && all;
      }
      return all;
    };
    const bool goes_on = extended(true) || extended(false);
    for (const auto& part : parts_) goes_on ? part->trellis.advance() : part->trellis.stand();
  }
  std::vector<std::vector<Trellis::Path>> paths;
  std::vector<Probabilities> lists;
  for (const auto& part : parts_) {
    Probabilities& list = lists.emplace_back();
    for (const auto& path : paths.emplace_back(part->trellis.best(k_))) list.push_back(path.probability);
  }
  std::vector<PlantTrajectory> result;
  for (const Tuple& tuple : best_tuples(lists, k_)) {
    PlantTrajectory& trajectory = result.emplace_back(PlantTrajectory{tuple.probability, {}});
    for (std::size_t t = 0; t <= told_.size(); ++t) {
      SystemState& whole = trajectory.states.emplace_back();
      whole.modes.resize(components_);
      whole.clock_starts.resize(components_);
      for (std::size_t p = 0; p < parts_.size(); ++p) {
        const SystemState& own = parts_[p]->state(paths[p][tuple.places[p]].states[t]);
        for (std::size_t i = 0; i < parts_[p]->components.size(); ++i) {
          whole.modes[parts_[p]->components[i].index()] = own.modes[i];
          whole.clock_starts[parts_[p]->components[i].index()] = own.clock_starts[i];
        }
      }
    }
  }
  put_in_order(result, [](const PlantTrajectory& a, const PlantTrajectory& b) { return a.states < b.states; });
  if (result.size() > k_) result.resize(k_);
  return result;
}

}  // namespace rmpl::runtime
