// Probabilistic hierarchical constraint automata: model programs (ijcai01, "Probabilistic HCA"; semantics 8).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/logic/ids.hpp"
#include "automata/logic/variables.hpp"
#include "automata/origin.hpp"
#include "automata/plant.hpp"
#include "automata/program.hpp"

namespace rmpl::automata {

/// A leaf of a transition tree: an arc that is taken where all of its guard holds. Without a guard it always is.
struct GuardedArc {
  std::vector<Condition> guard;
  LocationId target;
  bool operator==(const GuardedArc&) const = default;
};

/// One transition function of a primitive location: a child of the probabilistic root of the two-level tree. All of its
/// arcs whose guards hold are taken. Of a `choose`, the branch drawn counts as started in the instant of the draw: its
/// start locations take their arcs as if they were marked, and what holds them may end, but they tell nothing and are
/// in no marking.
struct TransitionFunction {
  double probability = 1;
  /// Primitive locations other than a `choose`, ascending: composites stand as what they start, nested choices are
  /// multiplied in.
  std::vector<LocationId> started;
  std::vector<GuardedArc> arcs;
  bool operator==(const TransitionFunction&) const = default;
};

/// A location of a model program: primitive (it tells a constraint, and draws one of its functions each step) or
/// composite (it holds other locations).
struct ModelLocation {
  bool composite = false;
  std::optional<LocationId> parent;  ///< none for location 1, the program itself
  /// Whether it is marked whenever its parent is entered. Not for a `choose` that is drawn before time 0, nor for what
  /// stands in its branches.
  bool start = false;
  Formula told = constant(true);  ///< of a primitive location: holds in every instant in which it is marked
  Condition maintenance;          ///< of a composite: where it fails, all that is inside is left after the instant
  /// Of a primitive location: at least one; the probabilities sum to 1. One without arcs ends its thread.
  std::vector<TransitionFunction> functions;
  std::vector<GuardedArc> arcs;  ///< of a composite: what follows when it ends
  std::string label;             ///< what it is, for people: `always`, `choose`, `camera.power = on`
  Origin origin;
  bool operator==(const ModelLocation&) const = default;
};

/// What a draw before time 0 may start: these locations, fully, with all that holds them.
struct InitialBranch {
  double probability = 1;
  std::vector<LocationId> started;  ///< ascending
  bool operator==(const InitialBranch&) const = default;
};

/// A `choose` that is drawn before time 0. The draws are independent of each other.
struct InitialDraw {
  LocationId choice;                    ///< the location of the `choose`, which is never marked
  std::vector<InitialBranch> branches;  ///< probabilities sum to 1; nested draws are multiplied in
  bool operator==(const InitialDraw&) const = default;
};

/// A variable that is commanded. Where a log does not say, it is `idle`; without that, unknown.
struct CommandedVariable {
  VariableId variable;
  std::optional<ValueId> idle;
  bool operator==(const CommandedVariable&) const = default;
};

/// A value for each commanded variable of a model program, by position; nothing where it is unknown.
using Command = std::vector<std::optional<ValueId>>;

/// A PHCA. Location k (from 0) is printed as k + 1; a child comes after its parent (pre-order of the source, a `choose`
/// before its branches). Location 1 is composite.
/// A start marking is location 1 marked fully, and a branch of each initial draw.
struct ModelProgram {
  std::string name;
  Variables variables;
  std::vector<CommandedVariable> controls;   ///< declaration order
  std::vector<VariableId> observables;       ///< declaration order
  std::vector<Interconnection> constraints;  ///< in every store
  std::vector<ModelLocation> locations;
  std::vector<InitialDraw> initial;  ///< by `choice`
  Origin origin;
  bool operator==(const ModelProgram&) const = default;
};

}  // namespace rmpl::automata
