// A control program as a picture, in the manner of thesis Fig. 3-4.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "automata/program.hpp"
#include "compiler/diagram/look.hpp"

namespace rmpl::compiler {

/// The THCA in DOT: composites are rounded boxes with what they maintain, primitive locations circles with their goals
/// and clock starts, arcs arrows with their guards. A filled dot points to the start locations of a box. An overbar is
/// "not entailed". Each location and each arc stands in it once: node, cluster or edge `l4`, `arc_4_1` by their numbers
/// from 1. Boxes that lie deeper in others than `depth` are folded: single nodes, with nothing that is
/// inside of them. Linear in the program, times its depth.
/// `look` is of a model program: choices have their dots instead of arcs of their own.
std::string program_diagram(const automata::Program& program, std::optional<std::size_t> depth, const Look& look = {});

}  // namespace rmpl::compiler
