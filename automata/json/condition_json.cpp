// Labels and maintenance constraints.
// SPDX-License-Identifier: MIT
#include "automata/json/condition_json.hpp"

namespace rmpl::automata {

Json condition_to_json(const Condition& condition, const Variables& variables, std::span<const std::string> clocks) {
  return {{condition.entailed ? "entailed" : "not_entailed", to_json(condition.constraint, variables, clocks)}};
}

Condition condition_from_json(const Node& node, const Variables& variables, std::span<const std::string> clocks) {
  const bool entailed = node.has("entailed");
  const char* const key = entailed ? "entailed" : "not_entailed";
  node.only({key});
  return {entailed, formula_from_json(node.at(key), variables, clocks)};
}

}  // namespace rmpl::automata
