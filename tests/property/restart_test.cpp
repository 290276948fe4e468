// A mode that restarts beside two modes that lead to each other: the same plant, written without `restart`.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "runtime/reasoning/estimate/estimator.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/belief.hpp"
#include "verifier/check/check.hpp"

namespace rmpl::property {
namespace {

using automata::Component;
using automata::Formula;
using automata::ModeId;
using automata::Plant;
using automata::SystemState;
using automata::Ticks;
using automata::Transition;
using automata::ValueId;
using automata::VariableId;

/// The plant in which each mode that restarts has a twin. A step with the kick leads from one to the other.
class Split {
 public:
  explicit Split(const Plant& plant) : whole_(plant) {
    for (const Component& component : plant.components) {
      auto& twins = twins_.emplace_back(component.modes.size());
      std::size_t next = component.modes.size();
      for (const Transition& t : component.transitions) {
        if (t.restart && !twins[t.from.index()]) twins[t.from.index()] = ModeId(next++);
      }
    }
    made_.name = plant.name;
    for (std::size_t v = 0; v < plant.variables.size(); ++v) made_.variables.add(variable(VariableId(v)));
    for (std::size_t c = 0; c < plant.components.size(); ++c) add(c);
    for (const automata::Interconnection& q : plant.interconnections) {
      made_.interconnections.emplace_back(formula(q.constraint));
    }
    made_.controls = plant.controls;
    made_.observables = plant.observables;
  }

  [[nodiscard]] const Plant& plant() const { return made_; }
  /// No two mode variables are compared: their domains differ now.
  [[nodiscard]] bool faithful() const { return faithful_; }

  /// Where it spoke of a mode it speaks of both.
  Formula formula(const Formula& from) {
    Formula result = from;
    for (Formula& operand : result.operands) operand = formula(operand);
    if (from.kind == Formula::Kind::equality) {
      faithful_ = faithful_ && !whole_.component_of(from.variable) && !whole_.component_of(from.other);
    }
    const auto component = whole_.component_of(from.variable);
    if (from.kind != Formula::Kind::member || !component) return result;
    for (const ValueId value : from.values) {
      if (const auto twin = twins_[component->index()][value.index()]) result.values.emplace_back(twin->index());
    }
    std::sort(result.values.begin(), result.values.end());
    return result;
  }

  /// The state of the whole plant that it is.
  [[nodiscard]] SystemState whole(SystemState state) const {
    for (std::size_t c = 0; c < state.modes.size(); ++c) {
      const auto& twins = twins_[c];
      for (std::size_t m = 0; m < twins.size(); ++m) {
        if (twins[m] == state.modes[c]) state.modes[c] = ModeId(m);
      }
    }
    return state;
  }

 private:
  automata::Variable variable(VariableId id) const {
    automata::Variable result = whole_.variables[id];
    const auto component = whole_.component_of(id);
    if (!component) return result;
    const auto& twins = twins_[component->index()];
    for (std::size_t m = 0; m < twins.size(); ++m) {
      if (twins[m]) result.values.resize(std::max(result.values.size(), twins[m]->index() + 1));
    }
    for (std::size_t m = 0; m < twins.size(); ++m) {
      if (twins[m]) result.values[twins[m]->index()] = result.values[m] + "-again";
    }
    return result;
  }

  void add(std::size_t c) {
    Component component = whole_.components[c];
    const auto& twins = twins_[c];
    std::vector<std::pair<ModeId, std::size_t>> again;
    for (std::size_t m = 0; m < twins.size(); ++m) {
      if (twins[m]) again.emplace_back(*twins[m], m);
    }
    std::sort(again.begin(), again.end());
    for (automata::Mode& mode : component.modes) mode.constraint = formula(mode.constraint);
    for (const auto& [twin, mode] : again) {
      component.modes.push_back(component.modes[mode]);
      component.modes.back().name += "-again";
      component.initial.push_back(0);
    }
    std::vector<Transition> transitions;
    for (Transition t : component.transitions) {
      t.guard = formula(t.guard);
      const auto twin = twins[t.from.index()];
      const bool restarts = std::exchange(t.restart, false);
      if (restarts) t.to = *twin;
      transitions.push_back(t);
      if (!twin) continue;
      if (restarts) t.to = t.from;
      t.from = *twin;
      transitions.push_back(t);
    }
    component.transitions = std::move(transitions);
    made_.components.push_back(std::move(component));
  }

