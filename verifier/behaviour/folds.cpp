// Timers that nothing asks for, represented by their clocks.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/folds.hpp"

#include <algorithm>
#include <utility>

#include "automata/step/transition_rules.hpp"
#include "automata/store/totality.hpp"
#include "base/check.hpp"
#include "verifier/behaviour/reasons.hpp"

namespace rmpl::verifier {

using automata::Component;
using automata::ComponentId;
using automata::ControlAction;
using automata::Enabled;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::Transition;

namespace {

/// Where nothing was folded in so many modes, nothing is: asking who is asked takes a good part of a step.
constexpr std::size_t enough_tried = 256;

/// Components that may be to blame where modes are impossible, or a command contradicts them.
std::vector<bool> constrained_components(automata::PlantStep& step) {
  std::vector<bool> result(step.plant().components.size(), false);
  for (const automata::Island& island : step.locality().islands()) {
    if (automata::is_total(step.plant(), island)) continue;
    for (const ComponentId c : island.support.components) result[c.index()] = true;
  }
  return result;
}

}  // namespace

Folds::Folds(automata::PlantStep& step, const TimeModel& time, Commands commands,
             const std::vector<ComponentId>& visible)
    : step_(step), time_(time), commands_(commands), table_(step.plant()) {
  const Plant& plant = step.plant();
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    auto& links = links_.emplace_back();
    auto& live = live_.emplace_back();
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
      live.push_back(plant.has_timed_exit(ComponentId(c), ModeId(m)));
      links.push_back(link_of(ComponentId(c), ModeId(m)));
    }
  }
  const auto has_a_link = [](const auto& links) {
    return std::any_of(links.begin(), links.end(), [](const auto& one) { return one.has_value(); });
  };
  if (std::none_of(links_.begin(), links_.end(), has_a_link)) return;
  const std::vector<bool> constrained = constrained_components(step);
  for (std::size_t c = 0; c < links_.size(); ++c) {
    const bool seen = constrained[c] || std::binary_search(visible.begin(), visible.end(), ComponentId(c));
    for (std::size_t m = 0; m < links_[c].size(); ++m) {
      if (seen || !ends_in_time(ComponentId(c), ModeId(m))) links_[c][m].reset();
    }
    // Of a chain that goes round, or ends in a choice, no mode is left.
    if (has_a_link(links_[c])) timers_.emplace_back(c);
  }
  if (timers_.empty()) return;
  for (std::size_t c = 0; c < links_.size(); ++c) {
    auto& reads = reads_.emplace_back();
    auto& looks = looks_.emplace_back();
    for (std::size_t m = 0; m < links_[c].size(); ++m) {
      const automata::Support& support = step.commanded_support(ComponentId(c), ModeId(m));
      auto& timers = reads.emplace_back();
      for (const ComponentId other : support.components) {
        if (is_timer(other) && other.index() != c) timers.push_back(other);
      }
      looks.push_back({{}, {plant, support}});
    }
  }
}

/// By the transitions out of the mode alone.
std::optional<Folds::Link> Folds::link_of(ComponentId id, ModeId mode) const {
  const Component& component = step_.plant()[id];
  std::optional<Link> result;
  for (const Transition& t : component.transitions) {
    if (t.from == mode && t.restart) return {};
    if (t.from != mode || !t.timing) continue;
    if (result || component.is_fault(t) || t.to == mode || !t.guard.is_true() || !can_ever_be_taken(t)) return {};
    if (t.timing->upper.is_infinite() || t.timing->lower != t.timing->upper || t.timing->upper.count <= 0) return {};
    const Units after = time_.at_least(t.timing->upper);
    result = {t.to, time_.is_dense() ? after : after - 1, after};
  }
  return result;
}

/// Whether a chain that begins in the mode comes to a mode without timed exits.
bool Folds::ends_in_time(ComponentId component, ModeId mode) const {
  for (std::size_t steps = 0; steps < links_[component.index()].size(); ++steps) {
    if (!live_[component.index()][mode.index()]) return true;
    if (!link(component, mode)) return false;
    mode = link(component, mode)->next;
  }
  return false;
}

bool Folds::is_timer(ComponentId component) const {
  return std::binary_search(timers_.begin(), timers_.end(), component);
}

