// A trellis, or a search, part by part; then the product of the parts.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/plant_window.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "automata/step/plant_step.hpp"
#include "base/check.hpp"
#include "base/product.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/best_tuples.hpp"
#include "runtime/reasoning/estimate/filter.hpp"
#include "runtime/reasoning/estimate/groups.hpp"
#include "runtime/reasoning/estimate/order.hpp"
#include "runtime/reasoning/estimate/trellis.hpp"
#include "runtime/reasoning/estimate/window_search.hpp"

namespace rmpl::runtime {

using automata::ControlAction;
using automata::Modes;
using automata::Observation;
using automata::SystemState;
using automata::Ticks;

/// One update, by part.
struct PlantWindow::Told {
  std::vector<ControlAction> actions;
  std::vector<Observation> observations;
  Ticks before, now;
  bool explained;  ///< by what the beliefs keep
};

/// A part of the plant with its belief, those it had before, and its trellis or search.
class PlantWindow::Part {
 public:
  Part(const automata::Plant& plant, const EstimatorOptions& options, bool exact,
       std::vector<automata::ComponentId> members, std::vector<std::size_t> commanded, std::size_t ways)
      : components(std::move(members)),
        controls(std::move(commanded)),
        ways_(ways),
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

  /// The next layer; without an observation what it says is left out of account. Nothing where there are too many ways.
  std::optional<bool> extend(const ControlAction& action, const Observation* observation, Ticks before, Ticks now) {
    std::vector<Trellis::Arrival> arrivals;
    const std::vector<Trellis::Number> last = trellis.last();
    std::size_t ways = 0;
    for (std::uint32_t from = 0; from < last.size(); ++from) {
      const SystemState source = states_[last[from]];
      const auto& moves = step_.moves(source, action, before, now);
      std::size_t own = 1;
      for (const auto& component : moves) own = std::min(own * component.size(), ways_ + 1);
      ways += own;
      if (ways > ways_) return std::nullopt;
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
      });
    }
    return trellis.extend(std::move(arrivals));
  }

  /// From now on. What was told is added anew.
  void begin_search() { search = std::make_unique<WindowSearch>(step_); }

  /// The states of a trajectory that was found: where it set out, and after each update.
  [[nodiscard]] std::vector<SystemState> followed(const WindowSearch::Way& way, const std::deque<Told>& told) const {
    std::vector<SystemState> states{beliefs.front()[way.from].state};
    for (std::size_t t = 0; t < way.modes.size(); ++t) {
      const SystemState& last = states.back();
      SystemState next{way.modes[t], last.clock_starts};
      for (std::size_t c = 0; c < next.modes.size(); ++c) {
        next.clock_starts[c] = clocks_.advance(c, last.modes[c], last.clock_starts[c], next.modes[c], told[t].now);
      }
      states.push_back(std::move(next));
    }
    return states;
  }
  [[nodiscard]] std::vector<SystemState> followed(const Trellis::Path& path) const {
    std::vector<SystemState> states;
    for (const Trellis::Number number : path.states) states.push_back(states_[number]);
    return states;
  }

  const std::vector<automata::ComponentId> components;
  const std::vector<std::size_t> controls;

 private:
  Trellis::Number number(const SystemState& state) {
    const auto [known, fresh] = numbers_.try_emplace(state, static_cast<Trellis::Number>(states_.size()));
    if (fresh) states_.push_back(state);
    return known->second;
  }

  std::size_t ways_;
  automata::PlantStep step_;
  Clocks clocks_;
  std::vector<SystemState> states_;
  std::unordered_map<SystemState, Trellis::Number, SystemStateHash> numbers_;  ///< looked up, never iterated

 public:
  std::unique_ptr<Filter> filter;
  std::deque<Belief> beliefs;  ///< oldest first
  Trellis trellis;
  std::unique_ptr<WindowSearch> search;  ///< in place of the trellis
  WindowSearch::Result found;            ///< by the search, last
};

PlantWindow::PlantWindow(const automata::Plant& plant, const EstimatorOptions& options, bool exact, std::size_t updates,
                         std::size_t ways)
    : updates_(updates), k_(options.k), components_(plant.components.size()), groups_(std::make_unique<Groups>(plant)) {
  // A command that contradicts one group's store would enable every guard everywhere: then there is one part.
  const bool apart = groups_->size() > 1 && std::none_of(groups_->begin(), groups_->end(),
                                                         [](const Group& group) { return group.constrains_controls; });
  if (apart) {
    for (const Group& group : *groups_) {
      parts_.push_back(std::make_unique<Part>(group.plant, options, exact, group.components, group.controls, ways));
    }
  } else {
    groups_.reset();
    std::vector<automata::ComponentId> all;
    for (std::size_t c = 0; c < components_; ++c) all.emplace_back(c);
    parts_.push_back(std::make_unique<Part>(plant, options, exact, all, std::vector<std::size_t>{}, ways));
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
    part->search.reset();
  }
  told_.clear();
}

