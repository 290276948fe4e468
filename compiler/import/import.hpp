// Circuits and fault trees of others as plants: `.tcca` out.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "compiler/import/netlist.hpp"
#include "grammar/source/findings.hpp"

namespace rmpl::compiler {

/// The `.tcca` text of a file of others; where it has errors, `plant` is empty and `findings` tells them all.
struct ImportedPlant {
  std::optional<std::string> plant;
  grammar::Findings findings;
};

/// Imports a netlist, `.bench` (ISCAS) or `.xml` (a system catalogue of the diagnostic competition), or a fault tree,
/// `.xml` (Open-PSA) or `.dft` (Galileo), told by the file's ending and, of XML, by its root; `-` is standard input,
/// told by its content. `faults` are those of gates of circuits. Throws base::InputError where the file cannot be read,
/// has another ending, or has a name that cannot be said.
ImportedPlant import_plant(const std::string& path, FaultModel faults);

/// Whether the path names a Livingstone2 model: it ends in `.xmpl` or `.l2`.
bool is_livingstone(const std::string& path);

/// Imports a Livingstone2 model, with the harness (`.hrn`) and the start (`.ini`) of its name beside it, where they
/// are. Throws base::InputError where a file cannot be read.
ImportedPlant import_livingstone(const std::string& path);

}  // namespace rmpl::compiler
