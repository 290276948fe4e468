// Circuits of others as plants: netlists in, `.tcca` out.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "compiler/import/netlist.hpp"
#include "grammar/source/findings.hpp"

namespace rmpl::compiler {

/// The `.tcca` text of a netlist; where it has errors, `plant` is empty and `findings` tells them all.
struct ImportedCircuit {
  std::optional<std::string> plant;
  grammar::Findings findings;
};

/// Imports a netlist: `.bench` (ISCAS) or `.xml` (a system catalogue of the diagnostic competition), told by the file's
/// ending; `-` is standard input, told by its content. Throws base::InputError where the file cannot be read or has
/// another ending.
ImportedCircuit import_circuit(const std::string& path, FaultModel faults);

}  // namespace rmpl::compiler
