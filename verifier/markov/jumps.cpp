// Rates of jumps, and what follows them at once.
// SPDX-License-Identifier: MIT
#include "verifier/markov/jumps.hpp"

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "verifier/markov/draws.hpp"
#include "verifier/zone/time_model.hpp"

namespace rmpl::verifier {

using automata::Component;
using automata::Enabled;
using automata::ModeId;
using automata::Modes;
using automata::Transition;
using automata::TransitionId;

namespace {

/// More than the relative error of a rate, which is read in double precision.
constexpr Real error_of_rate = 1e-15L;

[[noreturn]] void refuse(const Component& component, const Transition& transition, const std::string& why) {
  throw base::InputError("dense time: " + why + ": " + component.name + ", " +
                         component.modes[transition.from.index()].name + " -> " +
                         component.modes[transition.to.index()].name +
                         "; expected rates and exponential densities from 0 alone, or a period in --time");
}

class Explorer {
 public:
  Explorer(automata::PlantStep& step, const JumpQuestion& question, Meter& meter)
      : step_(step), plant_(step.plant()), question_(question), meter_(meter), idle_(automata::idle_action(plant_)) {}

  Jumps run() {
    for (const Draw& draw : initial_draws(step_, question_.from, meter_).outcomes) {
      Landing landing = land({draw.modes, 0});
      for (const Branch& edge : landing.edges) {
        result_.chain.start.push_back({{edge.to, 0}, draw.probability * edge.probability});
      }
    }
    for (StateNumber s = 0; s < numbers_.size(); ++s) {
      meter_.poll();
      meter_.at(numbers_.size() - s);
      explore(s);
    }
    return std::move(result_);
  }

 private:
  struct Place {
    Modes modes;
    unsigned faults = 0;
    auto operator<=>(const Place&) const = default;
  };
  /// The states in which time passes next, or that are wanted.
  struct Landing {
    std::vector<Branch> edges;
    Real left_out = 0;
  };

  StateNumber number(const Place& place) {
    ListNumbers::List list;
    for (const ModeId mode : place.modes) list.push_back(mode.value);
    list.push_back(question_.faults_beyond ? place.faults : 0);
    const StateNumber result = numbers_.number(list);
    if (result == result_.chain.wanted.size()) {
      meter_.count_state();
      places_.push_back(place);
      result_.chain.wanted.push_back(question_.wanted(place.modes));
      result_.chain.rows.emplace_back();
      result_.rates.emplace_back();
    }
    return result;
  }

  /// Whether the component takes an untimed transition now that leads to another mode.
  static bool is_urgent(const Component& component, ModeId mode, const Enabled& enabled) {
    return std::any_of(enabled.untimed.begin(), enabled.untimed.end(),
                       [&](TransitionId t) { return component.transitions[t.index()].to != mode; });
  }

  const Landing& land(const Place& place) {
    if (const auto known = landings_.find(place); known != landings_.end()) return known->second;
    if (!open_.insert(place).second) {
      throw base::InputError("dense time: steps that take no time go round and round, and time stands still");
    }
    meter_.poll();
    Landing landing;
    const automata::AllEnabled* enabled = step_.enabled_if_permitted(place.modes, idle_);
    bool urgent = false;
    if (enabled != nullptr && !question_.wanted(place.modes)) {
      for (std::size_t c = 0; c < plant_.components.size(); ++c) {
        urgent = urgent || is_urgent(plant_.components[c], place.modes[c], (*enabled)[c]);
      }
    }
    if (!urgent) {
      landing.edges.push_back({number(place), certain(), 0});
    } else {
      const automata::AllEnabled kept = *enabled;
      refuse_timed_faults(place.modes, kept);
      LeftOut left_out;
      if (question_.faults_beyond) left_out.faults_beyond = *question_.faults_beyond - place.faults;
      const Draws drawn = instant_draws(step_, place.modes, kept, left_out, meter_);
      landing.left_out = drawn.left_out;
      std::map<StateNumber, Enclosure> sums;
      for (const Draw& draw : drawn.outcomes) {
        const Landing& next = land({draw.modes, place.faults + draw.faults});
        for (const Branch& edge : next.edges) {
          Enclosure& sum = sums[edge.to];
          sum = sum + draw.probability * edge.probability;
        }
        landing.left_out = rounding::up(landing.left_out + draw.probability.upper * next.left_out, 2);
      }
      for (const auto& [to, sum] : sums) landing.edges.push_back({to, as_probability(sum), 0});
    }
    open_.erase(place);
    return landings_.emplace(place, std::move(landing)).first->second;
  }

