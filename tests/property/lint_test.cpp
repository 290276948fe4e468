// What lint finds in plants, against enumeration of all modes and commands: nothing refuted, and nothing missed.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "automata/clock_use.hpp"
#include "automata/dependencies/dependencies.hpp"
#include "automata/step/plain_step.hpp"
#include "compiler/lint/plant/alike.hpp"
#include "compiler/lint/plant/findings.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/lint.hpp"
#include "tests/reference/models.hpp"
#include "tests/reference/reachability.hpp"

namespace rmpl::property {
namespace {

using automata::ComponentId;
using automata::Formula;
using automata::ModeId;
using automata::Plant;
using automata::Transition;
using compiler::PlantAnalysis;
using reference::PlantLint;
using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

/// Two components that may be in some mode each only together, so that they have to enter it together.
void couple(Plant& plant) {
  const automata::Component& first = plant.components.front();
  const automata::Component& last = plant.components.back();
  const auto in = [](const automata::Component& component) {
    return automata::is(component.mode, automata::ValueId(up_to(0, component.modes.size() - 1)));
  };
  plant.interconnections.emplace_back(equivalence(in(first), in(last)));
}

/// Small plants of all kinds: with open readings, with guards on other components, with modes that exclude each other,
/// or only come together.
Model any_plant() {
  Shape shape;
  shape.open = *rc::gen::arbitrary<bool>();
  shape.tangled = *rc::gen::arbitrary<bool>();
  shape.max_components = 2 + *rc::gen::inRange<std::size_t>(0, 2);
  const Model model = *models(shape);
  if (!chance(40)) return model;
  Model coupled = model;
  couple(coupled.plant);
  return PlantLint(coupled.plant).initial().empty() ? model : coupled;
}

Pairs of_modes(const std::vector<compiler::PlantMode>& found) {
  Pairs result;
  for (const compiler::PlantMode& mode : found) result.emplace(mode.component.index(), mode.mode.index());
  return result;
}

template <class Has>
Pairs modes_where(const Plant& plant, const Has& has) {
  Pairs result;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
      if (has(std::pair(c, m))) result.emplace(c, m);
    }
  }
  return result;
}

Pairs of_transitions(const std::vector<compiler::PlantTransition>& found) {
  Pairs result;
  for (const compiler::PlantTransition& t : found) result.emplace(t.component.index(), t.transition.index());
  return result;
}

RC_GTEST_PROP(PlantLint, ModesAreThoseOfTheEnumeration, ()) {
  const Model model = any_plant();
  const PlantAnalysis analysis(model.plant);
  const PlantLint slow(model.plant);
  RC_ASSERT(of_modes(find_impossible_modes(analysis)) ==
            modes_where(model.plant, [&](const auto& mode) { return !slow.possible().contains(mode); }));
  RC_ASSERT(of_modes(find_unreachable_modes(analysis)) == modes_where(model.plant, [&](const auto& mode) {
              return slow.possible().contains(mode) && !slow.reached().contains(mode);
            }));
  RC_ASSERT(of_modes(find_impossible_initial_modes(analysis)) == modes_where(model.plant, [&](const auto& mode) {
              return model.plant.components[mode.first].initial[mode.second] > 0 && slow.possible().contains(mode) &&
                     !slow.initial().contains(mode);
            }));
}

/// Whether no command contradicts any modes that are possible: such a command enables every guard (semantics 3), and
/// lint leaves it out.
bool commands_contradict_nothing(const Plant& plant) {
  const reference::Models models(plant);
  std::vector<std::size_t> modes, values;
  for (const automata::Component& component : plant.components) modes.push_back(component.modes.size());
  for (const automata::Control& control : plant.controls) {
    values.push_back(plant.variables[control.variable].values.size());
  }
  for (const auto& of_components : reference::tuples(modes)) {
    automata::Modes all;
    for (const std::size_t m : of_components) all.emplace_back(m);
    if (!models.consistent(reference::assumptions_of(plant, all))) continue;
    for (const auto& of_controls : reference::tuples(values)) {
      automata::ControlAction action;
      for (const std::size_t v : of_controls) action.emplace_back(v);
      if (!models.consistent(reference::assumptions_of(plant, all, action))) return false;
    }
  }
  return true;
}