void PlantWindow::update(const ControlAction& action, const Observation& observation, Ticks now) {
  Told told{{}, groups_ ? groups_->divide(observation) : std::vector<Observation>{observation}, last_, now, true};
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
    if (!parts_[p]->search) continue;
    parts_[p]->search->add(told.actions[p], told.observations[p], last_, now, filter.estimate().modes);
    if (told_.size() == updates_) parts_[p]->search->drop_first();
  }
  told.explained = explained;
  told_.push_back(std::move(told));
  if (told_.size() > updates_) told_.pop_front();
  last_ = now;
}

/// The trellises of all parts; at least so much is left out of account as `readings` says, and then says itself.
void PlantWindow::keep_trellises(std::vector<Reading>& readings) {
  for (const auto& part : parts_) {
    if (!part->search) part->begin();
  }
  for (std::size_t t = 0; t < told_.size(); ++t) {
    const auto extended = [&](Reading reading) {
      if (readings[t] > reading) return false;
      bool all = true;
      for (std::size_t p = 0; p < parts_.size(); ++p) {
        Part& part = *parts_[p];
        if (part.search) continue;
        const Told& told = told_[t];
        const Observation* observation = reading == Reading::seen ? &told.observations[p] : nullptr;
        const auto goes_on = part.extend(told.actions[p], observation, told.before, told.now);
        if (!goes_on) take_to_searching(p);
        all = goes_on.value_or(true) && all;
      }
      return all;
    };
    readings[t] = extended(Reading::seen)     ? Reading::seen
                  : extended(Reading::unseen) ? Reading::unseen
                                              : Reading::stands;
    for (const auto& part : parts_) {
      if (!part->search) readings[t] == Reading::stands ? part->trellis.stand() : part->trellis.advance();
    }
  }
}

void PlantWindow::take_to_searching(std::size_t part) {
  Part& own = *parts_[part];
  own.begin_search();
  for (std::size_t t = 0; t < told_.size(); ++t) {
    const Told& told = told_[t];
    own.search->add(told.actions[part], told.observations[part], told.before, told.now,
                    own.beliefs[t + 1].front().state.modes);
  }
}

/// The searches of all parts; false where one shows that an update counts for less than `readings` said, which is noted
/// there.
bool PlantWindow::search(std::vector<Reading>& readings) {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    Part& part = *parts_[p];
    if (!part.search) continue;
    part.found = part.search->best(part.beliefs.front(), readings, k_);
    if (!part.found.ways.empty()) continue;
    if (part.found.dead_end) {
      Reading& last = readings[*part.found.dead_end];
      CHECK(last != Reading::stands);
      last = last == Reading::seen ? Reading::unseen : Reading::stands;
      return false;
    }
    // What the beliefs could not explain was not to be explained by anything that is near.
    bool fewer = false;
    for (std::size_t t = 0; t < told_.size(); ++t) {
      if (told_[t].explained || readings[t] != Reading::seen) continue;
      readings[t] = Reading::unseen;
      fewer = true;
    }
    if (!fewer) throw TooManyStates("the window of one independent group has too many ways that explain too little");
    return false;
  }
  return true;
}

bool PlantWindow::cut() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const auto& part) { return part->search && part->found.cut; });
}

bool PlantWindow::searched() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const auto& part) { return part->search != nullptr; });
}

std::vector<PlantTrajectory> PlantWindow::trajectories() {
  std::vector<Reading> readings(told_.size(), Reading::seen);
  do {
    keep_trellises(readings);
  } while (!search(readings));
  std::vector<std::vector<Trellis::Path>> paths(parts_.size());
  std::vector<Probabilities> lists(parts_.size());
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (parts_[p]->search) {
      for (const auto& way : parts_[p]->found.ways) lists[p].push_back(way.probability);
    } else {
      for (const auto& path : paths[p] = parts_[p]->trellis.best(k_)) lists[p].push_back(path.probability);
    }
  }
  std::vector<PlantTrajectory> result;
  for (const Tuple& tuple : best_tuples(lists, k_)) {
    PlantTrajectory& trajectory = result.emplace_back(PlantTrajectory{tuple.probability, {}});
    trajectory.states.assign(told_.size() + 1, {Modes(components_), std::vector<Ticks>(components_)});
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const Part& part = *parts_[p];
      const auto states = part.search ? part.followed(part.found.ways[tuple.places[p]], told_)
                                      : part.followed(paths[p][tuple.places[p]]);
      for (std::size_t t = 0; t < states.size(); ++t) {
        for (std::size_t i = 0; i < part.components.size(); ++i) {
          trajectory.states[t].modes[part.components[i].index()] = states[t].modes[i];
          trajectory.states[t].clock_starts[part.components[i].index()] = states[t].clock_starts[i];
        }
      }
    }
  }
  put_in_order(result, [](const PlantTrajectory& a, const PlantTrajectory& b) { return a.states < b.states; });
  if (result.size() > k_) result.resize(k_);
  return result;
}

}  // namespace rmpl::runtime
