// A model program as a picture, in the manner of ijcai01.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "automata/phca.hpp"

namespace rmpl::compiler {

/// The PHCA in DOT, as `program_diagram` draws a THCA. A primitive location shows what it tells. A `choose` is a
/// diamond from which an arrow with a probability leads to a dot for each of its functions, and arrows with guards from
/// there: the two levels of its tree. A location that only counts as started, in a composite of the branch, has a
/// broken arrow to it. Before time 0 the arrows of the dots lead to what is marked at the start.
std::string model_diagram(const automata::ModelProgram& model, std::optional<std::size_t> depth);

}  // namespace rmpl::compiler
