// Walking the steps of control programs as written.
// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "compiler/lint/lint.hpp"

namespace rmpl::compiler {

/// Calls `visit(definition)` for each definition of the files, imported ones too.
void for_each_definition(const LintInput& input, const auto& visit) {
  for (const File& file : input.files) {
    if (!file.program) continue;
    for (const grammar::ProgramItem& item : file.program->items) {
      if (const auto* definition = std::get_if<grammar::Definition>(&item)) visit(*definition);
    }
  }
}

/// Calls `visit` for a step and all steps within it, outermost first; with the bodies of blocks, too.
template <class Visit>
void for_each_step(const grammar::Step& step, const Visit& visit);

/// The same for a body: for itself, and all within it.
template <class Visit>
void for_each_step(const grammar::Body& body, const Visit& visit) {
  visit(body);
  for (const grammar::Sequence& thread : body.threads) {
    for (const grammar::Step& step : thread.steps) for_each_step(step, visit);
  }
}

/// What is inside of a step.
template <class Visit>
struct StepsInside {
  const Visit& visit;

  void operator()(const grammar::Goal&) const {}
  void operator()(const grammar::ClockStart&) const {}
  void operator()(const grammar::Call&) const {}
  void operator()(const grammar::Nothing&) const {}
  void operator()(const grammar::Each& each) const { for_each_step(each.body, visit); }
  void operator()(const grammar::Block& block) const { for_each_step(block.body, visit); }
  void operator()(const grammar::If& node) const {
    for_each_step(*node.step, visit);
    if (node.otherwise) for_each_step(**node.otherwise, visit);
  }
  void operator()(const grammar::Choose& choose) const {
    for (const grammar::Choice& choice : choose.choices) for_each_step(choice.step, visit);
  }
  void operator()(const auto& node) const { for_each_step(*node.step, visit); }
};

template <class Visit>
void for_each_step(const grammar::Step& step, const Visit& visit) {
  visit(step);
  std::visit(StepsInside<Visit>{visit}, step.node);
}

}  // namespace rmpl::compiler