/// What really happens, by the semantics: steps of a second, everything may fail, any commands.
RC_GTEST_PROP(PlantLint, WhatIsReachedIsNotCalledNeverEntered, ()) {
  const Model model = any_plant();
  RC_PRE(commands_contradict_nothing(model.plant));
  const PlantAnalysis analysis(model.plant);
  const reference::Step step(model.plant);
  for (const compiler::PlantMode& mode : find_unreachable_modes(analysis)) {
    reference::Question question;
    question.target = automata::is(model.plant[mode.component].mode, automata::ValueId(mode.mode.index()));
    question.faults = 8;
    question.commands = reference::Question::Commands::any;
    RC_ASSERT(!reference::fewest_steps_sampled(step, question, automata::Ticks::of_seconds(1)));
  }
}

RC_GTEST_PROP(PlantLint, GuardsThatNeverHoldAreThoseOfTheEnumeration, ()) {
  const Model model = any_plant();
  const PlantLint slow(model.plant);
  Pairs expected;
  for (std::size_t c = 0; c < model.plant.components.size(); ++c) {
    const auto& transitions = model.plant.components[c].transitions;
    for (std::size_t t = 0; t < transitions.size(); ++t) {
      const bool weightless =
          transitions[t].weight.kind != automata::Weight::Kind::none && transitions[t].weight.value <= 0;
      if (weightless || !slow.reached().contains({c, transitions[t].from.index()})) continue;
      if (!slow.enabled().contains({c, t})) expected.emplace(c, t);
    }
  }
  RC_ASSERT(of_transitions(find_impossible_guards(PlantAnalysis(model.plant))) == expected);
}

RC_GTEST_PROP(PlantLint, OverlapsAreThoseOfTheEnumeration, ()) {
  const Model model = any_plant();
  PlantAnalysis analysis(model.plant);
  const PlantLint slow(model.plant);
  std::set<std::tuple<std::size_t, std::size_t, std::size_t>> found, expected;
  for (const compiler::Overlap& overlap : find_overlapping_guards(analysis)) {
    found.emplace(overlap.component.index(), overlap.first.index(), overlap.second.index());
  }
  for (std::size_t c = 0; c < model.plant.components.size(); ++c) {
    const automata::Component& component = model.plant.components[c];
    const auto counts = [&](const Transition& t) {
      return !component.is_fault(t) && !t.timing && t.weight.kind == automata::Weight::Kind::none;
    };
    for (std::size_t a = 0; a < component.transitions.size(); ++a) {
      for (std::size_t b = a + 1; b < component.transitions.size(); ++b) {
        const Transition& first = component.transitions[a];
        const Transition& second = component.transitions[b];
        if (!counts(first) || !counts(second) || first.from != second.from || first.to == second.to) continue;
        if (slow.together(c, a, b)) expected.emplace(c, a, b);
      }
    }
  }
  RC_ASSERT(found == expected);
}

RC_GTEST_PROP(PlantLint, WhatIsShadowedIsNeverTaken, ()) {
  const Model model = any_plant();
  PlantAnalysis analysis(model.plant);
  const PlantLint slow(model.plant);
  for (const compiler::Shadow& shadow : find_shadowed_transitions(analysis)) {
    std::vector<std::size_t> by;
    for (const automata::TransitionId early : shadow.by) by.push_back(early.index());
    RC_ASSERT(slow.always_with(shadow.component.index(), shadow.transition.index(), by));
  }
}

/// A component may then stay where it is by a transition, too.
void add_own_mode_transition(Plant& plant) {
  automata::Component& component = plant.components[up_to(0, plant.components.size() - 1)];
  if (component.transitions.empty()) return;
  Transition own = component.transitions[up_to(0, component.transitions.size() - 1)];
  if (chance(50)) own.guard = component.transitions[up_to(0, component.transitions.size() - 1)].guard;
  if (chance(50)) own.timing.reset();
  own.to = own.from;
  own.weight = {};
  own.branch = 0;
  for (const Transition& other : component.transitions) own.branch = std::max(own.branch, other.branch + 1);
  component.transitions.push_back(own);
}