  const Plant& whole_;
  Plant made_;
  std::vector<std::vector<std::optional<ModeId>>> twins_;  ///< by component, by mode
  bool faithful_ = true;
};

/// Whether it takes a command off idle, whatever the modes are.
bool is_commanded(const Plant& plant, const Transition& t) {
  return std::any_of(plant.controls.begin(), plant.controls.end(), [&](const automata::Control& control) {
    const auto& values = t.guard.values;
    return t.guard.kind == Formula::Kind::member && t.guard.variable == control.variable &&
           std::find(values.begin(), values.end(), control.idle) == values.end();
  });
}

/// Most modes with a timed exit restart. A twin of a fault mode would be a fault of its own. With `commanded`, restarts
/// take a command: in dense time two modes that idle controls let lead to each other keep time from passing. So does
/// what contradicts idle controls, which enables every guard.
Model drawn_model(bool commanded = false) {
  Shape shape;
  shape.tangled = chance(50);
  shape.distributions = false;
  shape.restarts = 80;
  Model model = *models(shape);
  const auto commands = [&](const automata::Interconnection& q) {
    const std::vector<VariableId> read = automata::variables_of(q.constraint);
    return std::any_of(model.plant.controls.begin(), model.plant.controls.end(), [&](const automata::Control& control) {
      return std::find(read.begin(), read.end(), control.variable) != read.end();
    });
  };
  if (commanded) std::erase_if(model.plant.interconnections, commands);
  for (Component& component : model.plant.components) {
    std::erase_if(component.transitions, [&](const Transition& t) {
      return t.restart && (component.modes[t.from.index()].fault || (commanded && !is_commanded(model.plant, t)));
    });
  }
  return model;
}

bool restarts(const Plant& plant) {
  return std::any_of(plant.components.begin(), plant.components.end(), [](const Component& component) {
    return std::any_of(component.transitions.begin(), component.transitions.end(),
                       [](const Transition& t) { return t.restart; });
  });
}

void compare_estimates(bool exact) {
  const Model model = drawn_model();
  RC_PRE(restarts(model.plant));
  Split split(model.plant);
  RC_PRE(split.faithful());
  automata::PlantStep one(model.plant);
  automata::PlantStep two(split.plant());
  constexpr std::size_t all = 1U << 16;
  const auto make = [&](automata::PlantStep& step) {
    return exact ? runtime::make_exact_estimator(step, {}) : runtime::make_k_best_estimator(step, {.k = all});
  };
  const auto whole = make(one);
  const auto parts = make(two);
  const Log log = *logs(model.plant, 5);
  for (const LogLine& line : log.lines) {
    const bool follows = whole->update(line.action, line.observation, line.time).follows;
    RC_ASSERT(parts->update(line.action, line.observation, line.time).follows == follows);
    std::map<SystemState, double> sums;
    for (const runtime::BeliefEntry& entry : parts->belief()) sums[split.whole(entry.state)] += entry.probability;
    RC_ASSERT(whole->belief().size() == sums.size());
    for (const runtime::BeliefEntry& entry : whole->belief()) {
      RC_ASSERT(std::abs(sums[entry.state] - entry.probability) < 1e-9);
    }
  }
}

RC_GTEST_PROP(Restart, ExactEstimatesAreThoseOfTwoModes, ()) { compare_estimates(true); }
RC_GTEST_PROP(Restart, KBestEstimatesAreThoseOfTwoModes, ()) { compare_estimates(false); }

void compare_verdicts(std::optional<Ticks> period) {
  const Model model = drawn_model(!period);
  RC_PRE(restarts(model.plant));
  Split split(model.plant);
  verifier::CheckOptions options;
  options.period = period;
  options.faults = static_cast<unsigned>(up_to(0, 1));
  options.commands = chance(50) ? verifier::Commands::one : verifier::Commands::any;
  const auto drawn = [&] {
    return automata::conjunction_of(reference::assumptions_of(model.plant, *modes_of(model.plant)));
  };
  const Formula target = drawn();
  const Formula then = drawn();
  const Formula split_target = split.formula(target);
  const Formula split_then = split.formula(then);
  RC_PRE(split.faithful());
  const Ticks within = chance(30) ? Ticks::infinite() : Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 6)));
  RC_LOG() << to_text(target, model.plant.variables) << "\nthen " << to_text(then, model.plant.variables) << '\n';
  verifier::Slices whole(model.plant);
  verifier::Slices parts(split.plant());
  const auto compare = [&](const verifier::Property& one, const verifier::Property& two) {
    const verifier::Answer a = verifier::check(whole, one, options, {});
    const verifier::Answer b = verifier::check(parts, two, options, {});
    // Two modes can lead to each other in no time, where a restart changes nothing: one run stands still, the other is
    // stuck.
    const bool still = b.cut_off.still || (b.witness && b.witness->stop);
    RC_ASSERT(still || a.verdict == b.verdict);
    RC_ASSERT(still || a.witness.has_value() == b.witness.has_value());
  };
  compare(verifier::Reachability{.target = target, .window = {}},
          verifier::Reachability{.target = split_target, .window = {}});
  compare(verifier::Safety{.never = target, .window = {}}, verifier::Safety{.never = split_target, .window = {}});
  compare(verifier::Response{target, then, within}, verifier::Response{split_target, split_then, within});
  RC_ASSERT(verifier::check(whole, verifier::Stuck{}, options, {}).verdict ==
            verifier::check(parts, verifier::Stuck{}, options, {}).verdict);
}

RC_GTEST_PROP(Restart, DenseVerdictsAreThoseOfTwoModes, ()) { compare_verdicts(std::nullopt); }
RC_GTEST_PROP(Restart, SampledVerdictsAreThoseOfTwoModes, ()) {
  compare_verdicts(pick<Ticks>({{Ticks::per_second}, {3 * Ticks::per_second / 4}}));
}

}  // namespace
}  // namespace rmpl::property
