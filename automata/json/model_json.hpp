// Model programs as JSON, and back.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/json/document.hpp"
#include "automata/phca.hpp"

namespace rmpl::automata {

Json to_json(const ModelProgram& model);
ModelProgram model_program_from_json(const Node& node);

}  // namespace rmpl::automata
