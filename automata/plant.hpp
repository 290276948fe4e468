// Timed concurrent constraint automata: the plant model (thesis 6.1.2, 6.1.3).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/logic/ids.hpp"
#include "automata/logic/variables.hpp"
#include "automata/origin.hpp"
#include "automata/time/density.hpp"

namespace rmpl::automata {

/// One mode of a component, with its constraint M(x = v) and reward R(x = v).
struct Mode {
  std::string name;
  bool fault = false;
  Formula constraint = constant(true);
  double reward = 0;
  Origin origin;
  /// Of software, where this is a fault mode: the mode of the same marking into which no improbable draw leads.
  std::optional<ModeId> usual = {};
  bool operator==(const Mode&) const = default;
};

/// How likely, or how heavy, a transition is.
struct Weight {
  enum class Kind {
    none,         ///< nominal only
    probability,  ///< of a fault: per step, in [0, 1]; of a nominal transition: its share among the enabled ones
    rate          ///< faults only: per second, at least 0; 1 - exp(-rate * step)
  };
  Kind kind = Kind::none;
  double value = 0;
  bool operator==(const Weight&) const = default;

  /// Of a fault transition: the probability that it is taken in a step of this length. 0 where there is no weight.
  [[nodiscard]] double fault_probability(Ticks step) const;
};

/// A transition <v, g, v'>. Into a fault mode it is a fault transition, and has a probability or a rate; but a restart
/// is nominal, and so is the consequence of a fault.
struct Transition {
  ModeId from;
  ModeId to;
  Formula guard = constant(true);  ///< over attributes
  std::optional<Timing> timing;
  Weight weight;
  /// Transitions of one component with the same branch and source were written as one `-> { a with p, b with q }`:
  /// timed, they are one risk whose outcome the weights decide.
  std::uint32_t branch = 0;
  Origin origin;
  bool restart = false;  ///< from a mode to itself, untimed: the clock starts anew (semantics 3)
  /// Of software: it leads to a fault mode, and is nominal, as its program goes on from a fault mode so (semantics 8).
  bool consequence = false;
  bool operator==(const Transition&) const = default;
};

/// A timed constraint automaton. Its mode variable's values are its modes, in order; its clock tells the time since
/// it entered its mode, or last began it anew.
struct Component {
  std::string name;  ///< instance path, also the name of the mode variable
  std::string type;
  VariableId mode;
  std::vector<Mode> modes;
  std::vector<double> initial;  ///< per mode; sums to 1
  std::vector<Transition> transitions;
  Origin origin;
  bool progress = false;  ///< it is meant to go forward only: its steps need no licence (semantics 5)
  bool software = false;  ///< a thread of a model program: its modes are markings, of which a step takes a cycle
  bool operator==(const Component&) const = default;

  [[nodiscard]] bool is_fault(const Transition& t) const {
    return modes[t.to.index()].fault && !t.restart && !t.consequence;
  }
};

/// A control variable with the value it has when nothing is commanded.
struct Control {
  VariableId variable;
  ValueId idle;
  bool operator==(const Control&) const = default;
};

/// A constraint of Q, which holds in every state.
struct Interconnection {
  Interconnection(Formula q, Origin where = {}) : constraint(std::move(q)), origin(std::move(where)) {}
  Formula constraint;
  Origin origin;
  bool operator==(const Interconnection&) const = default;
};

/// The plant: components, variables (mode variables and attributes), interconnections Q.
struct Plant {
  std::string name;
  Variables variables;
  std::vector<Component> components;
  std::vector<Interconnection> interconnections;
  std::vector<Control> controls;        ///< declaration order
  std::vector<VariableId> observables;  ///< declaration order
  bool operator==(const Plant&) const = default;

  [[nodiscard]] std::optional<ComponentId> find_component(std::string_view component) const;
  [[nodiscard]] const Component& operator[](ComponentId id) const { return components[id.index()]; }
  /// The component whose mode variable this is, if it is one.
  [[nodiscard]] std::optional<ComponentId> component_of(VariableId variable) const;
  /// Whether the clock of a component matters in a mode: some transition out of it, be it to itself, has time bounds
  /// (one to itself competes with the others).
  [[nodiscard]] bool has_timed_exit(ComponentId component, ModeId mode) const;
};

}  // namespace rmpl::automata
