// The enabled transitions of each component, by the mode that they lead to.
// SPDX-License-Identifier: MIT
#include "runtime/executive/step/prospects.hpp"

#include <algorithm>
#include <map>

#include "automata/time/checked_ticks.hpp"

namespace rmpl::runtime {
namespace {

using automata::ComponentId;
using automata::ModeId;
using automata::Ticks;
using automata::TransitionId;

Ticks later(Ticks start, Ticks by) { return automata::checked_sum(start, by).value_or(Ticks::infinite()); }

class Looking {
 public:
  Looking(automata::PlantStep& step, const automata::SystemState& state, const automata::ControlAction& action,
          Ticks begin, Ticks end)
      : step_(step), plant_(step.plant()), state_(state), action_(action), begin_(begin), end_(end) {}

  std::vector<Prospect> run() {
    commands();
    // The references last until the next question.
    const automata::AllEnabled enabled = step_.enabled(state_.modes, action_);
    const std::vector<std::vector<automata::Move>> moves = step_.moves(state_, action_, begin_, end_);
    std::vector<Prospect> faults;
    for (std::size_t c = 0; c < plant_.components.size(); ++c) component(ComponentId(c), enabled[c], moves[c], faults);
    found_.insert(found_.end(), faults.begin(), faults.end());
    return std::move(found_);
  }

 private:
  void commands() {
    for (std::size_t i = 0; i < plant_.controls.size(); ++i) {
      const automata::VariableId variable = plant_.controls[i].variable;
      for (std::size_t v = 0; v < plant_.variables[variable].values.size(); ++v) {
        automata::ControlAction other = action_;
        other[i] = automata::ValueId(v);
        if (other[i] == action_[i] || !step_.permits(state_.modes, other)) continue;
        Prospect command;
        command.kind = Prospect::Kind::command;
        command.what = {variable, other[i]};
        command.lets = let_by(other);
        found_.push_back(std::move(command));
      }
    }
  }

  /// The nominal transitions that another action enables, and this one does not.
  std::vector<std::string> let_by(const automata::ControlAction& other) {
    const automata::AllEnabled now = step_.enabled(state_.modes, action_);
    const automata::AllEnabled then = step_.enabled(state_.modes, other);
    std::vector<std::string> texts;
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      const automata::Component& component = plant_.components[c];
      const auto add = [&](const std::vector<TransitionId>& before, const std::vector<TransitionId>& after) {
        for (const TransitionId id : after) {
          const automata::Transition& transition = component.transitions[id.index()];
          if (std::find(before.begin(), before.end(), id) != before.end()) continue;
          if (transition.from == transition.to && !transition.restart) continue;
          texts.push_back(component.name + ": " + component.modes[transition.from.index()].name + " -> " +
                          component.modes[transition.to.index()].name + (transition.restart ? " restart" : ""));
        }
      };
      add(now[c].untimed, then[c].untimed);
      add(now[c].timed, then[c].timed);
    }
    return texts;
  }

  void component(ComponentId id, const automata::Enabled& enabled, const std::vector<automata::Move>& moves,
                 std::vector<Prospect>& faults) {
    const automata::Component& component = plant_[id];
    const ModeId here = state_.modes[id.index()];
    std::map<std::size_t, Prospect> by_target;
    const auto add = [&](TransitionId transition_id) {
      const automata::Transition& transition = component.transitions[transition_id.index()];
      if (transition.to == here) return;
      const auto [at, fresh] = by_target.try_emplace(transition.to.index());
      Prospect& prospect = at->second;
      if (fresh) {
        prospect.kind = component.is_fault(transition) ? Prospect::Kind::fault : Prospect::Kind::transition;
        prospect.what = {component.mode, automata::ValueId(transition.to.index())};
        prospect.component = id;
        prospect.origin = transition.origin;
      }
      if (!transition.timing) return;
      const Ticks start = state_.clock_starts[id.index()];
      const Prospect::Window window{later(start, transition.timing->lower), later(start, transition.timing->upper)};
      if (!prospect.window || window.from < prospect.window->from) prospect.window = window;
    };
    for (const TransitionId t : enabled.untimed) add(t);
    for (const TransitionId t : enabled.timed) add(t);
    for (const TransitionId t : enabled.faults) add(t);
    double stays = 0;
    for (const automata::Move& move : moves) {
      if (move.mode == here) stays = move.probability;
      const auto at = by_target.find(move.mode.index());
      if (at != by_target.end()) at->second.probability = move.probability;
    }
    bool leaves = false;
    for (auto& [target, prospect] : by_target) {
      leaves = leaves || prospect.probability > 0;
      (prospect.kind == Prospect::Kind::fault ? faults : found_).push_back(prospect);
    }
    if (!leaves || stays <= 0) return;
    Prospect stay;
    stay.kind = Prospect::Kind::stay;
    stay.what = {component.mode, automata::ValueId(here.index())};
    stay.component = id;
    stay.probability = stays;
    // Where nothing but a fault can come, staying is what everybody expects.
    const bool nominal = std::any_of(by_target.begin(), by_target.end(), [](const auto& one) {
      return one.second.kind == Prospect::Kind::transition && one.second.probability > 0;
    });
    if (nominal) found_.push_back(std::move(stay));
  }

  automata::PlantStep& step_;
  const automata::Plant& plant_;
  const automata::SystemState& state_;
  const automata::ControlAction& action_;
  Ticks begin_, end_;
  std::vector<Prospect> found_;
};

}  // namespace

std::vector<Prospect> prospects(automata::PlantStep& step, const automata::SystemState& state,
                                const automata::ControlAction& action, automata::Ticks begin, automata::Ticks end) {
  return Looking(step, state, action, begin, end).run();
}

}  // namespace rmpl::runtime
