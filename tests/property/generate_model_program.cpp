// Locations first, then what they tell, then arcs between them.
// SPDX-License-Identifier: MIT
#include "tests/property/generate_model_program.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"

namespace rmpl::property {

using automata::Condition;
using automata::Formula;
using automata::LocationId;
using automata::ModelLocation;
using automata::ModelProgram;
using automata::TransitionFunction;

namespace {

std::vector<automata::VariableId> all_of(const automata::Variables& variables) {
  std::vector<automata::VariableId> result;
  for (std::size_t v = 0; v < variables.size(); ++v) result.emplace_back(v);
  return result;
}

class Drawing {
 public:
  explicit Drawing(std::size_t most_primitive) : left_(most_primitive) {}

  ModelProgram draw() {
    program_.name = "Random";
    const std::size_t variables = up_to(1, 4);
    for (std::size_t v = 0; v < variables; ++v) {
      std::vector<std::string> values{"a", "b"};
      if (chance(40)) values.emplace_back("c");
      program_.variables.add({"x" + std::to_string(v), values});
      program_.observables.emplace_back(v);
    }
    if (chance(50)) {
      program_.controls.push_back({automata::VariableId(0), std::nullopt});
      if (chance(50)) program_.controls.back().idle = automata::ValueId(0);
    }
    for (std::size_t c = up_to(0, 5); c > 3; --c) program_.constraints.emplace_back(formula(1));
    composite(std::nullopt);
    for (std::size_t l = 0; l < program_.locations.size(); ++l) {
      if (!program_.locations[l].composite) primitive_.emplace_back(l);
    }
    choose_choices();
    for (ModelLocation& location : program_.locations) arcs(location);
    draw_at_start();
    return program_;
  }

 private:
  Formula formula(int depth) { return *formulas(program_.variables, all_of(program_.variables), depth); }

  Formula told() {
    if (chance(35)) return automata::constant(true);
    if (chance(20)) return formula(1);
    const automata::VariableId variable(up_to(0, program_.variables.size() - 1));
    return automata::is(variable, automata::ValueId(up_to(0, program_.variables[variable].values.size() - 1)));
  }

  Condition condition() { return {chance(50), formula(1)}; }

  void composite(std::optional<LocationId> parent) {
    const LocationId self(program_.locations.size());
    ModelLocation& location = program_.locations.emplace_back();
    location.composite = true;
    location.parent = parent;
    location.start = parent.has_value();
    if (chance(30)) location.maintenance = condition();
    const std::size_t members = up_to(1, 3);
    for (std::size_t m = 0; m < members; ++m) {
      const bool start = m == 0 || chance(50);
      const LocationId child(program_.locations.size());
      if (left_ > 1 && depth_ < 3 && chance(35)) {
        ++depth_;
        composite(self);
        --depth_;
      } else if (left_ > 0 || m == 0) {
        left_ -= left_ > 0 ? 1 : 0;
        ModelLocation& primitive = program_.locations.emplace_back();
        primitive.parent = self;
        primitive.told = told();
      } else {
        break;
      }
      program_.locations[child.index()].start = start;
    }
  }

  LocationId any() { return LocationId(up_to(0, program_.locations.size() - 1)); }

  std::vector<automata::GuardedArc> some_arcs(std::size_t least) {
    std::vector<automata::GuardedArc> result;
    for (std::size_t a = up_to(least, 2); a > 0; --a) {
      automata::GuardedArc& arc = result.emplace_back();
      for (std::size_t c = up_to(0, 4); c > 2; --c) arc.guard.push_back(condition());
      arc.target = any();
    }
    return result;
  }

  void choose_choices() {
    for (const LocationId l : primitive_) {
      if (chance(25)) {
        program_.locations[l.index()].told = automata::constant(true);
        choices_.push_back(l);
      } else if (chance(60)) {
        plain_.push_back(l);
      }
    }
  }

  std::vector<LocationId> some_plain() {
    std::vector<LocationId> result;
    std::copy_if(plain_.begin(), plain_.end(), std::back_inserter(result), [](LocationId) { return chance(40); });
    return result;
  }

  void arcs(ModelLocation& location) {
    if (location.composite) {
      location.arcs = some_arcs(0);
      return;
    }
    const LocationId self(static_cast<std::size_t>(&location - program_.locations.data()));
    const bool choice = std::find(choices_.begin(), choices_.end(), self) != choices_.end();
    const bool plain = std::find(plain_.begin(), plain_.end(), self) != plain_.end();
    std::vector<std::size_t> weights{up_to(1, 9)};
    if (!plain) weights.push_back(up_to(0, 3));
    if (!plain && chance(30)) weights.push_back(up_to(1, 3));
    double sum = 0;
    for (const std::size_t weight : weights) sum += static_cast<double>(weight);
    for (const std::size_t weight : weights) {
      TransitionFunction& function = location.functions.emplace_back();
      function.probability = static_cast<double>(weight) / sum;
      if (choice) function.started = some_plain();
      if (!choice || chance(30)) function.arcs = some_arcs(0);
    }
  }

