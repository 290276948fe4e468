// What subcommands read: models, and formulas of the command line, with their diagnostics on standard error.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "automata/scenario.hpp"
#include "compiler/session/compiler.hpp"
#include "tools/shared/options.hpp"

namespace rmpl::tools {

/// Compiles the files and tells their diagnostics. Throws Rejected where they have errors, base::InputError where a
/// file cannot be read.
compiler::Compilation load(const std::vector<std::string>& paths, const Common& common,
                           const compiler::Options& options = {});

/// Tells diagnostics, in the form that was asked for; nothing where there are none.
void tell_findings(const grammar::Findings& findings, const Common& common);

/// The one plant, control program or model program that the files hold. Throw base::InputError where there is not
/// exactly one.
const automata::Plant& only_plant(const automata::Document& document, const std::string& paths);
const automata::Program& only_program(const automata::Document& document, const std::string& paths);
const automata::ModelProgram& only_model_program(const automata::Document& document, const std::string& paths);

/// The one plant that a control program runs on: of components, or what it sees of the one model program. Throws
/// base::InputError as above, and where the program cannot be flown.
const automata::Plant& only_controlled_plant(const automata::Document& document, const std::string& paths);

/// Whether the files hold a model program and no plant.
bool is_model_program(const automata::Document& document);

/// Says that no start of a model program is consistent. Throws base::InputError.
[[noreturn]] void refuse_start(const automata::ModelProgram& program, const std::string& paths);

/// A formula or assignments that stand on the command line, as the option `where`. Throw Rejected where they are wrong.
/// Assignments come sorted, each once; base::InputError where two contradict each other.
automata::Formula formula_option(const std::string& text, const automata::Plant& plant, std::string_view where,
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