/// Nominal transitions that can happen, of which `holds`.
template <class Holds>
Pairs nominal_where(const Plant& plant, const PlantAnalysis& analysis, const Holds& holds) {
  Pairs result;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const automata::Component& component = plant.components[c];
    for (std::size_t t = 0; t < component.transitions.size(); ++t) {
      const Transition& own = component.transitions[t];
      if (component.is_fault(own) || !analysis.can_happen({ComponentId(c), automata::TransitionId(t)})) continue;
      if (holds(c, t, own)) result.emplace(c, t);
    }
  }
  return result;
}

/// Whether in some situation a nominal transition elsewhere, which `counts`, is enabled with one.
template <class Counts>
bool is_beside(const Plant& plant, const PlantAnalysis& analysis, const PlantLint& slow, std::size_t c, std::size_t t,
               const Counts& counts) {
  const automata::Component& component = plant.components[c];
  const Transition& own = component.transitions[t];
  for (std::size_t o = 0; o < component.transitions.size(); ++o) {
    const Transition& other = component.transitions[o];
    const bool elsewhere = other.from == own.from && other.to != own.to && !component.is_fault(other) && counts(other);
    const bool happens = analysis.can_happen({ComponentId(c), automata::TransitionId(o)});
    if (elsewhere && happens && slow.together(c, t, o)) return true;
  }
  return false;
}

/// Whether two plants may do the same in a second from every state, with all clocks at one of some readings.
bool move_alike(const Plant& a, const Plant& b, const PlantLint& slow) {
  automata::PlainStep first(a), second(b);
  for (const auto& [modes, action] : slow.situations()) {
    const automata::SystemState state{modes, std::vector<automata::Ticks>(modes.size())};
    for (const std::int64_t seconds : {1, 2, 5, 30}) {
      const automata::Ticks clock{seconds * automata::Ticks::per_second};
      const automata::Ticks before = clock - automata::Ticks{automata::Ticks::per_second};
      const auto ones = first.moves(state, action, before, clock);
      const auto others = second.moves(state, action, before, clock);
      for (std::size_t c = 0; c < ones.size(); ++c) {
        const bool same = std::equal(ones[c].begin(), ones[c].end(), others[c].begin(), others[c].end(),
                                     [](const automata::Move& x, const automata::Move& y) {
                                       return x.mode == y.mode && std::abs(x.probability - y.probability) < 1e-12;
                                     });
        if (!same) return false;
      }
    }
  }
  return true;
}

RC_GTEST_PROP(PlantLint, IdleTransitionsAreThoseThatNothingElseGoesWith, ()) {
  Model model = any_plant();
  add_own_mode_transition(model.plant);
  PlantAnalysis analysis(model.plant);
  const PlantLint slow(model.plant);
  const Pairs found = of_transitions(find_idle_transitions(analysis));
  RC_ASSERT(found == nominal_where(model.plant, analysis, [&](std::size_t c, std::size_t t, const Transition& own) {
              const auto counts = [&](const Transition& other) { return other.timing || !own.timing; };
              if (own.restart && automata::needs_clock(model.plant.components[c], own.from)) return false;
              return own.from == own.to && !is_beside(model.plant, analysis, slow, c, t, counts);
            }));
  if (found.empty()) return;
  Model without = model;
  const auto [c, t] = *found.begin();
  auto& transitions = without.plant.components[c].transitions;
  transitions.erase(transitions.begin() + static_cast<std::ptrdiff_t>(t));
  RC_ASSERT(move_alike(model.plant, without.plant, slow));
}

