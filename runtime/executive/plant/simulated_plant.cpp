// The stochastic simulation of a plant model.
// SPDX-License-Identifier: MIT
#include "runtime/executive/plant/simulated_plant.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "automata/assignment_text.hpp"
#include "automata/place.hpp"
#include "base/error.hpp"
#include "base/partition.hpp"
#include "base/product.hpp"

namespace rmpl::runtime {
namespace {

/// A model whose consistent next states are rarer than one in this many is taken to have none.
constexpr int draws_limit = 100'000;
/// After so many draws in vain it is asked whether there is any.
constexpr int draws_in_doubt = 256;
/// So many next states of one part of the store are looked at for that.
constexpr std::size_t outcomes_limit = 1u << 14;

constexpr std::uint64_t state_stream = 1;
constexpr std::uint64_t sensor_stream = 2;

/// Components by parts of the store: whether two can be together depends on nothing outside their part.
base::Partition parts_of(const automata::PlantStep& step) {
  base::Partition parts(step.plant().components.size());
  for (const automata::Island& island : step.locality().islands()) {
    const std::vector<automata::ComponentId>& reads = island.support.components;
    for (const automata::ComponentId other : reads) parts.join(reads.front().index(), other.index());
  }
  return parts;
}

}  // namespace

SimulatedPlant::SimulatedPlant(automata::PlantStep& step, const automata::Scenario& scenario, std::uint64_t seed,
                               std::vector<automata::ForcedMode> awaited, LuckUse luck)
    : plant_(step.plant()),
      step_(step),
      luck_(std::move(luck)),
      numbers_(seed, state_stream, luck_.noted ? &luck_.noted->moves : nullptr,
               luck_.followed ? &luck_.followed->moves : nullptr),
      sensors_(step_, {seed, sensor_stream, luck_.noted ? &luck_.noted->readings : nullptr,
                       luck_.followed ? &luck_.followed->readings : nullptr}),
      script_(step.plant(), scenario),
      forced_(scenario.forced),
      awaited_(std::move(awaited)),
      action_(automata::idle_action(step.plant())) {
  // Software goes wrong by a draw of its own.
  const auto is_drawn = [&](const automata::ForcedMode& forced) {
    const automata::Component& component = plant_[forced.component];
    return component.software && component.modes[forced.mode.index()].fault;
  };
  std::copy_if(forced_.begin(), forced_.end(), std::back_inserter(owed_), is_drawn);
  std::erase_if(forced_, is_drawn);
  std::stable_sort(forced_.begin(), forced_.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
  std::reverse(forced_.begin(), forced_.end());
  auto initial = step_.initial_moves();
  for (const automata::Assignment& given : scenario.truth) {
    initial[plant_.component_of(given.variable)->index()] = {{automata::ModeId(given.value.index()), 1.0}};
  }
  state_.clock_starts.assign(plant_.components.size(), automata::Ticks{});
  force(initial, time_);
  draw(initial, time_);
  state_.modes = drawn_;
}

void SimulatedPlant::issue(const automata::ControlAction& action, automata::Ticks now) {
  action_ = action;
  script_.hear_command(action, now);
}

bool SimulatedPlant::faults_are_due(automata::Ticks now) const {
  return (!forced_.empty() && forced_.back().at <= now) ||
         std::any_of(awaited_.begin(), awaited_.end(), [&](const auto& fault) { return fault.at <= now; }) ||
         waits_for(now);
}

bool SimulatedPlant::waits_for(automata::Ticks now) const {
  return std::any_of(owed_.begin(), owed_.end(), [&](const auto& fault) { return fault.at <= now; });
}

void SimulatedPlant::release(std::vector<std::vector<automata::Move>>& moves, automata::Ticks now) {
  const auto is_met = [&](const automata::ForcedMode& fault) {
    return fault.is_met_by(state_.modes[fault.component.index()]);
  };
  const auto is_released = [&](automata::ForcedMode fault) {
    auto& open = moves[fault.component.index()];
    if (fault.at > now || is_met(fault)) return false;
    const automata::Move* likeliest = nullptr;
    for (const automata::Move& move : open) {
      if (!fault.is_met_by(move.mode)) continue;
      if (likeliest == nullptr || move.probability > likeliest->probability) likeliest = &move;
    }
    if (likeliest == nullptr) return false;
    fault.mode = likeliest->mode;
    force(open, fault);
    return true;
  };
  std::erase_if(awaited_, is_released);
  std::erase_if(owed_, [&](const auto& fault) { return (fault.at <= now && is_met(fault)) || is_released(fault); });
}

void SimulatedPlant::force(std::vector<std::vector<automata::Move>>& moves, automata::Ticks now) {
  for (; !forced_.empty() && forced_.back().at <= now; forced_.pop_back()) {
    force(moves[forced_.back().component.index()], forced_.back());
  }
}

void SimulatedPlant::force(std::vector<automata::Move>& moves, const automata::ForcedMode& forced) {
  const automata::Component& component = plant_[forced.component];
  const bool modelled =
      !component.modes[forced.mode.index()].fault || state_.modes.empty() ||
      std::any_of(moves.begin(), moves.end(), [&](const automata::Move& move) { return move.mode == forced.mode; });
  happenings_.push_back(
      {Event::Kind::forced,
       to_text(component, forced.mode) + (modelled ? "" : ", to which the model has no transition now"),
       forced.component,
       {}});
  moves = {{forced.mode, 1.0}};
}

void SimulatedPlant::draw(const std::vector<std::vector<automata::Move>>& moves, automata::Ticks now) {
  drawn_.resize(moves.size());
  numbers_.begin_step();
  if (numbers_.follows()) return draw_in_parts(moves, now);
  draw_whole(moves, now);
}

automata::ModeId SimulatedPlant::choose(const std::vector<automata::Move>& moves, std::size_t component) {
  return moves.size() == 1 ? moves.front().mode : drawn(moves, numbers_.number(component)).mode;
}

void SimulatedPlant::draw_whole(const std::vector<std::vector<automata::Move>>& moves, automata::Ticks now) {
  for (int attempt = 0; attempt < draws_limit; ++attempt) {
    for (std::size_t c = 0; c < moves.size(); ++c) drawn_[c] = choose(moves[c], c);
    if (step_.possible(drawn_)) return;
    if (attempt + 1 == draws_in_doubt && is_stuck(moves)) give_up(now, draws_in_doubt);
    numbers_.begin_again();
  }
  give_up(now, draws_limit);
}

/// A part is stuck whatever the others do: they stay where they are, which is possible.
bool SimulatedPlant::is_stuck(const std::vector<std::vector<automata::Move>>& moves) const {
  const bool begins = state_.modes.empty();  // then all is one part
  base::Partition parts = parts_of(step_);
  std::vector<std::vector<std::size_t>> members(moves.size());
  for (std::size_t c = 0; c < moves.size(); ++c) members[begins ? 0 : parts.root(c)].push_back(c);
  automata::Modes modes = begins ? drawn_ : state_.modes;
  return std::any_of(members.begin(), members.end(), [&](const std::vector<std::size_t>& part) {
    if (part.empty()) return false;
    std::vector<std::span<const automata::Move>> open;
    std::size_t outcomes = 1;
    for (const std::size_t c : part) {
      open.emplace_back(moves[c]);
      outcomes *= std::min(moves[c].size(), outcomes_limit);
      if (outcomes > outcomes_limit) return false;
    }
    const bool possible = base::multiply_out(
        open,
        [&](std::size_t j, std::size_t i) {
          modes[part[j]] = open[j][i].mode;
          return true;
        },
        [](std::size_t, std::size_t) {}, [&] { return step_.possible(modes); });
    for (const std::size_t c : part) modes[c] = begins ? drawn_[c] : state_.modes[c];
    return !possible;
  });
}

/// The parts are independent of each other. So it is the same chance whether all draw again until all fit, or each part
/// by itself until it fits.
void SimulatedPlant::draw_in_parts(const std::vector<std::vector<automata::Move>>& moves, automata::Ticks now) {
  for (std::size_t c = 0; c < moves.size(); ++c) drawn_[c] = choose(moves[c], c);
  std::optional<base::Partition> parts;
  for (int attempt = 0; !step_.possible(drawn_); ++attempt) {
    const std::vector<automata::ComponentId> blamed = step_.conflict(drawn_);
    if (attempt == draws_limit || blamed.empty()) give_up(now, attempt);
    if (attempt + 1 == draws_in_doubt && is_stuck(moves)) give_up(now, draws_in_doubt);
    if (!parts) parts = parts_of(step_);
    const std::size_t part = parts->root(blamed.front().index());
    for (std::size_t c = 0; c < moves.size(); ++c) {
      if (parts->root(c) == part) drawn_[c] = choose(moves[c], c);
    }
  }
}

void SimulatedPlant::give_up(automata::Ticks now, int draws) const {
  std::string message = "the simulated plant '" + plant_.name + "' has no consistent next state at " +
                        automata::format_seconds(now) + " s";
  for (const Event& event : happenings_) {
    message += ", with " + to_text(plant_[*event.component], drawn_[event.component->index()]) + " forced";
  }
  throw base::InputError(message + "; each of " + std::to_string(draws) +
                         " drawn states contradicts the interconnections and mode constraints");
}

void SimulatedPlant::finish(automata::Ticks now) const {
  const auto missed = std::find_if(owed_.begin(), owed_.end(), [&](const auto& fault) { return fault.at <= now; });
  if (missed == owed_.end()) return;
  const std::string mode =
      missed->told ? to_text(plant_.variables, *missed->told) : to_text(plant_[missed->component], missed->mode);
  throw base::InputError(to_text(missed->origin) + ": from " + automata::format_seconds(missed->at) +
                         " s to the end at " + automata::format_seconds(now) + " s no draw led to " + mode +
                         ": the scenario forces a mode that no draw could reach");
}

const automata::Observation& SimulatedPlant::sense(automata::Ticks now) {
  happenings_.clear();
  const auto& moves = step_.moves(state_, action_, time_, now);
  if (faults_are_due(now)) {
    auto altered = moves;
    release(altered, now);
    force(altered, now);
    draw(altered, now);
  } else {
    draw(moves, now);
  }
  state_ = step_.advance(state_, action_, drawn_, now);
  time_ = now;
  readings_ = sensors_.read(state_.modes);
  script_.apply(readings_, now);
  script_.add_remarks(happenings_);
  return readings_;
}

}  // namespace rmpl::runtime
