// What one component may do in one step: the rules of semantics 3, in one place.
// SPDX-License-Identifier: MIT
#include "automata/step/transition_rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "automata/clock_use.hpp"
#include "automata/time/firing.hpp"

namespace rmpl::automata {
namespace {

/// What is possible is at least so probable.
constexpr double least = std::numeric_limits<double>::min();

/// The share of a nominal transition among those that take the nominal share together.
double share_weight(const Weight& weight) { return weight.kind == Weight::Kind::none ? 1.0 : weight.value; }

bool within_bounds(const Transition& fault, Ticks clock) {
  return !fault.timing || (fault.timing->lower <= clock && clock <= fault.timing->upper);
}

/// Adds up probabilities by target mode, in order of mode.
class Moves {
 public:
  /// What is added is possible.
  void add(ModeId mode, double probability) {
    probability = std::max(probability, least);
    const auto at = std::lower_bound(moves_.begin(), moves_.end(), mode,
                                     [](const Move& move, ModeId other) { return move.mode < other; });
    if (at != moves_.end() && at->mode == mode) {
      at->probability += probability;
    } else {
      moves_.insert(at, {mode, probability});
    }
  }
  [[nodiscard]] std::vector<Move> take() { return std::move(moves_); }

 private:
  std::vector<Move> moves_;
};

/// Timed transitions of one branch: one risk, whose outcome their weights decide.
struct Risk {
  std::uint32_t branch;
  Firing firing;
  double hazard;
  double weight;
};

/// The timed transitions of one component as independent risks that compete for the nominal share.
class Competition {
 public:
  Competition(const Component& component, const Enabled& enabled, Ticks from, Ticks to)
      : component_(component), timed_(enabled.timed) {
    for (const TransitionId id : timed_) {
      const Transition& t = component.transitions[id.index()];
      if (Risk* known = find(t.branch)) {
        known->weight += share_weight(t.weight);
        continue;
      }
      const Firing firing = automata::firing(*t.timing, from, to);
      const double hazard = firing == Firing::possible ? t.timing->step_hazard(from, to) : 0;
      risks_.push_back({t.branch, firing, hazard, share_weight(t.weight)});
      total_ += hazard;
      if (firing == Firing::certain) ++certain_;
    }
  }

  void share_out(double nominal, ModeId staying, Moves& result) {
    const double fires = certain_ > 0 ? 1.0 : -std::expm1(-total_);
    for (const TransitionId id : timed_) {
      const Transition& t = component_.transitions[id.index()];
      const Risk& risk = *find(t.branch);
      // Beside what is certain nothing else fires.
      if (risk.firing != (certain_ > 0 ? Firing::certain : Firing::possible)) continue;
      const double share = certain_ > 0 ? 1.0 / certain_ : total_ > 0 ? risk.hazard / total_ : 0;
      result.add(t.to, nominal * fires * share * share_weight(t.weight) / risk.weight);
    }
    if (certain_ == 0) result.add(staying, nominal * std::exp(-total_));
  }

 private:
  Risk* find(std::uint32_t branch) {
    const auto at = std::find_if(risks_.begin(), risks_.end(), [&](const Risk& r) { return r.branch == branch; });
    return at == risks_.end() ? nullptr : &*at;
  }

  const Component& component_;
  const std::vector<TransitionId>& timed_;
  std::vector<Risk> risks_;
  double total_ = 0;  ///< of the hazards of what may fire
  int certain_ = 0;
};

}  // namespace

void add_enabled(Enabled& enabled, const Component& component, TransitionId transition) {
  const Transition& t = component.transitions[transition.index()];
  (component.is_fault(t) ? enabled.faults : t.timing ? enabled.timed : enabled.untimed).push_back(transition);
}

/// 1 - F, where the greatest rate is not rounded: 1 - (1 - exp(-x)) is exp(-x), however large x is.
double nominal_share(const Component& component, const Enabled& enabled, Ticks clock, Ticks step) {
  double rate = 0;
  double others = 0;
  for (const TransitionId id : enabled.faults) {
    const Transition& t = component.transitions[id.index()];
    if (!within_bounds(t, clock)) continue;
    Weight weight = t.weight;
    if (weight.kind == Weight::Kind::rate && weight.value > rate) std::swap(rate, weight.value);
    others += weight.fault_probability(step);
  }
  const double share = std::exp(-rate * step.seconds()) - others;
  return others > 0 ? std::max(share, 0.0) : std::max(share, least);
}

bool clock_matters(const Component& component, const Enabled& enabled) {
  const auto needs = [&](TransitionId id) { return needs_clock(component.transitions[id.index()]); };
  return std::any_of(enabled.timed.begin(), enabled.timed.end(), needs) ||
         std::any_of(enabled.faults.begin(), enabled.faults.end(), needs);
}

std::vector<Move> moves_of(const Component& component, ModeId mode, const Enabled& enabled, Ticks clock, Ticks step) {
  const auto transition = [&](TransitionId t) -> const Transition& { return component.transitions[t.index()]; };
  Moves result;
  double nominal = 1;
  if (!enabled.faults.empty()) {
    nominal = nominal_share(component, enabled, clock, step);
    double faulty = 0;
    for (const TransitionId t : enabled.faults) {
      // Only where they leave nothing can they be above 1.
      if (nominal == 0 && within_bounds(transition(t), clock)) faulty += transition(t).weight.fault_probability(step);
    }
    for (const TransitionId t : enabled.faults) {
      if (!within_bounds(transition(t), clock)) continue;
      const double probability = transition(t).weight.fault_probability(step);
      result.add(transition(t).to, faulty > 1 ? probability / faulty : probability);
    }
    if (nominal == 0) return result.take();
  }
  if (enabled.untimed.empty()) {
    Competition(component, enabled, clock - step, clock).share_out(nominal, mode, result);
    return result.take();
  }
  // Untimed nominal transitions leave nothing to wait for.
  double total = 0;
  for (const TransitionId t : enabled.untimed) total += share_weight(transition(t).weight);
  for (const TransitionId t : enabled.untimed) {
    result.add(transition(t).to, nominal * share_weight(transition(t).weight) / total);
  }
  return result.take();
}

bool restarts(const Component& component, const Enabled& enabled) {
  return std::any_of(enabled.untimed.begin(), enabled.untimed.end(),
                     [&](TransitionId id) { return component.transitions[id.index()].restart; });
}

bool has_restarts(const Plant& plant) {
  return std::any_of(plant.components.begin(), plant.components.end(), [](const Component& component) {
    return std::any_of(component.transitions.begin(), component.transitions.end(),
                       [](const Transition& t) { return t.restart; });
  });
}

std::vector<Move> initial_moves_of(const Component& component) {
  std::vector<Move> moves;
  for (std::size_t m = 0; m < component.initial.size(); ++m) {
    if (component.initial[m] > 0) moves.push_back({ModeId(m), component.initial[m]});
  }
  return moves;
}

bool lead(const std::vector<std::vector<Move>>& moves, const Modes& next) {
  for (std::size_t c = 0; c < moves.size(); ++c) {
    if (std::none_of(moves[c].begin(), moves[c].end(), [&](const Move& m) { return m.mode == next[c]; })) return false;
  }
  return true;
}

SystemState advance(const SystemState& state, const std::vector<bool>& restarted, const Modes& next, Ticks now) {
  SystemState result{next, state.clock_starts};
  for (std::size_t c = 0; c < next.size(); ++c) {
    if (next[c] != state.modes[c] || restarted[c]) result.clock_starts[c] = now;
  }
  return result;
}

}  // namespace rmpl::automata
