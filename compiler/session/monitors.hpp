// Monitors from text: a file over a plant.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/monitor.hpp"
#include "automata/plant.hpp"
#include "grammar/source/findings.hpp"

namespace rmpl::compiler {

/// Compiles a file of monitors (`.mon`; `-` is standard input) over a plant. Its text and what there is to say of it,
/// lint too, are added to `findings`. Nothing where it has errors. Throws base::InputError where the file cannot be
/// read.
std::optional<std::vector<automata::Monitor>> compile_monitors(const std::string& path, const automata::Plant& plant,
                                                               grammar::Findings& findings);

}  // namespace rmpl::compiler