/// How many transitions out of one mode are outcomes of one.
std::ptrdiff_t outcomes(const automata::Component& component, const Transition& own) {
  return std::count_if(component.transitions.begin(), component.transitions.end(),
                       [&](const Transition& other) { return other.branch == own.branch && other.from == own.from; });
}

RC_GTEST_PROP(PlantLint, UnusedWeightsAreThoseThatShareWithNothing, ()) {
  Model model = any_plant();
  for (automata::Component& component : model.plant.components) {
    for (Transition& transition : component.transitions) {
      if (outcomes(component, transition) == 1 && !component.is_fault(transition) && chance(30)) {
        transition.weight = {automata::Weight::Kind::probability, 0.5};
      }
    }
  }
  PlantAnalysis analysis(model.plant);
  const PlantLint slow(model.plant);
  const Pairs found = of_transitions(find_unused_weights(analysis));
  RC_ASSERT(found == nominal_where(model.plant, analysis, [&](std::size_t c, std::size_t t, const Transition& own) {
              const bool weighted = own.weight.kind != automata::Weight::Kind::none && own.weight.value < 1;
              const auto counts = [&](const Transition& other) { return !other.timing; };
              return weighted && outcomes(model.plant.components[c], own) == 1 &&
                     (own.timing || !is_beside(model.plant, analysis, slow, c, t, counts));
            }));
  if (found.empty()) return;
  Model without = model;
  for (const auto& [c, t] : found) without.plant.components[c].transitions[t].weight = {};
  RC_ASSERT(move_alike(model.plant, without.plant, slow));
}

/// Two more untimed transitions out of a mode, of which one waits for a command, or the other for idle controls.
void share_with_a_command(const Plant& plant, automata::Component& component) {
  std::vector<automata::ModeId> nominal;
  for (std::size_t m = 0; m < component.modes.size(); ++m) {
    if (!component.modes[m].fault) nominal.emplace_back(m);
  }
  if (nominal.size() < 2) return;
  const automata::Control& control = pick(plant.controls);
  const automata::ValueId value(up_to(0, plant.variables[control.variable].values.size() - 1));
  std::uint32_t branch = 0;
  for (const Transition& transition : component.transitions) branch = std::max(branch, transition.branch + 1);
  Transition weighted;
  weighted.from = pick(nominal);
  weighted.to = pick(nominal);
  weighted.guard = chance(70) ? automata::constant(true) : automata::is(control.variable, control.idle);
  weighted.branch = branch;
  Transition commanded = weighted;
  commanded.to = pick(nominal);
  commanded.guard = automata::is(control.variable, value);
  commanded.branch = branch + 1;
  weighted.weight = {automata::Weight::Kind::probability, 0.5};
  component.transitions.push_back(weighted);
  component.transitions.push_back(commanded);
}

/// A weight is unused at rest where its transition shares with others under some commands, and never while all controls
/// are idle.
RC_GTEST_PROP(PlantLint, WeightsUnusedAtRestShareWithNothingThere, ()) {
  Model model = any_plant();
  for (automata::Component& component : model.plant.components) {
    if (!model.plant.controls.empty() && chance(70)) share_with_a_command(model.plant, component);
  }
  for (automata::Component& component : model.plant.components) {
    for (Transition& transition : component.transitions) {
      if (outcomes(component, transition) == 1 && !component.is_fault(transition) && chance(50)) {
        transition.weight = {automata::Weight::Kind::probability, 0.5};
      }
    }
  }
  PlantAnalysis analysis(model.plant);
  const PlantLint slow(model.plant);
  const Pairs found = of_transitions(find_weights_unused_at_rest(analysis));
  const Pairs always = of_transitions(find_unused_weights(analysis));
  const automata::ControlAction idle = automata::idle_action(model.plant);
  automata::PlainStep step(model.plant);
  const Pairs expected = nominal_where(model.plant, analysis, [&](std::size_t c, std::size_t t, const Transition& own) {
    const automata::Component& component = model.plant.components[c];
    if (own.weight.kind == automata::Weight::Kind::none || own.weight.value >= 1 || own.timing) return false;
    if (outcomes(component, own) != 1 || always.contains({c, t})) return false;
    bool enabled = false, alone = true;
    for (const auto& [modes, action] : slow.situations()) {
      if (action != idle || modes[c] != own.from) continue;
      const std::vector<automata::TransitionId> untimed = step.enabled(modes, action)[c].untimed;
      const automata::TransitionId id(t);
      if (std::find(untimed.begin(), untimed.end(), id) == untimed.end()) continue;
      enabled = true;
      for (const automata::TransitionId other : untimed)
        alone = alone && component.transitions[other.index()].to == own.to;
    }
    return enabled && alone;
  });
  RC_ASSERT(found == expected);
  RC_CLASSIFY(!found.empty());
}

