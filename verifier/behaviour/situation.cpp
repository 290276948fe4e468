// Situations: a mode for every component, with all that may happen there.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/situation.hpp"

#include <algorithm>
#include <tuple>

#include "verifier/behaviour/folds.hpp"
#include "verifier/property/initial_modes.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::ControlAction;
using automata::ModeId;
using automata::Modes;

namespace {

/// Situations whose moves are remembered: those of one are wanted again when it is reached with other clocks. What else
/// is told of one is wanted wherever a step leads there.
constexpr std::size_t remembered = 1u << 14;

void add_bound(Box& box, ComponentId component, const Interval& clock) {
  if (!clock.is_trivial()) box.push_back({component, clock});
}

}  // namespace

Situations::Situations(automata::PlantStep& step, const TimeModel& time, Commands commands, unsigned faults,
                       Meter& meter)
    : step_(step),
      behaviours_(step, time),
      commands_(commands),
      faults_(faults),
      meter_(meter),
      table_(step.plant()),
      joint_steps_(behaviours_, faults, meter),
      described_(remembered) {
  for (std::size_t c = 0; c < plant().components.size(); ++c) {
    auto& modes = limits_.emplace_back();
    const Component& component = plant().components[c];
    std::vector<bool> possible;
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const Assignment assumed{component.mode, automata::ValueId(m)};
      possible.push_back(step.theory().consistent({&assumed, 1}));
    }
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const bool live = plant().has_timed_exit(ComponentId(c), ModeId(m));
      modes.push_back(live ? std::optional(clock_limits(component, ModeId(m), time, possible)) : std::nullopt);
    }
  }
  position_of(automata::idle_action(plant()));
}

std::uint32_t Situations::position_of(const ControlAction& action) {
  const auto [at, fresh] = action_positions_.try_emplace(action, static_cast<std::uint32_t>(actions_.size()));
  if (fresh) actions_.push_back(action);
  return at->second;
}

void Situations::use(Steps steps, const std::vector<ComponentId>& visible) {
  joint_steps_.use(steps == Steps::all && tells_exits_ ? Steps::every_action : steps, visible);
  moves_.clear();
}

void Situations::fold(Folds& folds) {
  behaviours_.fold(folds);
  for (std::size_t c = 0; c < limits_.size(); ++c) {
    for (std::size_t m = 0; m < limits_[c].size(); ++m) {
      if (const auto limits = folds.limits(ComponentId(c), ModeId(m))) limits_[c][m] = limits;
    }
  }
}

void Situations::up_to(const Symmetry& symmetry) {
  joint_steps_.up_to(symmetry);
  moves_.clear();
}

Modes Situations::modes(SituationId id) const {
  Modes result;
  table_.read(id.value, result);
  return result;
}

std::shared_ptr<const Situation> Situations::operator[](SituationId id) {
  return described_.find_or(id.value, [&] { return std::make_shared<const Situation>(describe(modes(id))); });
}

Situation Situations::describe(const Modes& modes) {
  behaviours_.read(modes, actions_.front(), behaviours_here_);
  Situation result{modes, {}, waits(behaviours_here_), restarted(behaviours_here_), {}, {}, {}};
  result.live.reserve(modes.size());
  result.stays_until.reserve(modes.size());
  result.limits.reserve(modes.size());
  for (std::size_t c = 0; c < modes.size(); ++c) {
    for (const Interval& clock : behaviours_[behaviours_here_[c]].faulty)
      result.faulty.push_back({ComponentId(c), clock});
    const auto& limits = limits_[c][modes[c].index()];
    if (!limits) continue;
    result.live.emplace_back(c);
    result.stays_until.push_back(behaviours_[behaviours_here_[c]].stays_until);
    result.limits.push_back(*limits);
  }
  return result;
}

