// Random small plants, formulas and logs for the property tests.
// SPDX-License-Identifier: MIT
#include "tests/property/generate.hpp"
#include "tests/reference/belief.hpp"

#include <algorithm>

#include "automata/json/document.hpp"
#include "tests/property/draw.hpp"

namespace rmpl::property {

using automata::Assignment;
using automata::Component;
using automata::Formula;
using automata::ModeId;
using automata::Plant;
using automata::Ticks;
using automata::Timing;
using automata::Transition;
using automata::ValueId;
using automata::VariableId;
using automata::Weight;

namespace {

Formula draw_formula(const automata::Variables& table, const std::vector<VariableId>& variables, int depth) {
  const auto smaller = [&] { return draw_formula(table, variables, depth - 1); };
  const VariableId variable = pick(variables);
  const std::size_t values = table[variable].values.size();
  switch (depth > 0 ? up_to(0, 9) : up_to(0, 3)) {
    case 0:
    case 1:
      return automata::is(variable, ValueId(up_to(0, values - 1)));
    case 2: {
      std::vector<ValueId> some;
      for (std::size_t i = 0; i < values; ++i)
        if (chance(60)) some.emplace_back(i);
      return automata::member(variable, some);
    }
    case 3: {
      std::vector<VariableId> same;
      for (VariableId other : variables)
        if (other != variable && table[other].values == table[variable].values) same.push_back(other);
      return same.empty() ? automata::constant(chance(50)) : automata::equality(variable, pick(same));
    }
    case 4:
      return automata::negation(smaller());
    case 5:
    case 6:
      return automata::conjunction({smaller(), smaller()});
    case 7:
      return automata::disjunction({smaller(), smaller()});
    case 8:
      return automata::implication(smaller(), smaller());
    default:
      return automata::equivalence(smaller(), smaller());
  }
}

/// Builds one plant. A component's first attribute is its command where it has one.
class PlantDraw {
 public:
  explicit PlantDraw(const Shape& shape) : shape_(shape) {}

  Plant draw() {
    plant_.name = "Random";
    const std::size_t components = chance(90) ? up_to(2, shape_.max_components) : 1;
    for (std::size_t i = 0; i < components; ++i) add_component(i);
    for (std::size_t i = 0; i < components; ++i) add_behaviour(plant_.components[i], own_[i]);
    add_interconnections();
    for (const auto& own : own_)
      for (VariableId attribute : own)
        if (!is_control(attribute) && chance(shape_.open ? 95 : 70)) plant_.observables.push_back(attribute);
    return std::move(plant_);
  }

 private:
  void add_component(std::size_t position) {
    Component component;
    component.name = "c" + std::to_string(position);
    component.type = "Type" + std::to_string(position);
    const std::size_t modes = up_to(2, shape_.max_modes);
    automata::Variable mode_variable{component.name, {}};
    for (std::size_t i = 0; i < modes; ++i) {
      automata::Mode mode;
      mode.name = "m" + std::to_string(i);
      mode.fault = shape_.faults && i > 0 && i + 1 == modes && chance(60);
      if (shape_.rewards) mode.reward = -static_cast<double>(up_to(0, 4));
      mode_variable.values.push_back(mode.name);
      component.modes.push_back(std::move(mode));
    }
    component.mode = plant_.variables.add(std::move(mode_variable));
    add_attributes(component.name);
    plant_.components.push_back(std::move(component));
  }

  void add_attributes(const std::string& owner) {
    own_.emplace_back();
    const std::size_t count = std::min(up_to(shape_.commanded ? 1 : 0, 3), shape_.max_attributes - attributes_);
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<std::string> values = {"v0", "v1"};
      if (chance(40)) values.emplace_back("v2");
      const bool commanded = i == 0 && (shape_.commanded || chance(shape_.open ? 30 : 70));
      const std::string name = owner + (commanded ? ".cmd" : ".a" + std::to_string(i));
      own_.back().push_back(plant_.variables.add({name, std::move(values)}));
      if (commanded) plant_.controls.push_back({own_.back().back(), ValueId(std::size_t{0})});
    }
    attributes_ += count;
  }

