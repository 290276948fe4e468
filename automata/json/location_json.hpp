// What locations of both kinds of automata have in a document: number, kind, parent, start.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "automata/json/node.hpp"
#include "automata/logic/ids.hpp"
#include "automata/program.hpp"

namespace rmpl::automata {

/// The location at `position`, from 0, after those `before` it.
template <class Location>
Location common_of_location(const Node& node, std::size_t position, const std::vector<Location>& before) {
  Location location;
  if (node.at("number").natural() != position + 1) node.at("number").fail(std::to_string(position + 1));
  const std::string kind = node.at("kind").text();
  if (kind != "composite" && kind != "primitive") node.at("kind").fail("composite or primitive");
  location.composite = kind == "composite";
  if (position == 0 && (node.has("parent") || !location.composite)) node.fail("the program itself, a composite");
  if (position > 0) {
    const std::size_t parent = node.at("parent").index(position + 1);
    if (parent == 0 || !before[parent - 1].composite) node.at("parent").fail("a composite that comes before");
    location.parent = LocationId(parent - 1);
  }
  location.start = node.at("start").truth();
  return location;
}

}  // namespace rmpl::automata
