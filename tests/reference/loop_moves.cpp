// What the components of a closed loop may do.
// SPDX-License-Identifier: MIT
#include "tests/reference/loop_moves.hpp"

#include <algorithm>
#include <cmath>

namespace rmpl::reference {

using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::Ticks;
using automata::Transition;

LoopMoves::LoopMoves(const Step& step, std::optional<Ticks> period, Ticks unit)
    : step_(step), plant_(step.plant()), period_(period), unit_(unit) {
  const auto widen = [&](Ticks bound) {
    if (!bound.is_infinite()) cap_ = std::max(cap_, bound);
  };
  for (const automata::Component& component : plant_.components)
    for (const Transition& t : component.transitions)
      if (t.timing) {
        widen(t.timing->lower);
        widen(t.timing->upper);
      }
  widen(Ticks::of_seconds(3));  // the greatest constant of a random program
  cap_ += unit_ + unit_;
}

std::vector<std::pair<ModeId, bool>> LoopMoves::choices(const Modes& modes, std::size_t component,
                                                        const ControlAction& action, Ticks from, Ticks to) {
  const automata::Component& automaton = plant_.components[component];
  std::vector<std::pair<ModeId, bool>> result;
  std::vector<const Transition*> untimed, timed;
  double faulty = 0;
  for (const Transition* t : enabled(modes, component, action)) {
    if (automaton.is_fault(*t)) {
      if (t->weight.value <= 0 || (t->timing && (to < t->timing->lower || to > t->timing->upper))) continue;
      result.emplace_back(t->to, t->to != modes[component]);
      const bool rate = t->weight.kind == automata::Weight::Kind::rate;
      const double step = period_ ? period_->seconds() : 0;
      faulty += rate ? 1 - std::exp(-t->weight.value * step) : t->weight.value;
    } else if (t->timing) {
      timed.push_back(t);
    } else if (t->weight.kind == automata::Weight::Kind::none || t->weight.value > 0) {
      untimed.push_back(t);
    }
  }
  if (faulty >= 1) return result;
  for (const Transition* t : untimed) result.emplace_back(t->to, false);
  if (!untimed.empty()) return result;
  const bool certain = std::any_of(timed.begin(), timed.end(), [&](const Transition* t) {
    return period_ ? to >= t->timing->upper : to > t->timing->upper;
  });
  for (const Transition* t : timed) {
    const bool possible = certain   ? to >= t->timing->upper
                          : period_ ? from < t->timing->upper && t->timing->lower < to
                                    : to >= t->timing->lower;
    if (possible) result.emplace_back(t->to, false);
  }
  if (!certain) result.emplace_back(modes[component], false);
  return result;
}

int LoopMoves::lasts(const Modes& modes, std::size_t component, const ControlAction& action, Ticks clock, ModeId to) {
  if (period_) return 2;
  const auto can_be_taken = [&](std::size_t c, const Transition& t) {
    const bool weightless = t.weight.kind != automata::Weight::Kind::none && t.weight.value <= 0;
    return !plant_.components[c].is_fault(t) && !weightless;
  };
  bool rests = true;
  for (std::size_t c = 0; c < modes.size(); ++c)
    for (const Transition* t : enabled(modes, c, action))
      rests = rests && !(can_be_taken(c, *t) && !t->timing && t->to != modes[c]);
  bool due = false;
  for (const Transition* t : enabled(modes, component, action)) {
    if (!can_be_taken(component, *t)) continue;
    if (!t->timing) return 2;
    due = due || clock >= t->timing->upper;
  }
  int best = to == modes[component] && !due ? 2 : 0;
  for (const Transition* t : enabled(modes, component, action)) {
    if (!can_be_taken(component, *t) || t->to != to || clock < t->timing->lower) continue;
    if (due && clock < t->timing->upper) continue;
    const bool met = !due && Ticks{0} < clock && clock == t->timing->lower && rests;
    best = std::max(best, met ? 1 : 2);
  }
  return best;
}

std::vector<const Transition*> LoopMoves::enabled(const Modes& modes, std::size_t component,
                                                  const ControlAction& action) {
  const auto [at, fresh] = enabled_.try_emplace({modes, component, action});
  if (fresh)
    for (const Transition& t : plant_.components[component].transitions)
      if (t.from == modes[component] && step_.enabled(t, modes, action)) at->second.push_back(&t);
  return at->second;
}

std::set<ModeId> LoopMoves::nominal(const Modes& modes, std::size_t component, const ControlAction& action, bool late) {
  std::set<ModeId> result;
  const Ticks first = period_ ? unit_ : Ticks{0};
  for (Ticks to = late ? cap_ : first; to <= cap_; to += unit_)
    for (const auto& [mode, fault] : choices(modes, component, action, period_ ? to - unit_ : to, to))
      if (!fault) result.insert(mode);
  return result;
}

const Exits& LoopMoves::exits(const Modes& modes, const ControlAction& action) {
  const auto [at, fresh] = exits_.try_emplace({modes, action});
  Exits& found = at->second;
  if (!fresh) return found;
  std::vector<std::vector<ModeId>> some;
  std::vector<std::size_t> sizes;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    found.enabled.push_back(nominal(modes, c, action, true));
    found.enabled.back().erase(modes[c]);
    found.open.emplace_back();
    const auto own = nominal(modes, c, action, false);
    some.emplace_back(own.begin(), own.end());
    sizes.push_back(own.size());
  }
  for (const auto& tuple : tuples(sizes)) {
    Modes next;
    for (std::size_t c = 0; c < tuple.size(); ++c) next.push_back(some[c][tuple[c]]);
    if (!step_.possible(next)) continue;
    for (std::size_t c = 0; c < next.size(); ++c)
      if (found.enabled[c].contains(next[c])) found.open[c].insert(next[c]);
  }
  return found;
}

bool LoopMoves::idle_leads(const Modes& modes, std::size_t component, ModeId to) {
  const ControlAction idle = automata::idle_action(plant_);
  if (!step_.models().consistent(assumptions_of(plant_, modes, idle))) return false;
  const auto& transitions = plant_.components[component].transitions;
  return std::any_of(transitions.begin(), transitions.end(), [&](const Transition& t) {
    const bool possible = t.weight.kind == automata::Weight::Kind::none || t.weight.value > 0;
    return t.from == modes[component] && t.to == to && possible && step_.enabled(t, modes, idle);
  });
}

}  // namespace rmpl::reference
