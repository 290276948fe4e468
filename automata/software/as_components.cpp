// First the modes of all threads, as what they tell decides what the guards ask; then the transitions.
// SPDX-License-Identifier: MIT
#include "automata/software/as_components.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "automata/software/like_markings.hpp"
#include "automata/software/marking_modes.hpp"
#include "automata/software/names.hpp"
#include "automata/software/threads.hpp"
#include "automata/software/untold.hpp"

namespace rmpl::automata {
namespace {

/// The guards of the steps of a thread, by marking; steps that no state of the plant can take are gone.
using Guards = std::vector<std::vector<Formula>>;

/// What the other parts imply in every state with the mode need not be asked.
void leave_out_implied(std::vector<Formula>& parts, Assignment mode, Untold& untold) {
  for (std::size_t p = parts.size(); p-- > 0;) {
    std::vector<Formula> without = parts;
    without[p] = negation(without[p]);
    if (!untold.possible(conjunction(std::move(without)), mode)) {
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(p));
    }
  }
}

Guards settle(Thread& thread, VariableId variable, Untold& untold) {
  Guards guards(thread.markings.size());
  for (std::size_t m = 0; m < thread.markings.size(); ++m) {
    const Assignment mode{variable, ValueId(m)};
    std::vector<ThreadStep> kept;
    for (ThreadStep& step : thread.markings[m].steps) {
      std::vector<Formula> parts;
      parts.reserve(step.under.size());
      for (const Condition& condition : step.under) {
        const Formula part = condition.entailed ? condition.constraint : untold.of(condition.constraint, mode);
        for (Formula& conjunct : conjuncts_of(part)) parts.push_back(std::move(conjunct));
      }
      leave_out_implied(parts, mode, untold);
      Formula guard = conjunction(std::move(parts));
      if (!untold.possible(guard, mode)) continue;
      guards[m].push_back(std::move(guard));
      kept.push_back(std::move(step));
    }
    thread.markings[m].steps = std::move(kept);
  }
  find_ways(thread);
  return guards;
}

/// Faults that are certain leave nothing, as rounding must not do.
void make_certain(std::vector<Transition>& faults) {
  const auto sum = [&] {
    return std::accumulate(faults.begin(), faults.end(), 0.0,
                           [](double all, const Transition& t) { return all + t.weight.value; });
  };
  double& greatest = std::max_element(faults.begin(), faults.end(), [](const Transition& a, const Transition& b) {
                       return a.weight.value < b.weight.value;
                     })->weight.value;
  while (sum() < 1) greatest = std::nextafter(greatest, 2);
}

/// The transitions out of all modes; `component` has no others.
void add_transitions(Component& component, const Thread& thread, const MarkingModes& modes, const Guards& guards) {
  for (std::size_t from = 0; from < modes.all().size(); ++from) {
    const std::size_t m = modes.all()[from].marking;
    for (std::size_t s = 0; s < guards[m].size(); ++s) {
      std::vector<Transition> nominal, faults;
      for (const ThreadOutcome& outcome : thread.markings[m].steps[s].outcomes) {
        Transition t{
            ModeId(from), modes.after(ModeId(from), outcome), guards[m][s], {}, {}, 0, component.modes[from].origin};
        t.consequence = component.modes[t.to.index()].fault && outcome.rarity == 1;
        const bool certain = outcome.probability == 1 && !component.is_fault(t);
        if (!certain) t.weight = {Weight::Kind::probability, outcome.probability};
        (component.is_fault(t) ? faults : nominal).push_back(std::move(t));
      }
      if (nominal.empty()) make_certain(faults);
      // What stays where it is, whatever the faults leave, needs no transition.
      if (nominal.size() == 1 && nominal.front().to == ModeId(from)) nominal.clear();
      for (auto* kind : {&nominal, &faults}) {
        std::move(kind->begin(), kind->end(), std::back_inserter(component.transitions));
      }
    }
  }
  std::uint32_t branch = 0;
  for (Transition& t : component.transitions) t.branch = branch++;
}

class Software {
 public:
  explicit Software(const PlantWithModels& whole) : whole_(whole), made_(whole.plant) {}

  SoftwarePlant run() {
    for (std::size_t m = 0; m < whole_.models.size(); ++m) add_modes(m);
    const Plant told = made_;
    Untold untold(told);
    const std::size_t first = whole_.plant.components.size();
    std::vector<Guards> guards;
    std::vector<MarkingModes> modes;
    for (std::size_t t = 0; t < threads_.size(); ++t) {
      guards.push_back(settle(threads_[t], made_.components[first + t].mode, untold));
      modes.emplace_back(threads_[t]);
    }
    tell_apart(modes);
    for (std::size_t t = 0; t < threads_.size(); ++t) {
      for (std::vector<Formula>& steps : guards[t]) {
        for (Formula& guard : steps) guard = over_modes(guard, modes);
      }
      add_transitions(made_.components[first + t], threads_[t], modes[t], guards[t]);
    }
    return {std::move(made_), std::move(markings_)};
  }