  void refuse_timed_faults(const Modes& modes, const automata::AllEnabled& enabled) const {
    for (std::size_t c = 0; c < modes.size(); ++c) {
      const Component& component = plant_.components[c];
      for (const TransitionId t : enabled[c].faults) {
        const Transition& fault = component.transitions[t.index()];
        if (fault.timing) refuse(component, fault, "a fault has time bounds");
      }
    }
  }

  /// The rates at which a component leaves its mode, with where it goes to.
  std::vector<std::pair<ModeId, Enclosure>> exits_of(const Component& component, ModeId mode, const Enabled& enabled) {
    std::vector<std::pair<ModeId, Enclosure>> result;
    const auto add = [&](ModeId to, Real rate) {
      if (to == mode || rate == 0) return;
      result.emplace_back(to, outward({rate * (1 - error_of_rate), rate * (1 + error_of_rate)}, 4));
    };
    for (const TransitionId t : enabled.faults) {
      const Transition& fault = component.transitions[t.index()];
      if (fault.to == mode) continue;
      if (fault.weight.kind != automata::Weight::Kind::rate) {
        refuse(component, fault, "a fault has a probability per step where time passes");
      }
      add(fault.to, static_cast<Real>(fault.weight.value));
    }
    // An untimed transition to the mode itself leaves nothing to the timed ones.
    if (!enabled.untimed.empty()) return result;
    const auto share = [](const Transition& t) {
      return t.weight.kind == automata::Weight::Kind::none ? Real{1} : static_cast<Real>(t.weight.value);
    };
    for (const TransitionId id : enabled.timed) {
      const Transition& t = component.transitions[id.index()];
      const automata::Timing& timing = *t.timing;
      if (timing.density.kind != automata::Density::Kind::exponential || timing.lower.count != 0 ||
          !timing.upper.is_infinite()) {
        refuse(component, t, "a transition takes time that is not exponential from 0");
      }
      Real all = 0;
      for (const TransitionId other : enabled.timed) {
        const Transition& branch = component.transitions[other.index()];
        if (branch.branch == t.branch) all += share(branch);
      }
      add(t.to, share(t) / all / static_cast<Real>(timing.density.mean));
    }
    return result;
  }

  void explore(StateNumber s) {
    if (result_.chain.wanted[s]) return;
    const Place place = places_[s];
    const automata::AllEnabled* enabled = step_.enabled_if_permitted(place.modes, idle_);
    if (enabled == nullptr) return;
    const automata::AllEnabled kept = *enabled;
    refuse_timed_faults(place.modes, kept);
    std::map<StateNumber, Enclosure> rates;
    Enclosure left_out;
    for (std::size_t c = 0; c < place.modes.size(); ++c) {
      const Component& component = plant_.components[c];
      for (const auto& [to, rate] : exits_of(component, place.modes[c], kept[c])) {
        Place next = place;
        next.modes[c] = to;
        if (!step_.possible(next.modes)) continue;
        if (component.modes[to.index()].fault) ++next.faults;
        if (question_.faults_beyond && next.faults > *question_.faults_beyond) {
          left_out = left_out + rate;
          continue;
        }
        const Landing& landing = land(next);
        for (const Branch& edge : landing.edges) {
          Enclosure& sum = rates[edge.to];
          sum = sum + rate * edge.probability;
        }
        left_out = left_out + rate * Enclosure{0, landing.left_out};
      }
    }
    Enclosure all = left_out;
    for (const auto& [to, rate] : rates) all = all + rate;
    if (all.upper == 0) return;
    Row row;
    for (const auto& [to, rate] : rates) {
      const bool alone = rates.size() == 1 && left_out.upper == 0;
      row.edges.push_back({to, alone ? certain() : as_probability(rate / all), 0});
    }
    if (left_out.upper > 0) row.left_out = std::min<Real>((left_out / all).upper, 1);
    result_.chain.rows[s].push_back(std::move(row));
    result_.rates[s] = all;
  }

  automata::PlantStep& step_;
  const automata::Plant& plant_;
  const JumpQuestion& question_;
  Meter& meter_;
  automata::ControlAction idle_;
  ListNumbers numbers_;
  std::vector<Place> places_;  ///< by state
  std::map<Place, Landing> landings_;
  std::set<Place> open_;
  Jumps result_;
};

}  // namespace

Jumps jumps(automata::PlantStep& step, const JumpQuestion& question, Meter& meter) {
  refuse_dense_time(step.plant());
  return Explorer(step, question, meter).run();
}

}  // namespace rmpl::verifier