std::vector<ComponentId> Situations::restarted(const std::vector<BehaviourId>& behaviours) const {
  std::vector<ComponentId> result;
  if (!behaviours_.some_restart()) return result;
  for (std::size_t c = 0; c < behaviours.size(); ++c) {
    if (behaviours_[behaviours[c]].restarts) result.emplace_back(c);
  }
  return result;
}

std::vector<Box> Situations::waits(const std::vector<BehaviourId>& behaviours) const {
  std::vector<Box> boxes = {{}};
  for (std::size_t c = 0; c < behaviours.size(); ++c) {
    const std::vector<Interval>& own = behaviours_[behaviours[c]].waits;
    if (own.size() == 1) {
      for (Box& box : boxes) add_bound(box, ComponentId(c), own.front());
      continue;
    }
    std::vector<Box> longer;
    for (const Interval& wait : own) {
      for (Box box : boxes) {
        add_bound(box, ComponentId(c), wait);
        longer.push_back(std::move(box));
      }
    }
    boxes = std::move(longer);
  }
  return boxes;
}

std::shared_ptr<const std::vector<JointStep>> Situations::moves(SituationId id, const Late& late, unsigned faults,
                                                                const Late& due) {
  const std::tuple key(id, late, faults, due);
  if (const auto known = moves_.find(key); known != moves_.end()) return known->second;
  if (moves_.size() >= remembered) moves_.clear();
  auto worked_out = std::make_shared<const std::vector<JointStep>>(work_out(modes(id), late, faults, due));
  moves_.emplace(key, worked_out);
  return worked_out;
}

std::vector<JointStep> Situations::work_out(const Modes& modes, const Late& late, unsigned faults, const Late& due) {
  std::vector<JointStep> result;
  joint_steps_.allow(faults);
  const bool may_idle = behaviours_.read(modes, actions_.front(), idling_);
  const bool sampled = !time().is_dense();
  const std::vector<Box> idle_waits = sampled ? waits(idling_) : std::vector<Box>{};
  const std::vector<ComponentId> idle_restarted = restarted(idling_);
  const std::uint32_t idle_exits = tells_exits_ ? exits_in(modes, idling_) : 0;
  joint_steps_.set_out(modes, late, due, idling_);
  // Many control actions enable the same: what the components may do tells whether an action is worth a look, and a
  // step that two actions lead to is listed with the first.
  std::vector<BehaviourId>& rows = rows_;  // of one action after the other
  rows.clear();
  seen_rows_.clear();
  seen_steps_.clear();
  const std::size_t width = modes.size();
  const auto row = [&](std::size_t first) { return rows.cbegin() + static_cast<std::ptrdiff_t>(first); };
  const auto row_before = [&](std::size_t a, std::size_t b) {
    return std::lexicographical_compare(row(a), row(a + width), row(b), row(b + width));
  };
  const auto in_order = [](const JointStep& step) {
    return std::tie(step.target, step.faults, step.hold, step.bounds, step.restarted, step.exits);
  };
  for_each_action(plant(), commands_, [&](const ControlAction& action) {
    meter_.poll();
    if (may_idle) {
      behaviours_.read({modes, actions_.front(), idling_}, modes, action, behaviours_here_);
    } else {
      behaviours_.read(modes, action, behaviours_here_);
    }
    const std::size_t own = rows.size();
    rows.insert(rows.end(), behaviours_here_.begin(), behaviours_here_.end());
    const auto at = std::lower_bound(seen_rows_.begin(), seen_rows_.end(), own, row_before);
    if (at != seen_rows_.end() && !row_before(own, *at)) {
      rows.resize(own);
      return;
    }
    seen_rows_.insert(at, own);
    JointStep step{{}, 0, 0, false, {}, restarted(behaviours_here_), 0};
    step.exits = tells_exits_ ? exits_in(modes, behaviours_here_) : 0;
    const auto add = [&](const Modes& target, unsigned taken, bool hold, const Box& bounds) {
      step.target = number(target);
      step.faults = taken;
      step.hold = hold;
      step.bounds = bounds;
      const auto place = std::lower_bound(
          seen_steps_.begin(), seen_steps_.end(), step,
          [&](std::uint32_t known, const JointStep& one) { return in_order(result[known]) < in_order(one); });
      if (place != seen_steps_.end() && in_order(result[*place]) == in_order(step)) return;
      step.action = position_of(action);
      seen_steps_.insert(place, static_cast<std::uint32_t>(result.size()));
      result.push_back(step);
    };
    if (sampled) {
      for (const Box& box : waits(behaviours_here_)) {
        // What waiting under idle controls allows needs no command.
        const bool idle = std::count(idle_waits.begin(), idle_waits.end(), box) > 0;
        if (!idle || step.exits != idle_exits || step.restarted != idle_restarted) add(modes, 0, true, box);
      }
    }
    joint_steps_.enumerate(action, behaviours_here_,
                           [&](const Modes& next, unsigned taken, const Box& box) { add(next, taken, false, box); });
  });
  if (sampled) std::stable_partition(result.begin(), result.end(), [](const JointStep& m) { return m.hold; });
  return result;
}

