// Control and model programs as written (language.md "Control programs"; thesis 5.1.2); calls and names not resolved.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "grammar/ast/box.hpp"
#include "grammar/ast/constraint.hpp"
#include "grammar/ast/declaration.hpp"
#include "grammar/ast/token.hpp"

namespace rmpl::grammar {

struct Step;

/// `engine = standby`; any constraint parses, which ones are goals is checked later. In a model program it is told.
struct Goal {
  Constraint constraint;
};

/// `t1 = 0`.
struct ClockStart {
  Name clock;
};

/// What a call passes: a bare name (variable, value or a parameter of the caller), or a constraint.
struct Argument {
  Span span;
  std::variant<Name, Constraint> node;
};

/// `Deploy(x, y = on)`.
struct Call {
  Name definition;
  std::vector<Argument> arguments;
};

/// Steps that follow each other: `a; b`. One or more.
struct Sequence {
  Span span;
  std::vector<Step> steps;
};

/// What stands between braces: threads that run side by side, `a; b, c`. One or more.
struct Body {
  Span span;
  std::vector<Sequence> threads;
};

/// `{ body }` as a step.
struct Block {
  Body body;
};

/// `{ }`: the empty step.
struct Nothing {};

/// `each { A, B }`: threads of which each asserts goals of its own.
struct Each {
  Body body;
};

/// `do A watching c`.
struct Watching {
  Box<Step> step;
  Constraint condition;
};

/// `A maintaining c`, or `do A maintaining c`.
struct Maintaining {
  Box<Step> step;
  Constraint condition;
  bool with_do = false;  ///< written with `do`: for the formatter
};

/// `if c thennext A elsenext B`.
struct If {
  Constraint condition;
  Box<Step> step;
  std::optional<Box<Step>> otherwise;
};

/// `unless c thennext A`.
struct Unless {
  Constraint condition;
  Box<Step> step;
};

/// `when c donext A`.
struct When {
  Constraint condition;
  Box<Step> step;
};

/// `whenever c donext A`.
struct Whenever {
  Constraint condition;
  Box<Step> step;
};

/// `always A`.
struct Always {
  Box<Step> step;
};

/// `repeat A`.
struct Repeat {
  Box<Step> step;
};

/// `next A`.
struct Next {
  Box<Step> step;
};

/// One alternative of a `choose`: `A with 0.9`.
struct Choice;

/// `choose { A with 0.9, B with 0.1 }`, in model programs only (checked later). One alternative or more.
struct Choose {
  std::vector<Choice> choices;
};

/// A step with its place.
struct Step {
  Span span;
  std::variant<Goal, ClockStart, Call, Block, Nothing, Each, Watching, Maintaining, If, Unless, When, Whenever, Always,
               Repeat, Next, Choose>
      node;
};

struct Choice {
  Span span;
  Step step;
  Number probability;
};

/// `Name(parameters) :: { clock t; body }`, preceded by `model` in a model program.
struct Definition {
  Span span;
  bool model = false;
  Name name;
  std::vector<Name> parameters;
  std::vector<Name> clocks;  ///< its own, as declared at its start
  Body body;
};

/// `variable x, y : D;` of a model program.
struct VariableDeclaration {
  Span span;
  std::vector<Name> names;
  DomainRef domain;
};

/// `constraint c;` of a model program: it holds at every time.
struct StandingConstraint {
  Span span;
  Constraint constraint;
};

using ProgramItem = std::variant<Import, Definition, VariableDeclaration, StandingConstraint, Observe, Control, Domain>;

/// A whole `.rmpl` file, in order of the text.
struct ProgramFile {
  std::vector<ProgramItem> items;
};

}  // namespace rmpl::grammar
