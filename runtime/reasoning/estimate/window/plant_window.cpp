// A trellis, or a search, part by part; then the product of the parts.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/window/plant_window.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "automata/step/plant_step.hpp"
#include "base/check.hpp"
#include "base/product.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/best_tuples.hpp"
#include "runtime/reasoning/estimate/conditioning.hpp"
#include "runtime/reasoning/estimate/filter.hpp"
#include "runtime/reasoning/estimate/groups.hpp"
#include "runtime/reasoning/estimate/order.hpp"
#include "runtime/reasoning/estimate/possible_share.hpp"
#include "runtime/reasoning/estimate/set_aside.hpp"
#include "runtime/reasoning/estimate/window/trellis.hpp"
#include "runtime/reasoning/estimate/window/window_search.hpp"

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
  std::vector<Observation> set_aside;  ///< by what the beliefs keep
};

/// A part of the plant with its belief, those it had before, and its trellis or search.
class PlantWindow::Part {
 public:
  /// `members`: the components of the part in the whole plant; `own`: the group that it is, null where it is all.
  Part(const automata::Plant& plant, const EstimatorOptions& options, bool exact,
       std::vector<automata::ComponentId> members, const Group* own, std::size_t ways)
      : components(std::move(members)),
        group(own),
        ways_(ways),
        step_(plant),
        clocks_(plant, options.live_clocks_only),
        targets_(plant),
        possible_(step_),
        filters_(exact ? exact_filters(step_, options) : k_best_filters(step_, options)),
        conditioning(step_),
        filter(filters_->make()) {}

  /// The trellis or search of all updates, `position` being that of the part in what was told.
  void weigh(const std::deque<Told>& told, std::size_t position, std::size_t k) {
    if (search || !keep_trellis(told, position)) search_all(told, position, k);
  }