std::optional<ClockLimits> Folds::limits(ComponentId component, ModeId mode) const {
  if (!link(component, mode)) return std::nullopt;
  Units all = 0;
  for (; link(component, mode); mode = link(component, mode)->next) all += link(component, mode)->after;
  return ClockLimits{all, all};
}

const std::vector<ComponentId>& Folds::in(const Modes& modes) {
  static const std::vector<ComponentId> none;
  const auto runs_here = [&](ComponentId timer) { return runs(timer, modes); };
  if (in_vain_ || std::none_of(timers_.begin(), timers_.end(), runs_here)) return none;
  if (modes == last_[1].modes) std::swap(last_[0], last_[1]);
  if (modes == last_[0].modes) return sets_[last_[0].set];
  const std::uint32_t position = table_.intern(modes);
  if (position == folded_.size()) {
    std::vector<ComponentId> folded = work_out(modes);
    const auto [at, fresh] = set_positions_.try_emplace(folded, static_cast<std::uint32_t>(sets_.size()));
    if (fresh) sets_.push_back(std::move(folded));
    folded_.push_back(at->second);
    in_vain_ = folded_.size() >= enough_tried && sets_.size() == 1 && sets_.front().empty();
  }
  std::swap(last_[0], last_[1]);
  last_[0] = {modes, folded_[position]};
  return sets_[last_[0].set];
}

std::vector<ComponentId> Folds::work_out(const Modes& modes) {
  std::vector<ComponentId> timers = timers_;
  std::erase_if(timers, [&](ComponentId timer) { return !runs(timer, modes); });
  const auto running = [&](ComponentId timer) { return runs(timer, modes); };
  std::vector<ComponentId> readers;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const auto& reads = reads_[c][modes[c].index()];
    const bool is_running = is_timer(ComponentId(c)) && runs(ComponentId(c), modes);
    if (!is_running && std::any_of(reads.begin(), reads.end(), running)) readers.emplace_back(c);
  }
  std::vector<bool> asked(modes.size(), false);
  bool contradicted = false;
  Modes varied = modes;
  for_each_action(step_.plant(), commands_, [&](const ControlAction& action) {
    if (contradicted) return;
    // What contradicts itself enables everything.
    contradicted = !step_.consistent(modes, action);
    if (contradicted) return;
    for (const ComponentId c : readers) {
      for (const ComponentId other : look(c, modes, action).mentioned) asked[other.index()] = true;
    }
    for (const ComponentId timer : timers) {
      if (!leaves_alike(timer, varied, action, asked)) asked[timer.index()] = true;
    }
  });
  if (contradicted) return {};
  std::erase_if(timers, [&](ComponentId timer) { return asked[timer.index()]; });
  return timers;
}

/// Whether the timer may leave the modes that are still to come in the same ways; who is asked for that.
bool Folds::leaves_alike(ComponentId timer, Modes& modes, const ControlAction& action, std::vector<bool>& asked) {
  const ModeId here = modes[timer.index()];
  const std::vector<Choice> exits = look(timer, modes, action).exits;
  bool alike = true;
  for (ModeId mode = here;; mode = link(timer, mode)->next) {
    modes[timer.index()] = mode;
    const Look& there = look(timer, modes, action);
    for (const ComponentId other : there.mentioned) asked[other.index()] = true;
    alike = alike && there.exits == exits && !there.exits.empty();
    if (!link(timer, mode)) break;
  }
  modes[timer.index()] = here;
  return alike;
}

const Folds::Look& Folds::look(ComponentId component, const Modes& modes, const ControlAction& action) {
  const std::size_t mode = modes[component.index()].index();
  Looks& known = looks_[component.index()][mode];
  if (const auto answer = known.decided.find(modes, action)) return known_looks_[*answer];
  return known_looks_[known.rest.find(modes, action,
                                      [&] { return look_anew(component, modes, action, known.decided); })];
}