  [[nodiscard]] bool is_control(VariableId variable) const {
    return std::any_of(plant_.controls.begin(), plant_.controls.end(),
                       [&](const automata::Control& control) { return control.variable == variable; });
  }

  void add_behaviour(Component& component, const std::vector<VariableId>& own) {
    std::vector<VariableId> told;
    for (VariableId variable : own)
      if (!is_control(variable)) told.push_back(variable);
    for (automata::Mode& mode : component.modes)
      if (!told.empty() && chance(60))
        mode.constraint = draw_formula(plant_.variables, told, chance(shape_.open ? 70 : 30) ? 1 : 0);

    component.initial.assign(component.modes.size(), 0.0);
    component.initial[0] = 1;
    if (shape_.distributions && chance(50)) {
      component.initial[0] = 0.75;
      component.initial[component.modes.size() - 1] = 0.25;
    }
    for (std::size_t from = 0; from < component.modes.size(); ++from) {
      const std::size_t exits = chance(80) ? up_to(1, 3) : 0;
      double fault_left = 1;
      for (std::size_t i = 0; i < exits; ++i) add_exit(component, own, ModeId(from), fault_left);
      add_restart(component, own, ModeId(from));
    }
  }

  /// Where the mode has an exit that takes time: its clock may start anew.
  void add_restart(Component& component, const std::vector<VariableId>& own, ModeId mode) {
    const bool timed = std::any_of(component.transitions.begin(), component.transitions.end(),
                                   [&](const Transition& t) { return t.from == mode && t.timing; });
    if (!timed || own.empty() || !chance(shape_.restarts)) return;
    Transition t;
    t.from = t.to = mode;
    t.restart = true;
    t.branch = branch_++;
    t.guard = draw_formula(plant_.variables, own, chance(30) ? 1 : 0);
    if (is_control(own.front()) && (shape_.commanded || chance(70))) {
      const std::size_t values = plant_.variables[own.front()].values.size();
      t.guard = automata::is(own.front(), ValueId(up_to(1, values - 1)));
    } else if (shape_.tangled && chance(40)) {
      t.guard = draw_formula(plant_.variables, mode_variables(), 0);
    }
    component.transitions.push_back(t);
  }

  void add_exit(Component& component, const std::vector<VariableId>& own, ModeId from, double& fault_left) {
    Transition t;
    t.from = from;
    t.to = ModeId((from.index() + up_to(1, component.modes.size() - 1)) % component.modes.size());
    t.branch = branch_++;
    if (!own.empty() && chance(60)) t.guard = draw_formula(plant_.variables, own, chance(30) ? 1 : 0);
    if (shape_.tangled && chance(40)) t.guard = draw_formula(plant_.variables, mode_variables(), 0);
    if (component.is_fault(t)) {
      draw_fault(t, fault_left);
      if (t.weight.kind != Weight::Kind::none) component.transitions.push_back(t);
      return;
    }
    if (shape_.timed && chance(50)) t.timing = draw_timing();
    if (shape_.commanded && !t.timing) {
      if (own.empty() || !is_control(own.front())) return;
      const std::size_t values = plant_.variables[own.front()].values.size();
      t.guard = automata::conjunction({automata::is(own.front(), ValueId(up_to(1, values - 1))), t.guard});
    }
    if (shape_.distributions && chance(20)) {
      // One written branch: a second outcome, staying where it is or another nominal mode.
      Transition other = t;
      other.to = ModeId(up_to(0, component.modes.size() - 1));
      if (!component.is_fault(other) && !(t.timing && other.to == from)) {
        t.weight = {Weight::Kind::probability, 0.75};
        other.weight = {Weight::Kind::probability, 0.25};
        component.transitions.push_back(t);
        component.transitions.push_back(other);
        return;
      }
    }
    component.transitions.push_back(t);
  }