  /// The states of a trajectory that was found: where it set out, and after each update.
  [[nodiscard]] std::vector<SystemState> followed(const WindowSearch::Way& way, const std::deque<Told>& told) const {
    std::vector<SystemState> states{beliefs.front()[way.from].state};
    for (std::size_t t = 0; t < way.modes.size(); ++t) {
      const SystemState& last = states.back();
      SystemState next{way.modes[t], last.clock_starts};
      for (std::size_t c = 0; c < next.modes.size(); ++c) {
        next.clock_starts[c] =
            clocks_.advance(c, last.modes[c], last.clock_starts[c], next.modes[c], told[t].now, way.restarted[t][c]);
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

  /// What the histories come to by an update, best first. Of a search, those that were found.
  [[nodiscard]] Belief come_to(std::size_t update, const std::deque<Told>& told) const {
    Belief result;
    if (search) {
      for (const WindowSearch::Way& way : found.ways) {
        const double worth = std::exp(way.worths[update - 1] - found.ways.front().worths[update - 1]);
        const SystemState state = followed(way, told)[update];
        auto known = std::find_if(result.begin(), result.end(), [&](const auto& e) { return e.state == state; });
        if (known == result.end()) known = result.insert(known, {state, 0});
        known->probability += worth;
      }
    } else {
      for (const auto& [number, probability] : trellis.forward(update)) {
        if (probability > 0) result.push_back({states_[number], probability});
      }
    }
    normalise(result);
    put_in_order(result);
    return result;
  }

  const std::vector<automata::ComponentId> components;
  const Group* const group;

 private:
  /// False where a step has too many ways for a trellis.
  bool keep_trellis(const std::deque<Told>& told, std::size_t position) {
    states_.clear();
    numbers_.clear();
    counted.clear();
    std::vector<std::pair<Trellis::Number, double>> belief;
    for (const BeliefEntry& entry : beliefs.front()) belief.emplace_back(number(entry.state), entry.probability);
    trellis.begin(belief);
    for (const Told& update : told) {
      const auto next = count(update, position);
      if (!next) return false;
      counted.push_back(*next);
      next->stands ? trellis.stand() : trellis.advance();
    }
    return true;
  }

  /// Works out the next layer, and how the update counts; nothing where there are too many ways.
  std::optional<Counted> count(const Told& told, std::size_t position) {
    const ControlAction& action = told.actions[position];
    const Observation& seen = told.observations[position];
    const auto goes_on = extend(action, seen, told.before, told.now);
    if (!goes_on) return std::nullopt;
    if (*goes_on) return Counted{};
    targets_.begin();
    for (const Trellis::Number last : trellis.last()) {
      targets_.add(step_.moves(states_[last], action, told.before, told.now));
    }
    const auto aside = readings_to_set_aside(seen, [&](const Observation& r) { return targets_.refute(r); });
    if (aside && *extend(action, without(seen, *aside), told.before, told.now)) return Counted{*aside, false};
    if (aside && *extend(action, {}, told.before, told.now)) return Counted{seen, false};
    return Counted{{}, true};
  }

  /// The next layer; nothing where there are too many ways.
  std::optional<bool> extend(const ControlAction& action, const Observation& observation, Ticks before, Ticks now) {
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
      const auto moves_of = [&](std::size_t c) { return std::span<const automata::Move>(moves[c]); };
      const double share = possible_.of(source.modes, moves_of).value;
      if (share == 0) continue;  // no state follows
      const std::vector<bool> restarted = step_.restarted(source.modes, action);
      base::for_each_combination(moves, [&](const std::vector<automata::Move>& taken) {
        SystemState target;
        double probability = 1 / share;
        for (std::size_t c = 0; c < taken.size(); ++c) {
          probability *= taken[c].probability;
          target.modes.push_back(taken[c].mode);
          target.clock_starts.push_back(
              clocks_.advance(c, source.modes[c], source.clock_starts[c], taken[c].mode, now, restarted[c]));
        }
        probability *= step_.observation_factor(target.modes, observation);
        if (probability > 0) arrivals.push_back({number(target), from, probability});
      });
    }
    return trellis.extend(std::move(arrivals));
  }

  /// Searches all updates. Each dead end shows what counts for less.
  void search_all(const std::deque<Told>& told, std::size_t position, std::size_t k) {
    if (!search) {
      search = std::make_unique<WindowSearch>(step_);
      for (std::size_t t = 0; t < told.size(); ++t) {
        search->add(told[t].actions[position], told[t].observations[position], told[t].before, told[t].now,
                    beliefs[t + 1].front().state.modes);
      }
    }
    counted.assign(told.size(), {});
    while (true) {
      found = search->best(beliefs.front(), counted, k);
      if (!found.ways.empty()) return;
      if (found.dead_end) {
        Counted& last = counted[*found.dead_end];
        const Observation& seen = told[*found.dead_end].observations[position];
        CHECK(!last.stands);
        targets_.begin();
        search->add_targets(*found.dead_end, targets_);
        const auto aside = readings_to_set_aside(seen, [&](const Observation& r) { return targets_.refute(r); });
        if (!aside || last.set_aside == seen) {
          last = {{}, true};
        } else {
          last.set_aside = aside->empty() || last.set_aside == *aside ? seen : *aside;
        }
        continue;
      }
      // What the beliefs could not explain was not to be explained by anything that is near.
      bool fewer = false;
      for (std::size_t t = 0; t < told.size(); ++t) {
        if (told[t].set_aside[position].empty() || counted[t] != Counted{}) continue;
        counted[t].set_aside = told[t].set_aside[position];
        fewer = true;
      }
      if (!fewer) throw TooManyStates("the window of one independent group has too many ways that explain too little");
    }
  }

  Trellis::Number number(const SystemState& state) {
    const auto [known, fresh] = numbers_.try_emplace(state, static_cast<Trellis::Number>(states_.size()));
    if (fresh) states_.push_back(state);
    return known->second;
  }

  std::size_t ways_;
  automata::PlantStep step_;
  Clocks clocks_;
  StepTargets targets_;
  PossibleShare possible_;
  std::unique_ptr<Filters> filters_;
  std::vector<SystemState> states_;
  std::unordered_map<SystemState, Trellis::Number, SystemStateHash> numbers_;  ///< looked up, never iterated

 public:
  Conditioning conditioning;
  std::unique_ptr<Filter> filter;
  std::deque<Belief> beliefs;    ///< oldest first
  std::vector<Counted> counted;  ///< by update, when it was weighed last
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
      parts_.push_back(std::make_unique<Part>(groups_->plant(group), options, exact, group.components, &group, ways));
    }
  } else {
    groups_.reset();
    std::vector<automata::ComponentId> all;
    for (std::size_t c = 0; c < components_; ++c) all.emplace_back(c);
    parts_.push_back(std::make_unique<Part>(plant, options, exact, all, nullptr, ways));
  }
  start({});
}

