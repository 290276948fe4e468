// The path of a place in a JSON input.
// SPDX-License-Identifier: MIT
#include "automata/json/node.hpp"

namespace rmpl::automata {

/// Without recursion: an input may be nested as deeply as it likes.
std::optional<std::string> Node::path_in(const Json& tree) const {
  struct Level {
    const Json* value;
    Json::const_iterator at;
  };
  std::vector<Level> open;
  for (const Json* value = &tree; value != json_;) {
    if (value->is_structured()) {
      open.push_back({value, value->cbegin()});
    } else if (!open.empty()) {
      ++open.back().at;
    }
    while (!open.empty() && open.back().at == open.back().value->cend()) {
      open.pop_back();
      if (!open.empty()) ++open.back().at;
    }
    if (open.empty()) return std::nullopt;
    value = &*open.back().at;
  }
  std::string path;
  for (const auto& [value, at] : open) {
    path += member_path("", value->is_object() ? at.key() : std::to_string(at - value->cbegin()));
  }
  return path;
}

}  // namespace rmpl::automata
