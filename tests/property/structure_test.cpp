// Structure functions and their diagrams beside tables of all sets of events.
// SPDX-License-Identifier: MIT
#include "verifier/safety/structure.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <numeric>

#include "tests/property/draw.hpp"
#include "tests/reference/truth_table.hpp"

namespace rmpl::property {
namespace {

using reference::TruthTable;
using verifier::GateId;
using verifier::NodeId;
using verifier::Structure;

/// Gates over events and gates, and the table of each.
struct Drawn {
  Structure structure;
  std::vector<GateId> gates;
  std::vector<TruthTable> tables;
};

void add(Drawn& drawn, GateId gate, TruthTable table) {
  drawn.gates.push_back(gate);
  drawn.tables.push_back(std::move(table));
}

void draw_gate(Drawn& drawn) {
  const std::size_t kind = up_to(0, 9);
  const auto input = [&] { return up_to(0, drawn.gates.size() - 1); };
  const std::size_t first = input();
  if (kind == 0) {
    TruthTable table = drawn.tables[first];
    table.flip();
    return add(drawn, drawn.structure.negation(drawn.gates[first]), std::move(table));
  }
  const std::size_t second = input();
  if (kind == 1) {
    const GateId gate = drawn.structure.equivalence(drawn.gates[first], drawn.gates[second]);
    return add(drawn, gate, reference::combined(drawn.tables[first], drawn.tables[second], std::equal_to<bool>()));
  }
  const bool both = kind < 6;
  std::vector<GateId> inputs{drawn.gates[first]};
  TruthTable table = drawn.tables[first];
  for (std::size_t more = up_to(0, 3); more > 0; --more) {
    const std::size_t next = input();
    inputs.push_back(drawn.gates[next]);
    table = both ? reference::combined(table, drawn.tables[next], std::logical_and<bool>())
                 : reference::combined(table, drawn.tables[next], std::logical_or<bool>());
  }
  const GateId gate =
      both ? drawn.structure.conjunction(std::move(inputs)) : drawn.structure.disjunction(std::move(inputs));
  add(drawn, gate, std::move(table));
}

RC_GTEST_PROP(Structure, HasTheSetsAndTheProbabilityOfItsTable, ()) {
  const std::size_t events = up_to(1, 7);
  Drawn drawn;
  for (std::size_t e = 0; e < events; ++e) {
    add(drawn, drawn.structure.event(static_cast<std::uint32_t>(e)), reference::event_table(events, e));
  }
  for (std::size_t more = up_to(1, 14); more > 0; --more) draw_gate(drawn);
  const TruthTable& table = drawn.tables.back();

  const GateId top = drawn.structure.simplified(drawn.gates.back());
  std::vector<std::uint32_t> variables(events, 0);
  std::vector<bool> placed(events, false);
  std::uint32_t next = 0;
  for (const std::uint32_t event : drawn.structure.order(top)) {
    RC_ASSERT(!placed[event]);
    placed[event] = true;
    variables[event] = next++;
  }
  for (std::size_t e = 0; e < events; ++e) {
    if (!placed[e]) variables[e] = next++;
  }
  const verifier::Limits limits;
  verifier::Meter meter(limits);
  verifier::Diagrams diagrams(meter);
  const NodeId diagram = drawn.structure.diagram(top, variables, diagrams);

  std::vector<double> chances(events);
  std::vector<verifier::Enclosure> bounds(events);
  for (std::size_t e = 0; e < events; ++e) {
    chances[e] = static_cast<double>(up_to(0, 8)) / 8;
    bounds[variables[e]] = {chances[e], chances[e]};
  }
  const verifier::Enclosure found = diagrams.probability(diagram, bounds);
  const long double exact = reference::probability(table, chances);
  RC_ASSERT(found.lower <= exact);
  RC_ASSERT(exact <= found.upper);
  RC_ASSERT(found.upper - found.lower <= 1e-15L);

  const NodeId sets = diagrams.minimal_sets(diagram);
  std::vector<verifier::Real> expected;
  for (const std::size_t count : reference::minimal_sets(table)) {
    expected.push_back(static_cast<verifier::Real>(count));
  }
  RC_ASSERT(diagrams.sizes(sets) == expected);
  const auto all = std::accumulate(expected.begin(), expected.end(), verifier::Real{0});
  const auto listed = diagrams.likeliest(sets, chances, table.size());
  RC_ASSERT(static_cast<verifier::Real>(listed.size()) == all);
}

}  // namespace
}  // namespace rmpl::property
