// Goals of a trace that are no assignments: text that the compiler reads.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/plant.hpp"
#include "base/error.hpp"
#include "compiler/session/compiler.hpp"
#include "runtime/executive/trace/trace_reader.hpp"

namespace rmpl::tools {

/// Keeps the reference.
inline runtime::TraceReader::Constraint trace_constraint(const automata::Plant& plant) {
  return [&plant](const std::string& text) {
    auto compiled = compiler::compile_formula(text, plant, "goal_constraints");
    if (!compiled.formula) throw base::InputError(" 'goal_constraints': '" + text + "' is no constraint of the plant");
    return *std::move(compiled.formula);
  };
}

}  // namespace rmpl::tools