  /// Now and then a location is a `choose` that is drawn before time 0.
  void draw_at_start() {
    for (const LocationId l : choices_) {
      const ModelLocation& location = program_.locations[l.index()];
      if (location.start || !chance(60)) continue;
      automata::InitialDraw& draw = program_.initial.emplace_back();
      draw.choice = l;
      for (const double p : {0.25, 0.75}) {
        automata::InitialBranch& branch = draw.branches.emplace_back();
        branch.probability = p;
        if (chance(80)) branch.started.push_back(any());
      }
    }
  }

  std::size_t left_;
  int depth_ = 0;
  ModelProgram program_;
  std::vector<LocationId> primitive_;
  std::vector<LocationId> choices_;  ///< tell nothing, and may count others as started
  std::vector<LocationId> plain_;    ///< have one function, and may count as started
};

}  // namespace

rc::Gen<RandomModelProgram> model_programs(std::size_t most_primitive) {
  return rc::gen::exec([most_primitive] { return RandomModelProgram{Drawing(most_primitive).draw()}; });
}

rc::Gen<std::vector<ModelInput>> model_inputs(const ModelProgram& program, std::size_t most) {
  return rc::gen::exec([program, most] {
    std::vector<ModelInput> result;
    for (std::size_t i = up_to(1, most); i > 0; --i) {
      ModelInput& input = result.emplace_back();
      for (const automata::CommandedVariable& control : program.controls) {
        const std::size_t values = program.variables[control.variable].values.size();
        input.command.push_back(chance(40) ? control.idle : automata::ValueId(up_to(0, values - 1)));
      }
      for (const automata::VariableId seen : program.observables) {
        const std::size_t values = program.variables[seen].values.size();
        if (chance(30)) input.observation.push_back({seen, automata::ValueId(up_to(0, values - 1))});
      }
    }
    return result;
  });
}

namespace {

void show(const std::vector<automata::GuardedArc>& arcs, const automata::Variables& variables, std::ostream& out) {
  for (const automata::GuardedArc& arc : arcs) {
    out << " ->" << arc.target.value + 1;
    for (const Condition& c : arc.guard) {
      out << (c.entailed ? " if " : " unless ") << to_text(c.constraint, variables);
    }
    out << ';';
  }
}

}  // namespace

void showValue(const RandomModelProgram& random, std::ostream& out) {
  const ModelProgram& program = random.program;
  out << '\n';
  for (const auto& variable : program.variables) out << variable.name << ':' << variable.values.size() << ' ';
  for (const auto& c : program.controls) out << "control " << c.variable.value << (c.idle ? " idle a" : "") << ' ';
  for (const auto& c : program.constraints) out << "constraint " << to_text(c.constraint, program.variables) << ' ';
  out << '\n';
  for (std::size_t l = 0; l < program.locations.size(); ++l) {
    const ModelLocation& location = program.locations[l];
    out << l + 1 << (location.start ? " start" : "") << (location.composite ? " composite" : "");
    if (location.parent) out << " in " << location.parent->value + 1;
    if (location.composite) {
      if (!location.maintenance.is_trivial()) {
        out << (location.maintenance.entailed ? " while " : " while not ")
            << to_text(location.maintenance.constraint, program.variables);
      }
      show(location.arcs, program.variables, out);
    } else {
      out << " tells " << to_text(location.told, program.variables);
    }
    for (const TransitionFunction& function : location.functions) {
      out << " {" << function.probability << " started";
      for (const LocationId s : function.started) out << ' ' << s.value + 1;
      show(function.arcs, program.variables, out);
      out << '}';
    }
    out << '\n';
  }
  for (const auto& draw : program.initial) {
    out << "initially " << draw.choice.value + 1;
    for (const auto& branch : draw.branches) {
      out << " {" << branch.probability;
      for (const LocationId s : branch.started) out << ' ' << s.value + 1;
      out << '}';
    }
    out << '\n';
  }
}

void showValue(const ModelInput& input, std::ostream& out) {
  out << "command";
  for (const auto& value : input.command) out << ' ' << (value ? std::to_string(value->value) : "?");
  out << " seen ";
  rc::show(input.observation, out);
}

}  // namespace rmpl::property