/// Whether the guard of a transition can hold in no situation that `counts`.
template <class Counts>
bool never_holds(const PlantLint& slow, const reference::Models& models, const Plant& plant, const Formula& guard,
                 const Counts& counts) {
  const auto situations = slow.situations();
  return std::none_of(situations.begin(), situations.end(), [&](const auto& situation) {
    const auto& [modes, action] = situation;
    return counts(modes, action) && models.allows(reference::assumptions_of(plant, modes, action), guard);
  });
}

RC_GTEST_PROP(PlantLint, LateGuardsNeverHoldWhereTheirModeIsEntered, ()) {
  const Model model = any_plant();
  const Plant& plant = model.plant;
  PlantAnalysis analysis(plant);
  const PlantLint slow(plant);
  const reference::Models models(plant);
  const Pairs found = of_transitions(find_late_guards(analysis));
  RC_TAG(found.empty() ? "none" : "some");
  RC_ASSERT(found == nominal_where(plant, analysis, [&](std::size_t c, std::size_t, const Transition& own) {
              const automata::Support support = analysis.locality().support_of(own.guard);
              const bool bounded = own.timing && !own.timing->upper.is_infinite() && own.timing->upper.count > 0;
              if (!bounded || own.guard.is_true() || own.from == own.to || support.reads(ComponentId(c))) return false;
              if (!support.controls.empty()) {
                const auto idle = [&](const automata::Modes& modes, const automata::ControlAction& action) {
                  return modes[c] == own.from &&
                         std::all_of(support.controls.begin(), support.controls.end(),
                                     [&](std::size_t u) { return action[u] == plant.controls[u].idle; });
                };
                return !never_holds(slow, models, plant, automata::constant(true), idle) &&
                       never_holds(slow, models, plant, own.guard, idle);
              }
              const auto starts = [&](const automata::Modes& modes, const automata::ControlAction&) {
                return modes[c] == own.from && slow.initial().contains({c, own.from.index()}) &&
                       std::all_of(support.components.begin(), support.components.end(), [&](ComponentId read) {
                         return slow.initial().contains({read.index(), modes[read.index()].index()});
                       });
              };
              if (!never_holds(slow, models, plant, own.guard, starts)) return false;
              const auto& ways = plant.components[c].transitions;
              for (std::size_t w = 0; w < ways.size(); ++w) {
                if (ways[w].to != own.from || ways[w].from == own.from) continue;
                if (!analysis.can_happen({ComponentId(c), automata::TransitionId(w)})) continue;
                const auto before = [&](const automata::Modes& modes, const automata::ControlAction&) {
                  return modes[c] == ways[w].from;
                };
                if (!never_holds(slow, models, plant, automata::conjunction({ways[w].guard, own.guard}), before))
                  return false;
              }
              return true;
            }));
}