  /// Keeps the sum of the fault probabilities of a mode at most 1, whatever guards hold together; but for a few, in
  /// which the faults share a step.
  void draw_fault(Transition& t, double& left) {
    if (chance(2)) left = 1;
    constexpr double most_of_a_rate = 0.25;  // more than any of these gives in a step of the tests
    if (left >= most_of_a_rate && chance(25)) {
      t.weight = {Weight::Kind::rate, pick<double>({0.001, 0.125, 0})};
      left -= most_of_a_rate;
    } else {
      const double probability = pick<double>({0.25, 0.001, 0.125, 1, 0});
      if (probability > left) return;
      t.weight = {Weight::Kind::probability, probability};
      left -= probability;
    }
    if (shape_.timed && chance(25)) t.timing = draw_timing();
  }

  Timing draw_timing() {
    Timing timing;
    timing.lower = Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 3)));
    timing.upper = timing.lower + Ticks::of_seconds(static_cast<std::int64_t>(up_to(0, 2)));
    if (!shape_.densities || chance(50)) return timing;
    if (chance(40)) timing.upper = Ticks::infinite();
    using Kind = automata::Density::Kind;
    timing.density = pick<automata::Density>({{Kind::exponential, 2},
                                              {Kind::exponential, 2},
                                              {Kind::normal, 3, 1.5},
                                              {Kind::weibull, 0, 0, 1.5, 3},
                                              {Kind::erlang, 2, 0, 3}});
    return timing;
  }

  [[nodiscard]] std::vector<VariableId> mode_variables() const {
    std::vector<VariableId> result;
    for (const Component& component : plant_.components) result.push_back(component.mode);
    return result;
  }

  /// Two modes of different components that cannot be together; neither is one to start in.
  void add_exclusion() {
    if (plant_.components.size() < 2) return;
    const std::size_t first = up_to(0, plant_.components.size() - 2);
    const auto later_mode = [&](const Component& component) {
      return automata::is(component.mode, ValueId(up_to(1, component.modes.size() - 1)));
    };
    plant_.interconnections.push_back(automata::negation(
        automata::conjunction({later_mode(plant_.components[first]),
                               later_mode(plant_.components[up_to(first + 1, plant_.components.size() - 1)])})));
  }

  void add_interconnections() {
    if (shape_.tangled) {
      for (std::size_t i = up_to(0, 2); i > 0; --i) add_exclusion();
    }
    const std::vector<VariableId> attributes = [&] {
      std::vector<VariableId> result;
      for (const auto& own : own_) result.insert(result.end(), own.begin(), own.end());
      return result;
    }();
    if (attributes.size() < 2) return;
    const std::size_t count = up_to(0, 2);
    for (std::size_t i = 0; i < count; ++i)
      plant_.interconnections.push_back(draw_formula(plant_.variables, attributes, chance(30) ? 1 : 0));
  }

  const Shape& shape_;
  Plant plant_;
  std::vector<std::vector<VariableId>> own_;  ///< attributes, per component
  std::size_t attributes_ = 0;
  std::uint32_t branch_ = 0;
};

}  // namespace

void showValue(const Model& model, std::ostream& out) {
  out << automata::to_json(automata::Document{{model.plant}, {}, {}, {}}).dump();
}

rc::Gen<Model> models(Shape shape) {
  return rc::gen::suchThat(rc::gen::exec([shape] { return Model{PlantDraw(shape).draw()}; }), [](const Model& model) {
    return !reference::initial_belief(reference::Step(model.plant)).empty();
  });
}

namespace {

using Renaming = std::function<VariableId(VariableId)>;

Formula with_variables(const Formula& formula, const Renaming& own) {
  return automata::renamed(formula, own, [](VariableId, ValueId value) { return value; });
}

/// Adds all of one plant to another, with a prefix to its names and variables of its own.
void add_renamed(Plant& all, const Plant& part, const std::string& prefix, const Renaming& own) {
  for (const auto& variable : part.variables) all.variables.add({prefix + variable.name, variable.values});
  for (Component component : part.components) {
    component.name = prefix + component.name;
    component.mode = own(component.mode);
    for (auto& mode : component.modes) mode.constraint = with_variables(mode.constraint, own);
    for (auto& t : component.transitions) t.guard = with_variables(t.guard, own);
    all.components.push_back(std::move(component));
  }
  for (const auto& q : part.interconnections) all.interconnections.emplace_back(with_variables(q.constraint, own));
  for (const auto& control : part.controls) all.controls.push_back({own(control.variable), control.idle});
  for (const VariableId v : part.observables) all.observables.push_back(own(v));
}

}  // namespace

