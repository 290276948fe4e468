// A report of flights: one page that opens without a network.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "runtime/report/flight.hpp"

namespace rmpl::runtime {

/// The pictures of what flies. SVG in which a location is the node or cluster `l4` or `cluster_l4` by its title, and a
/// block has its path as tooltip; empty where there is none, and `missing` says why.
struct Drawings {
  std::string program;
  std::string plant;
  std::string missing;
};

struct Model {
  const automata::Plant* plant;
  const automata::Program* program;  ///< null where there is none
  Drawings drawings;
};

struct Report {
  std::string title;
  std::vector<Model> models;    ///< one for each pair that a flight is of
  std::vector<Flight> flights;  ///< at least one
};

/// HTML with all that it needs inside, in UTF-8: same report, same bytes. Names may contain anything.
std::string to_html(const Report& report);

/// What the page shows, as JSON; `<` is escaped, so that it can stand in a script element.
std::string to_json(const Report& report);

}  // namespace rmpl::runtime
