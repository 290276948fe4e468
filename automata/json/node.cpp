// The path of a place in a JSON input.
// SPDX-License-Identifier: MIT
#include "automata/json/node.hpp"

namespace rmpl::automata {

std::optional<std::string> Node::path_in(const Json& tree) const {
  if (&tree == json_) return "";
  if (!tree.is_structured()) return std::nullopt;
  for (auto at = tree.begin(); at != tree.end(); ++at) {
    if (const auto rest = path_in(*at)) {
      return member_path("", tree.is_object() ? at.key() : std::to_string(at - tree.begin())) + *rest;
    }
  }
  return std::nullopt;
}

}  // namespace rmpl::automata
