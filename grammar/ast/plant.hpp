// Plant models as written (language.md "Plant models"); nothing is resolved or instantiated.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "grammar/ast/constraint.hpp"
#include "grammar/ast/declaration.hpp"
#include "grammar/ast/token.hpp"

namespace rmpl::grammar {

enum class Direction { input, output, internal };

/// `input fuel, oxidizer : Level;`
struct AttributeDeclaration {
  Span span;
  Direction direction = Direction::input;
  std::vector<Name> names;
  DomainRef domain;
};

/// `off 0.9` in an initial distribution; without a number the mode is certain.
struct InitialMode {
  Span span;
  Name mode;
  std::optional<Number> probability;
};

/// `initial off;` or `initial off 0.9, on 0.1;`. One mode or more.
struct Initial {
  Span span;
  std::vector<InitialMode> modes;
};

/// `mode firing { thrust = full } reward -5;` or `fault failed;`. Without braces, or with nothing between them, no
/// constraint.
struct ModeDeclaration {
  Span span;
  bool fault = false;
  Name name;
  std::optional<Constraint> constraint;
  std::optional<Number> reward;
};

/// `standby, firing`: the modes by name.
struct NamedSources {
  std::vector<Name> modes;
};

/// `any`: every mode but the target; `any nominal`: every nominal mode but the target.
struct AnySource {
  bool nominal = false;
};

/// Where a transition starts.
struct TransitionSources {
  Span span;
  std::variant<NamedSources, AnySource> node;
};

enum class DensityKind { uniform, exponential, normal, weibull, erlang };

/// `~ uniform`, `~ exponential(mean)`, `~ normal(mean, sd)`: no, one, two parameters. `~ weibull(shape, scale)`,
/// `~ erlang(stages, mean)`: a number and one parameter.
struct DensityText {
  Span span;
  DensityKind kind = DensityKind::uniform;
  Number shape = {};
  std::vector<Duration> parameters;
};

/// `in [l, u]`, or `after d`, which is `in [d, d]`; with an optional density.
struct TimingText {
  Span span;
  Duration lower;
  Duration upper;
  bool after = false;  ///< written `after d`; then lower and upper are the same
  std::optional<DensityText> density;
};

/// `with 0.9`.
struct ProbabilityWeight {
  Number probability;
};

/// `with rate 1e-6 /h`: per unit of time.
struct RateWeight {
  Number rate;
  Name unit;  ///< ns us ms s min mins h d w weeks
};

using WeightText = std::variant<ProbabilityWeight, RateWeight>;

/// One target of a transition, with its weight where it has one.
struct Branch {
  Span span;
  Name target;
  std::optional<WeightText> weight;
};

/// `sources -> target when g in [l, u] with p;`, `a -> a restart when g;`, or `sources -> { a with p, b with q } when g
/// in [l, u];`.
struct TransitionText {
  Span span;
  TransitionSources sources;
  std::vector<Branch> branches;  ///< one, or where `braced` those in the braces, each with a probability
  bool braced = false;
  bool restart = false;
  std::optional<Constraint> guard;
  std::optional<TimingText> timing;
};

using ComponentItem = std::variant<AttributeDeclaration, Initial, ModeDeclaration, TransitionText>;

/// `component Engine { … }`, `progress component Trajectory { … }`
struct ComponentDefinition {
  Span span;
  bool progress = false;  ///< its steps need no licence
  Name name;
  std::vector<ComponentItem> items;
};

/// `engine, spare : Engine { initial standby; };`, `progress phase : Phase;`, or `camera : model CameraTask;`
struct InstanceDeclaration {
  Span span;
  bool progress = false;  ///< the steps of the components need no licence
  std::vector<Name> names;
  bool model = false;  ///< `type` is a definition of a model program
  Name type;
  std::optional<Initial> initial;  ///< overrides the type's
};

/// `pde.engine_cmd = engine.cmd;`
struct Interconnection {
  Span span;
  Constraint constraint;
};

using ModuleItem = std::variant<AttributeDeclaration, InstanceDeclaration, Control, Observe, Interconnection>;

/// `module Propulsion { … }`, or `plant Lander { … }`, the root module.
struct ModuleDefinition {
  Span span;
  bool plant = false;
  Name name;
  std::vector<ModuleItem> items;
};

using PlantItem = std::variant<Import, Domain, ComponentDefinition, ModuleDefinition>;

/// A whole `.tcca` file, in order of the text.
struct PlantFile {
  std::vector<PlantItem> items;
};

}  // namespace rmpl::grammar
