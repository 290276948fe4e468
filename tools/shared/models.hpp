// What subcommands read: models, and formulas of the command line, with their diagnostics on standard error.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "automata/scenario.hpp"
#include "compiler/session/compiler.hpp"
#include "compiler/session/contents.hpp"
#include "tools/shared/options.hpp"

namespace rmpl::tools {

/// Compiles the files and tells their diagnostics. Throws Rejected where they have errors, base::InputError where a
/// file cannot be read.
compiler::Compilation load(const std::vector<std::string>& paths, const Common& common,
                           const compiler::Options& options = {});

/// Tells diagnostics, in the form that was asked for; nothing where there are none.
void tell_findings(const grammar::Findings& findings, const Common& common);

using compiler::is_model_program;
using compiler::only_model_program;
using compiler::only_plant;
using compiler::only_program;
using compiler::refuse_start;

/// A formula or assignments that stand on the command line, as the option `where`. Throw Rejected where they are wrong.
/// Assignments come sorted, each once; base::InputError where two contradict each other.
automata::Formula formula_option(const std::string& text, const automata::Plant& plant, std::string_view where,
                                 const Common& common);
/// One that commands are to bring about: what none can achieve is wrong.
automata::Formula goal_option(const std::string& text, const automata::Plant& plant, std::string_view where,
                              const Common& common);
/// One that is asked of a program: it may ask of the executive's knowledge.
automata::Formula program_formula_option(const std::string& text, const automata::Plant& plant, std::string_view where,
                                         const Common& common);
automata::Formula formula_option(const std::string& text, const automata::ModelProgram& program, std::string_view where,
                                 const Common& common);
std::vector<automata::Assignment> assignments_option(const std::string& text, const automata::Plant& plant,
                                                     std::string_view where, const Common& common);
std::vector<automata::Assignment> assignments_option(const std::string& text, const automata::ModelProgram& program,
                                                     std::string_view where, const Common& common);

/// Throws base::InputError where more than one of the paths is `-`: standard input can be read once.
void check_standard_input(const std::vector<std::string>& paths);

}  // namespace rmpl::tools
