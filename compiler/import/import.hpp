// Circuits of others as plants: netlists in, `.tcca` out.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "compiler/import/netlist.hpp"

namespace compiler {

/// The `.tcca` text of a netlist: `.bench` (ISCAS) or `.xml` (a system catalogue of the diagnostic competition), told
/// by the file's ending. Throws InputError where the file cannot be read, or is no such netlist, with the line.
std::string import_circuit(const std::string& path, FaultModel faults);

}  // namespace compiler
