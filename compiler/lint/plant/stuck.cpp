// Finding: states from which nothing can follow.
//
// A search through the states of one part of the plant, that has nothing to do with the others, as semantics 7 has them
// in sampled time: cycles of the greatest duration that divides all time bounds, commands free, no faults. What it
// finds can happen; parts with too many states are left out.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "automata/step/plant_step.hpp"
#include "automata/store/totality.hpp"
#include "base/product.hpp"
#include "compiler/lint/plant/findings.hpp"
#include "compiler/lint/plant/part.hpp"

namespace rmpl::compiler {

using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::Move;
using automata::Plant;
using automata::Ticks;
using automata::ValueId;

namespace {

/// States of a part, and joint steps out of one, up to which it is searched.
constexpr std::size_t state_limit = 2000;
constexpr std::size_t step_limit = 256;
/// Joint steps that are looked at in all parts together.
constexpr std::size_t work_limit = 100'000;

/// The bounds above 0 of the nominal transitions of a plant that are not infinite.
std::vector<Ticks> bounds_of(const automata::Component& component) {
  std::vector<Ticks> result;
  for (const automata::Transition& t : component.transitions) {
    if (!t.timing || component.is_fault(t)) continue;
    for (const Ticks bound : {t.timing->lower, t.timing->upper}) {
      if (!bound.is_infinite() && bound.count > 0) result.push_back(bound);
    }
  }
  return result;
}

Ticks period_of(const Plant& plant) {
  Ticks period{0};
  for (const automata::Component& component : plant.components) {
    for (const Ticks bound : bounds_of(component)) period.count = std::gcd(period.count, bound.count);
  }
  return period.count == 0 ? Ticks::of_seconds(1) : period;
}

/// All idle, then each control at each of its other values.
std::vector<ControlAction> single_commands(const Plant& plant) {
  const ControlAction idle = automata::idle_action(plant);
  std::vector<ControlAction> result{idle};
  for (std::size_t i = 0; i < plant.controls.size(); ++i) {
    for (std::size_t v = 0; v < plant.variables[plant.controls[i].variable].values.size(); ++v) {
      if (ValueId(v) == plant.controls[i].idle) continue;
      result.push_back(idle);
      result.back()[i] = ValueId(v);
    }
  }
  return result;
}

class StuckSearch {
 public:
  StuckSearch(const Plant& plant, std::size_t& work)
      : plant_(plant), step_(plant), period_(period_of(plant)), commands_(single_commands(plant)), work_(work) {
    for (const automata::Component& component : plant.components) {
      const std::vector<Ticks> bounds = bounds_of(component);
      oldest_.push_back(bounds.empty() ? Ticks{0} : *std::max_element(bounds.begin(), bounds.end()) + period_);
    }
  }

  std::optional<StuckState> run() {
    std::vector<std::vector<ModeId>> initial;
    for (const std::vector<Move>& moves : step_.initial_moves()) initial.push_back(targets(moves));
    if (!few(initial)) return std::nullopt;
    base::for_each_combination(initial, [&](const Modes& modes) {
      if (step_.possible(modes)) add({modes, std::vector<Ticks>(modes.size())}, nothing);
    });
    for (std::size_t next = 0; next < states_.size(); ++next) {
      const std::optional<bool> left = leave(next);
      if (!left) return std::nullopt;
      if (!*left) return story(next);
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t nothing = static_cast<std::size_t>(-1);
  /// Modes, and how long the components have been in them: up to where it makes no difference any more.
  struct State {
    Modes modes;
    std::vector<Ticks> ages;
    auto operator<=>(const State&) const = default;
  };

  static std::vector<ModeId> targets(const std::vector<Move>& moves) {
    std::vector<ModeId> result;
    result.reserve(moves.size());
    for (const Move& move : moves) result.push_back(move.mode);
    return result;
  }

  static bool few(const std::vector<std::vector<ModeId>>& choices) {
    std::size_t product = 1;
    for (const auto& choice : choices) {
      product *= choice.size();
      if (product > step_limit) return false;
    }
    return true;
  }

  void add(State state, std::size_t from) {
    if (!known_.insert(state).second) return;
    states_.push_back(std::move(state));
    from_.push_back(from);
  }

  /// Whether some command leads on from a state; what it leads to is added. Nothing where there is too much to look at.
  std::optional<bool> leave(std::size_t number) {
    const State state = states_[number];
    bool left = false;
    for (const ControlAction& command : commands_) {
      if (!step_.consistent(state.modes, command)) {
        left = true;  // it enables everything: nothing is claimed of that
        continue;
      }
      const std::vector<std::vector<ModeId>> choices = choices_in(state, command);
      if (!few(choices) || states_.size() > state_limit || work_ > work_limit) return std::nullopt;
      base::for_each_combination(choices, [&](const Modes& modes) {
        ++work_;
        if (!step_.possible(modes)) return;
        left = true;
        add(successor(state, modes), number);
      });
    }
    return left;
  }

  /// Per component, where the nominal transitions may lead in one cycle.
  std::vector<std::vector<ModeId>> choices_in(const State& state, const ControlAction& command) {
    const automata::AllEnabled& enabled = step_.enabled(state.modes, command);
    std::vector<std::vector<ModeId>> result;
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      automata::Enabled nominal = enabled[c];
      nominal.faults.clear();
      const Ticks clock = state.ages[c] + period_;
      result.push_back(targets(moves_of(plant_.components[c], state.modes[c], nominal, clock, period_)));
    }
    return result;
  }

  [[nodiscard]] State successor(const State& state, const Modes& modes) const {
    State result{modes, state.ages};
    for (std::size_t c = 0; c < modes.size(); ++c) {
      result.ages[c] = modes[c] == state.modes[c] ? std::min(state.ages[c] + period_, oldest_[c]) : Ticks{0};
    }
    return result;
  }

  StuckState story(std::size_t number) {
    StuckState result;
    const State& state = states_[number];
    result.modes = state.modes;
    result.period = period_;
    std::size_t first = number;
    for (; from_[first] != nothing; first = from_[first]) ++result.cycles;
    result.start = states_[first].modes;
    for (const std::vector<ModeId>& choice : choices_in(state, commands_.front()))
      result.next.push_back(choice.front());
    return result;
  }

  const Plant& plant_;
  automata::PlantStep step_;
  Ticks period_;
  std::vector<ControlAction> commands_;
  std::vector<Ticks> oldest_;  ///< by component
  std::size_t& work_;
  std::vector<State> states_;      ///< in order of cycles
  std::vector<std::size_t> from_;  ///< per state
  std::set<State> known_;
};

/// Whether some modes exclude each other, as far as can be seen.
bool excludes(const Plant& plant) {
  const automata::Locality locality(plant);
  return std::any_of(locality.islands().begin(), locality.islands().end(),
                     [&](const automata::Island& island) { return !is_total(plant, island); });
}

}  // namespace

std::vector<StuckState> find_stuck_states(const Plant& plant) {
  std::vector<StuckState> found;
  std::size_t work = 0;
  for (const PlantPart& part : parts_of(plant)) {
    if (!excludes(part.plant)) continue;
    std::optional<StuckState> state = StuckSearch(part.plant, work).run();
    if (!state) continue;
    state->components = part.components;
    found.push_back(std::move(*state));
  }
  return found;
}

}  // namespace rmpl::compiler
