// What an input set has to hold for a question: the one plant, the one program.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "automata/scenario.hpp"

namespace rmpl::compiler {

/// The one plant, control program or model program that the files hold. Throw base::InputError where there is not
/// exactly one.
const automata::Plant& only_plant(const automata::Document& document, const std::string& paths);
const automata::Program& only_program(const automata::Document& document, const std::string& paths);
const automata::ModelProgram& only_model_program(const automata::Document& document, const std::string& paths);

/// Whether the files hold a model program and no plant of another kind.
bool is_model_program(const automata::Document& document);

/// Says that no start of a model program is consistent. Throws base::InputError.
[[noreturn]] void refuse_start(const automata::ModelProgram& program, const std::string& paths);

/// Assignments sorted, each once. Throws base::InputError where two contradict each other; `where` names the place.
std::vector<automata::Assignment> each_once(std::vector<automata::Assignment> assignments,
                                            const automata::Variables& variables, std::string_view where);

}  // namespace rmpl::compiler