rc::Gen<Model> mirrored(Shape shape) {
  return rc::gen::exec([shape] {
    const Model drawn = *models(shape);
    const Plant& half = drawn.plant;
    Plant plant{"Mirrored", half.variables, half.components, half.interconnections, half.controls, half.observables};
    const std::size_t offset = half.variables.size();
    const auto other = [&](VariableId v) {
      return VariableId(v.index() < offset ? v.index() + offset : v.index() - offset);
    };
    const auto mirror = [&](const Formula& f) { return with_variables(f, other); };
    add_renamed(plant, half, "m.", other);
    if (chance(50)) {
      const Formula bridge = draw_formula(plant.variables, all_variables(plant), 1);
      plant.interconnections.push_back(bridge);
      plant.interconnections.push_back(mirror(bridge));
    }
    // Guards that look across, alike on both sides.
    if (chance(50)) {
      const std::size_t components = half.components.size();
      const std::size_t c = up_to(0, components - 1);
      auto& transitions = plant.components[c].transitions;
      if (!transitions.empty()) {
        const std::size_t t = up_to(0, transitions.size() - 1);
        const Formula across = draw_formula(plant.variables, all_variables(plant), 0);
        plant.components[c + components].transitions[t].guard =
            automata::conjunction({plant.components[c + components].transitions[t].guard, mirror(across)});
        transitions[t].guard = automata::conjunction({transitions[t].guard, across});
      }
    }
    return Model{std::move(plant)};
  });
}

rc::Gen<Model> side_by_side(Shape shape, std::size_t least, std::size_t most) {
  return rc::gen::exec([shape, least, most] {
    Plant all;
    all.name = "SideBySide";
    const std::size_t count = up_to(least, most);
    for (std::size_t i = 0; i < count; ++i) {
      const Model drawn = *models(shape);
      const std::size_t offset = all.variables.size();
      add_renamed(all, drawn.plant, "p" + std::to_string(i) + ".",
                  [offset](VariableId v) { return VariableId(v.index() + offset); });
    }
    return Model{std::move(all)};
  });
}

rc::Gen<Formula> formulas(const automata::Variables& table, std::vector<VariableId> variables, int depth) {
  return rc::gen::exec(
      [table, variables = std::move(variables), depth] { return draw_formula(table, variables, depth); });
}

std::vector<VariableId> all_variables(const Plant& plant) {
  std::vector<VariableId> result;
  for (std::size_t i = 0; i < plant.variables.size(); ++i) result.emplace_back(i);
  return result;
}

rc::Gen<std::vector<Assignment>> partial_assignments(const automata::Variables& table) {
  return rc::gen::exec([table] {
    std::vector<Assignment> result;
    for (std::size_t i = 0; i < table.size(); ++i) {
      const VariableId variable(i);
      if (chance(60)) result.push_back({variable, ValueId(up_to(0, table[variable].values.size() - 1))});
    }
    return result;
  });
}

rc::Gen<automata::Modes> modes_of(const Plant& plant) {
  return rc::gen::exec([plant] {
    automata::Modes modes;
    for (const Component& component : plant.components) modes.emplace_back(up_to(0, component.modes.size() - 1));
    return modes;
  });
}

rc::Gen<automata::ControlAction> actions_of(const Plant& plant) {
  return rc::gen::exec([plant] {
    automata::ControlAction action;
    for (const automata::Control& control : plant.controls) action.push_back(control.idle);
    if (!action.empty() && chance(60)) {
      const std::size_t which = up_to(0, action.size() - 1);
      action[which] = ValueId(up_to(0, plant.variables[plant.controls[which].variable].values.size() - 1));
    }
    return action;
  });
}

}  // namespace rmpl::property