PlantWindow::~PlantWindow() = default;

void PlantWindow::start(const Observation& observation) {
  const auto seen = groups_ ? groups_->divide(observation) : std::vector<Observation>{observation};
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    Part& part = *parts_[p];
    part.conditioning.start(*part.filter, seen[p]);
    part.beliefs.assign(1, part.filter->belief());
    part.search.reset();
    part.counted.clear();
  }
  told_.clear();
}

void PlantWindow::update(const ControlAction& action, const Observation& observation, Ticks now) {
  Told told{{}, groups_ ? groups_->divide(observation) : std::vector<Observation>{observation}, last_, now, {}};
  for (const auto& part : parts_) {
    ControlAction& own = told.actions.emplace_back();
    if (part->group == nullptr) own = action;
    for (std::size_t i = 0; part->group != nullptr && i < part->group->controls.size(); ++i) {
      own.push_back(action[part->group->controls[i]]);
    }
  }
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    Part& part = *parts_[p];
    const StepInput input{told.actions[p], told.observations[p], now, std::nullopt};
    told.set_aside.push_back(part.conditioning.update(*part.filter, input, last_).set_aside);
    part.beliefs.push_back(part.filter->belief());
    if (told_.size() == updates_) part.beliefs.pop_front();
    if (!part.search) continue;
    part.search->add(told.actions[p], told.observations[p], last_, now, part.filter->estimate().modes);
    if (told_.size() == updates_) part.search->drop_first();
  }
  told_.push_back(std::move(told));
  if (told_.size() > updates_) told_.pop_front();
  last_ = now;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (!told_.back().set_aside[p].empty()) set_right(p);
  }
}

/// The last belief of a part set readings aside: where histories of the window set fewer aside, the beliefs are what
/// these come to.
void PlantWindow::set_right(std::size_t part) {
  Part& own = *parts_[part];
  const Told& last = told_.back();
  own.weigh(told_, part, k_);
  if (own.counted.back().left_out(last.observations[part]) >= last.set_aside[part].size()) return;
  for (std::size_t t = 1; t <= told_.size(); ++t) own.beliefs[t] = own.come_to(t, told_);
  own.filter->resume(own.beliefs.back(), 0, last_);
}

std::vector<Observation> PlantWindow::set_aside() const {
  std::vector<Observation> result;
  for (std::size_t t = 0; t < told_.size(); ++t) {
    Observation& all = result.emplace_back();
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const Part& part = *parts_[p];
      const Counted& counted = part.counted[t];
      for (automata::Assignment reading : counted.stands ? told_[t].observations[p] : counted.set_aside) {
        if (part.group != nullptr) reading.variable = part.group->variables[reading.variable.index()];
        all.push_back(reading);
      }
    }
    std::sort(all.begin(), all.end());
  }
  return result;
}

bool PlantWindow::cut() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const auto& part) { return part->search && part->found.cut; });
}

bool PlantWindow::searched() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const auto& part) { return part->search != nullptr; });
}

std::vector<PlantTrajectory> PlantWindow::trajectories() {
  for (std::size_t p = 0; p < parts_.size(); ++p) parts_[p]->weigh(told_, p, k_);
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