 private:
  void add_modes(std::size_t position) {
    const ModelComponent& model = whole_.models[position];
    ModelProgram program = model.program;
    if (!model.name.empty()) program.name = model.name;
    program.variables = whole_.plant.variables;
    program.constraints = whole_.plant.interconnections;
    std::vector<Thread> threads = threads_of(program);
    for (Thread& thread : threads) like_.push_back(merge_like(program, thread));
    const std::vector<std::string> names = names_of_threads(program, threads, model.name, made_.variables);
    for (std::size_t t = 0; t < threads.size(); ++t) {
      Component component;
      component.name = names[t];
      component.type = model.program.name;
      if (model.name.empty()) {
        component.type = names[t];
      } else if (threads.size() > 1) {
        component.type += names[t].substr(model.name.size());
      }
      component.origin = program.locations[threads[t].first.index()].origin;
      component.progress = true;
      component.software = true;
      component.initial.assign(threads[t].markings.size(), 0.0);
      for (const ThreadOutcome& outcome : threads[t].start) component.initial[outcome.target] += outcome.probability;
      std::vector<std::string> modes = names_of_markings(program, threads[t]);
      for (std::size_t m = 0; m < modes.size(); ++m) {
        const ThreadMarking& marking = threads[t].markings[m];
        Mode& mode = component.modes.emplace_back();
        mode.name = modes[m];
        mode.constraint = told(program, marking.marked);
        mode.origin =
            marking.marked.empty() ? component.origin : program.locations[marking.marked.front().index()].origin;
      }
      component.mode = made_.variables.add({names[t], std::move(modes)});
      made_.components.push_back(std::move(component));
    }
    for (Thread& thread : threads) {
      markings_.push_back({position, {}});
      threads_.push_back(std::move(thread));
    }
  }

  /// Gives each marking its modes.
  void tell_apart(const std::vector<MarkingModes>& all) {
    Variables variables;
    for (std::size_t v = 0; v < whole_.plant.variables.size(); ++v) variables.add(made_.variables[VariableId(v)]);
    for (std::size_t t = 0; t < all.size(); ++t) {
      Component& component = made_.components[whole_.plant.components.size() + t];
      std::vector<Mode> modes;
      std::vector<double> initial;
      std::set<std::string> taken;
      for (const Mode& mode : component.modes) taken.insert(mode.name);
      for (const MarkingModes::Of& one : all[t].all()) {
        const ThreadMarking& marking = threads_[t].markings[one.marking];
        Mode& mode = modes.emplace_back(component.modes[one.marking]);
        if (one.usual) {
          mode.name += "_improbable";
          for (std::size_t n = 2; !taken.insert(mode.name).second; ++n) {
            mode.name = component.modes[one.marking].name + "_improbable_" + std::to_string(n);
          }
        }
        mode.usual = one.usual;
        mode.fault = one.usual || marking.way < 1;
        initial.push_back(one.usual ? 0 : component.initial[one.marking]);
        markings_[t].markings.push_back(like_[t][one.marking]);
      }
      component.modes = std::move(modes);
      component.initial = std::move(initial);
      Variable variable{component.name, {}};
      for (const Mode& mode : component.modes) variable.values.push_back(mode.name);
      variables.add(std::move(variable));
    }
    made_.variables = std::move(variables);
  }

  /// A formula over markings as one over modes.
  [[nodiscard]] Formula over_modes(const Formula& formula, const std::vector<MarkingModes>& all) const {
    Formula result = formula;
    if (formula.kind == Formula::Kind::member && formula.variable.index() >= whole_.plant.variables.size()) {
      std::size_t t = 0;
      while (made_.components[whole_.plant.components.size() + t].mode != formula.variable) ++t;
      std::vector<ValueId> values;
      for (const ValueId marking : formula.values) {
        for (const ModeId mode : all[t].of(marking.index())) values.emplace_back(mode.index());
      }
      return values.empty() ? constant(false) : member(formula.variable, std::move(values));
    }
    for (Formula& operand : result.operands) operand = over_modes(operand, all);
    return result;
  }

  const PlantWithModels& whole_;
  Plant made_;
  std::vector<Thread> threads_;
  std::vector<std::vector<std::vector<Marking>>> like_;  ///< by thread and marking, all that it stands for
  std::vector<SoftwareThread> markings_;
};

/// A control that commands `in_force`, or leaves it open.
Control may_be_unknown(Plant& plant, Variable variable, VariableId in_force) {
  const std::size_t values = variable.values.size();
  std::string nothing = "unknown";
  while (variable.find(nothing)) nothing += '_';
  variable.values.push_back(std::move(nothing));
  const VariableId commanded = plant.variables.add(std::move(variable));
  for (std::size_t v = 0; v < values; ++v) {
    plant.interconnections.emplace_back(implication(is(commanded, ValueId(v)), is(in_force, ValueId(v))));
  }
  return {commanded, ValueId(values)};
}

}  // namespace

SoftwarePlant with_software(const PlantWithModels& whole) { return Software(whole).run(); }

PlantWithModels plant_of(const ModelProgram& program) {
  PlantWithModels whole;
  Plant& plant = whole.plant;
  plant.name = program.name;
  plant.interconnections = program.constraints;
  plant.observables = program.observables;
  std::vector<bool> open(program.variables.size());  // what may be commanded to be unknown
  for (const CommandedVariable& control : program.controls) open[control.variable.index()] = !control.idle;
  for (std::size_t v = 0; v < program.variables.size(); ++v) {
    Variable variable = program.variables[VariableId(v)];
    if (open[v]) variable.name += ".in_force";
    while (open[v] && program.variables.find(variable.name)) variable.name += '_';
    plant.variables.add(std::move(variable));
  }
  for (const CommandedVariable& control : program.controls) {
    if (control.idle) {
      plant.controls.push_back({control.variable, *control.idle});
    } else {
      plant.controls.push_back(may_be_unknown(plant, program.variables[control.variable], control.variable));
    }
  }
  whole.models.push_back({"", program});
  return whole;
}

}  // namespace rmpl::automata
