// What the commands of tcca-check read: models, and formulas over them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "compiler/session/compiler.hpp"
#include "tools/tcca-check/command_line.hpp"

namespace rmpl::verifier {

/// Diagnostics that were printed already: nothing is left to say.
struct Rejected {};

/// Whether the stream, a file descriptor, is to be coloured.
bool colored(const CommandLine& line, int stream);

/// Compiles the models of the command line; prints what there is to say of them. Throws Rejected where one is wrong,
/// and base::InputError where there is not one plant.
compiler::Compilation load(const CommandLine& line);

/// A formula over the plant. Throws Rejected, with its diagnostics printed.
automata::Formula formula(const std::string& text, const automata::Plant& plant, const char* option,
                          const CommandLine& line);

/// The modes that `--from` names; none where it is not given. Throws Rejected as `formula` does.
std::vector<automata::Assignment> starting_modes(const automata::Plant& plant, const CommandLine& line);

}  // namespace rmpl::verifier
