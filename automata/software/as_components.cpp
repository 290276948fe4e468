// First the modes of all threads, as what they tell decides what the guards ask; then the transitions.
// SPDX-License-Identifier: MIT
#include "automata/software/as_components.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "automata/software/names.hpp"
#include "automata/software/threads.hpp"
#include "automata/software/untold.hpp"

namespace rmpl::automata {
namespace {

Formula told(const ModelProgram& program, const Marking& marking) {
  std::vector<Formula> parts;
  parts.reserve(marking.size());
  for (const LocationId l : marking) {
    const Formula& formula = program.locations[l.index()].told;
    if (!formula.is_true()) parts.push_back(formula);
  }
  return conjunction(std::move(parts));
}

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

void add_transitions(Component& component, const Thread& thread, const Guards& guards) {
  for (std::size_t m = 0; m < thread.markings.size(); ++m) {
    for (std::size_t s = 0; s < guards[m].size(); ++s) {
      std::vector<Transition> nominal, faults;
      for (const ThreadOutcome& outcome : thread.markings[m].steps[s].outcomes) {
        Transition t{ModeId(m), ModeId(outcome.target), guards[m][s], {}, {}, 0, component.modes[m].origin};
        const bool into_fault = component.modes[outcome.target].fault;
        t.consequence = into_fault && (outcome.rarity == 1 || outcome.target == m);
        const bool certain = outcome.probability == 1 && !component.is_fault(t);
        if (!certain) t.weight = {Weight::Kind::probability, outcome.probability};
        (component.is_fault(t) ? faults : nominal).push_back(std::move(t));
      }
      // What stays where it is, whatever the faults leave, needs no transition.
      if (nominal.size() == 1 && nominal.front().to == ModeId(m)) nominal.clear();
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
    std::vector<std::vector<bool>> met;
    const std::size_t first = whole_.plant.components.size();
    for (std::size_t t = 0; t < threads_.size(); ++t) {
      Component& component = made_.components[first + t];
      const Guards guards = settle(threads_[t], component.mode, untold);
      auto& own = met.emplace_back();
      for (std::size_t m = 0; m < component.modes.size(); ++m) {
        const double way = threads_[t].markings[m].way;
        own.push_back(way > 0);
        component.modes[m].fault = way < 1;
      }
      add_transitions(component, threads_[t], guards);
    }
    leave_out(met);
    return {std::move(made_), std::move(markings_)};
  }

 private:
  void add_modes(std::size_t position) {
    const ModelComponent& model = whole_.models[position];
    ModelProgram program = model.program;
    program.name = model.name;
    program.variables = whole_.plant.variables;
    program.constraints = whole_.plant.interconnections;
    std::vector<Thread> threads = threads_of(program);
    const std::vector<std::string> names = names_of_threads(program, threads, model.name, made_.variables);
    for (std::size_t t = 0; t < threads.size(); ++t) {
      Component component;
      component.name = names[t];
      component.type = model.program.name;
      if (threads.size() > 1) component.type += names[t].substr(model.name.size());
      component.origin = program.locations[threads[t].first.index()].origin;
      component.progress = true;
      component.software = true;
      component.initial.assign(threads[t].markings.size(), 0.0);
      for (const ThreadOutcome& outcome : threads[t].start) component.initial[outcome.target] = outcome.probability;
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

  /// Modes have other numbers then: of variables, transitions and guards.
  void leave_out(const std::vector<std::vector<bool>>& met) {
    std::vector<std::vector<ValueId>> renumbered(made_.variables.size());
    Variables variables;
    for (std::size_t v = 0; v < whole_.plant.variables.size(); ++v) variables.add(made_.variables[VariableId(v)]);
    const std::size_t first = whole_.plant.components.size();
    for (std::size_t t = 0; t < met.size(); ++t) {
      Component& component = made_.components[first + t];
      auto& numbers = renumbered[component.mode.index()];
      Variable variable{component.name, {}};
      std::vector<Mode> modes;
      std::vector<double> initial;
      for (std::size_t m = 0; m < met[t].size(); ++m) {
        numbers.emplace_back(modes.size());
        if (!met[t][m]) continue;
        variable.values.push_back(component.modes[m].name);
        markings_[t].markings.push_back(threads_[t].markings[m].marked);
        initial.push_back(component.initial[m]);
        modes.push_back(std::move(component.modes[m]));
      }
      component.modes = std::move(modes);
      component.initial = std::move(initial);
      std::erase_if(component.transitions, [&](const Transition& one) { return !met[t][one.from.index()]; });
      for (Transition& transition : component.transitions) {
        transition.from = ModeId(numbers[transition.from.index()].index());
        transition.to = ModeId(numbers[transition.to.index()].index());
      }
      variables.add(std::move(variable));
    }
    for (std::size_t t = 0; t < met.size(); ++t) {
      for (Transition& transition : made_.components[first + t].transitions) {
        transition.guard = without_dropped(transition.guard, met, first, renumbered);
      }
    }
    made_.variables = std::move(variables);
  }

  /// The formula over the modes that are left; it is asked of states that have no others.
  [[nodiscard]] Formula without_dropped(const Formula& formula, const std::vector<std::vector<bool>>& met,
                                        std::size_t first, const std::vector<std::vector<ValueId>>& renumbered) const {
    Formula result = formula;
    if (formula.kind == Formula::Kind::member && !renumbered[formula.variable.index()].empty()) {
      std::size_t t = 0;
      while (made_.components[first + t].mode != formula.variable) ++t;
      std::vector<ValueId> values;
      for (const ValueId v : formula.values) {
        if (met[t][v.index()]) values.push_back(renumbered[formula.variable.index()][v.index()]);
      }
      return values.empty() ? constant(false) : member(formula.variable, std::move(values));
    }
    for (Formula& operand : result.operands) operand = without_dropped(operand, met, first, renumbered);
    return result;
  }

  const PlantWithModels& whole_;
  Plant made_;
  std::vector<Thread> threads_;
  std::vector<SoftwareThread> markings_;
};

}  // namespace

SoftwarePlant with_software(const PlantWithModels& whole) { return Software(whole).run(); }

}  // namespace rmpl::automata