bool Situations::leave_together(const Modes& modes, const Late& due, std::size_t first) {
  constexpr std::size_t most = 5;  // all subsets of the others are looked at
  if (due.size() > most) return false;
  behaviours_.read(modes, actions_.front(), behaviours_here_);
  std::vector<ModeId> into;
  for (const ComponentId c : due) {
    const Behaviour& behaviour = behaviours_[behaviours_here_[c.index()]];
    const auto leaves = [&](const Choice& choice) {
      return choice.faults == 0 && choice.mode != modes[c.index()] &&
             lasting(choice.clock, choice.sharp).contains(behaviour.stays_until);
    };
    const auto exit = std::find_if(behaviour.choices.begin(), behaviour.choices.end(), leaves);
    if (exit == behaviour.choices.end()) return false;
    into.push_back(exit->mode);
  }
  Modes next = modes;
  for (std::size_t chosen = 0; chosen < std::size_t{1} << due.size(); ++chosen) {
    if ((chosen >> first & 1) == 0) continue;
    for (std::size_t i = 0; i < due.size(); ++i) {
      next[due[i].index()] = (chosen >> i & 1) != 0 ? into[i] : modes[due[i].index()];
    }
    if (!step_.possible(next)) return false;
  }
  return true;
}

std::uint32_t Situations::exits_in(const Modes& modes, const std::vector<BehaviourId>& behaviours) {
  Exits result;
  std::vector<std::vector<Choice>> all;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    all.push_back(behaviours_[behaviours[c]].choices);
    add_enabled(result, all.back(), modes[c]);
  }
  for_each_joint(all, 0, [&](const JointChoice& joint) {
    meter_.poll();
    if (joint.modes != modes && step_.possible(joint.modes)) add_open(result, modes, joint.modes, joint.bounds, time());
  });
  const auto [at, fresh] = exits_positions_.try_emplace(std::move(result), static_cast<std::uint32_t>(exits_.size()));
  if (fresh) exits_.push_back(&at->first);
  return at->second;
}

const Exits& Situations::idle_exits(SituationId id) {
  const auto [at, fresh] = idle_exits_.try_emplace(id);
  if (fresh) {
    const Modes here = modes(id);
    std::vector<BehaviourId> behaviours;
    behaviours_.read(here, actions_.front(), behaviours);
    at->second = exits_in(here, behaviours);
  }
  return *exits_[at->second];
}

std::vector<Modes> Situations::initial(const std::vector<Assignment>& from) {
  std::vector<Modes> result;
  base::for_each_combination(initial_modes(plant(), from), [&](const Modes& modes) {
    meter_.poll();
    if (step_.possible(modes)) result.push_back(modes);
  });
  return result;
}

}  // namespace rmpl::verifier