std::uint32_t Folds::look_anew(ComponentId component, const Modes& modes, const ControlAction& action,
                               Decisions& decided) {
  const ModeId mode = modes[component.index()];
  std::vector<ComponentId> timers;
  for (const ComponentId c : reads_[component.index()][mode.index()]) {
    if (link(c, modes[c.index()])) timers.push_back(c);
  }
  Look look;
  auto why = reason(step_, component, modes, action, timers);
  if (!why) {
    why = reason(step_, component, modes, action);
    look.mentioned = timers;
    if (why) {
      std::erase_if(look.mentioned, [&](ComponentId c) {
        return std::none_of(why->begin(), why->end(), [&](const Premise& p) { return p.position == c.value; });
      });
    }
  }
  if (is_timer(component)) {
    const Component& automaton = step_.plant()[component];
    Enabled enabled = step_.enabled(component, modes, action);
    const bool loops = std::any_of(enabled.untimed.begin(), enabled.untimed.end(), [&](automata::TransitionId t) {
      return automaton.transitions[t.index()].to == mode;
    });
    // While an untimed transition to the mode itself is enabled, time does not end the mode: no exits are told.
    if (!loops) {
      if (link(component, mode)) enabled.timed.clear();
      look.exits = choices(automaton, mode, enabled, time_);
      for (Choice& choice : look.exits) {
        if (choice.mode == mode) choice.mode = stay;
      }
      std::sort(look.exits.begin(), look.exits.end());
    }
  }
  const auto [answer, fresh] = look_positions_.try_emplace(look, static_cast<std::uint32_t>(known_looks_.size()));
  if (fresh) known_looks_.push_back(std::move(look));
  if (why) decided.add(modes, action, *why, answer->second);
  return answer->second;
}

void Folds::unfold(const Modes& modes, std::size_t others, const Zone& zone, const std::vector<ComponentId>& open,
                   const Visit& visit) {
  const std::vector<ComponentId>& folded = in(modes);
  for (const ComponentId c : open) {
    const auto& here = link(c, modes[c.index()]);
    if (!here || std::binary_search(folded.begin(), folded.end(), c)) continue;
    const std::size_t clock = clock_of(c, modes, others);
    if (zone.upper(clock) < here->after) continue;
    if (Zone before = zone; before.constrain(clock, {0, here->last})) {
      std::vector<ComponentId> rest = open;
      std::erase(rest, c);
      unfold(modes, others, before, rest, visit);
    }
    if (Zone ended = zone; ended.constrain(clock, {here->after, unbounded})) {
      Modes next = modes;
      next[c.index()] = here->next;
      unfold(next, others, moved_on(ended, clock, here->after, live_[c.index()][here->next.index()]), open, visit);
    }
    return;
  }
  visit(modes, Zone(zone));
}

std::optional<ComponentId> Folds::asked_of(const Modes& there, const Modes& from, std::size_t others,
                                           const Zone& zone) {
  const std::vector<ComponentId>& folded_there = in(there);
  for (const ComponentId c : in(from)) {
    const ModeId mode = from[c.index()];
    if (there[c.index()] != mode || std::binary_search(folded_there.begin(), folded_there.end(), c)) continue;
    if (zone.upper(clock_of(c, from, others)) >= link(c, mode)->after) return c;
  }
  return std::nullopt;
}

void Folds::cut(const Modes& modes, std::size_t others, const Zone& zone, ComponentId component,
                const Visit& visit) const {
  const std::size_t clock = clock_of(component, modes, others);
  const auto& here = link(component, modes[component.index()]);
  CHECK(here);
  if (Zone before = zone; before.constrain(clock, {0, here->after - 1})) visit(modes, std::move(before));
  if (Zone ended = zone; ended.constrain(clock, {here->after, unbounded})) {
    Modes next = modes;
    next[component.index()] = here->next;
    visit(next, moved_on(ended, clock, here->after, live_[component.index()][here->next.index()]));
  }
}

std::size_t Folds::clock_of(ComponentId component, const Modes& modes, std::size_t others) const {
  std::size_t clock = others + 1;
  for (std::size_t c = 0; c < component.index(); ++c) clock += live_[c][modes[c].index()] ? 1 : 0;
  return clock;
}

Zone Folds::moved_on(const Zone& zone, std::size_t clock, Units by, bool goes_on) {
  const std::size_t n = zone.clocks() + 1;
  std::vector<Units> matrix;
  matrix.reserve(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (!goes_on && (i == clock || j == clock)) continue;
      Units bound = zone.bound(i, j);
      if (bound != unbounded && i == clock && j != clock) bound -= by;
      if (bound != unbounded && j == clock && i != clock) bound += by;
      matrix.push_back(bound);
    }
  }
  return Zone::of_matrix(std::move(matrix), n - (goes_on ? 1 : 2));
}

}  // namespace rmpl::verifier