RC_GTEST_PROP(PlantLint, WhatNothingCommandedContradictsIsInNoSituation, ()) {
  const Model model = any_plant();
  PlantAnalysis analysis(model.plant);
  const PlantLint slow(model.plant);
  const automata::ControlAction idle = automata::idle_action(model.plant);
  Pairs found, some, quiet;
  for (const compiler::IdleContradiction& one : find_idle_contradictions(analysis)) {
    found.emplace(one.mode.component.index(), one.mode.mode.index());
    RC_ASSERT(!one.idle.empty());
  }
  const automata::Classes parts = automata::Dependencies(model.plant).parts();
  for (const auto& [modes, action] : slow.situations()) {
    for (std::size_t c = 0; c < modes.size(); ++c) {
      some.emplace(c, modes[c].index());
      bool is_quiet = true;
      for (std::size_t i = 0; i < action.size(); ++i) {
        const bool same = parts[model.plant.controls[i].variable] == parts[model.plant.components[c].mode];
        is_quiet = is_quiet && (action[i] == idle[i] || !same);
      }
      if (is_quiet) quiet.emplace(c, modes[c].index());
    }
  }
  Pairs expected;
  std::set_difference(some.begin(), some.end(), quiet.begin(), quiet.end(), std::inserter(expected, expected.end()));
  RC_ASSERT(found == expected);
}

RC_GTEST_PROP(PlantLint, CommandsHaveTheEffectThatIsSaid, ()) {
  const Model model = any_plant();
  PlantAnalysis analysis(model.plant);
  const PlantLint slow(model.plant);
  std::set<automata::Assignment> impossible;
  for (const automata::Assignment& command : find_impossible_commands(analysis)) impossible.insert(command);
  for (std::size_t i = 0; i < model.plant.controls.size(); ++i) {
    const automata::VariableId variable = model.plant.controls[i].variable;
    for (std::size_t v = 0; v < model.plant.variables[variable].values.size(); ++v) {
      const automata::Assignment command{variable, automata::ValueId(v)};
      RC_ASSERT(impossible.contains(command) == !slow.allows(command));
    }
    for (const automata::Assignment& command : find_unread_commands(analysis)) {
      if (command.variable == variable) RC_ASSERT(slow.is_idle(i, command.value));
    }
  }
  for (const ComponentId component : find_uncommanded_components(analysis)) {
    RC_ASSERT(slow.is_independent(component.index()));
  }
}

RC_GTEST_PROP(PlantLint, ModesThatLookAlikeAreThoseOfTheEnumeration, ()) {
  const Model model = any_plant();
  PlantAnalysis analysis(model.plant);
  const PlantLint slow(model.plant);
  for (std::size_t c = 0; c < model.plant.components.size(); ++c) {
    compiler::AlikeQuestions questions(analysis, ComponentId(c));
    const std::size_t modes = model.plant.components[c].modes.size();
    for (std::size_t a = 0; a < modes; ++a) {
      for (std::size_t b = a + 1; b < modes; ++b) {
        if (!analysis.reach().reached[c][a] || !analysis.reach().reached[c][b]) continue;
        const std::optional<bool> alike = questions.look_alike(ModeId(a), ModeId(b));
        if (alike) RC_ASSERT(*alike == slow.look_alike(c, a, b));
        if (questions.mean_alike(ModeId(a), ModeId(b))) RC_ASSERT(slow.mean_alike(c, a, b));
        const std::optional<bool> together = questions.go_with_the_same(ModeId(a), ModeId(b));
        if (together) RC_ASSERT(*together == slow.go_with_the_same(c, a, b));
      }
    }
  }
}

RC_GTEST_PROP(PlantLint, StuckStatesLeadNowhere, ()) {
  const Model model = any_plant();
  const PlantLint slow(model.plant);
  const reference::Models store(model.plant);
  for (const compiler::StuckState& stuck : compiler::find_stuck_states(model.plant)) {
    std::vector<automata::Assignment> now, next;
    for (std::size_t i = 0; i < stuck.components.size(); ++i) {
      const automata::VariableId mode = model.plant[stuck.components[i]].mode;
      now.push_back({mode, automata::ValueId(stuck.modes[i].index())});
      next.push_back({mode, automata::ValueId(stuck.next[i].index())});
      RC_ASSERT(slow.reached().contains({stuck.components[i].index(), stuck.modes[i].index()}));
    }
    RC_ASSERT(store.consistent(now));
    RC_ASSERT(!store.consistent(next));
  }
}

}  // namespace
}  // namespace rmpl::property
