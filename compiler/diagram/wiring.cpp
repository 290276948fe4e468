// Interconnections sorted by their ends; commanded and observed ports are drawn too, but for those of folded modules.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/wiring.hpp"

#include <algorithm>
#include <utility>

namespace rmpl::compiler {
namespace {

using automata::VariableId;
using Side = Wiring::Side;

/// Whether an interconnection is of no concern. One without variables concerns the whole plant.
bool is_left_out(const std::vector<VariableId>& variables, const Blocks& blocks) {
  if (variables.empty()) return !blocks.inside().empty();
  if (std::none_of(variables.begin(), variables.end(), [&](VariableId v) { return blocks.is_inside(v); })) return true;
  const auto first = blocks.block_of(variables.front());
  return first && blocks.all()[*first].component == nullptr &&
         std::all_of(variables.begin(), variables.end(), [&](VariableId v) { return blocks.block_of(v) == first; });
}

/// Where the form of two ends tells nothing, what is at the end of something else is the source of this.
void turn(Flow& flow, const std::vector<bool>& read, const Wiring& wiring) {
  if (flow.from.size() != 1 || flow.to.size() != 1) return;
  VariableId& from = flow.from.front();
  VariableId& to = flow.to.front();
  const auto is_reached = [&](VariableId v) {
    const auto port = wiring.ports.find(v);
    return port != wiring.ports.end() && port->second == Side::left;
  };
  if (read[from.index()] == read[to.index()] && is_reached(to) && !is_reached(from)) std::swap(from, to);
}

void connect(const automata::Plant& plant, const Blocks& blocks, Wiring& wiring) {
  const std::vector<bool> read = read_variables(plant);
  std::map<Flow, std::size_t> lines;
  std::map<Flow, std::size_t> notes;
  for (std::size_t q = 0; q < plant.interconnections.size(); ++q) {
    const automata::Formula& constraint = plant.interconnections[q].constraint;
    if (is_left_out(automata::variables_of(constraint), blocks)) continue;
    Flow flow = flow_of(constraint, read);
    turn(flow, read, wiring);
    for (const VariableId variable : flow.from) wiring.ports.emplace(variable, Side::right);
    for (const VariableId variable : flow.to) wiring.ports.emplace(variable, Side::left);
    if (flow.from.size() == 1 && flow.to.size() == 1) {
      const auto [at, fresh] = lines.emplace(flow, wiring.lines.size());
      if (fresh) wiring.lines.push_back({flow.from.front(), flow.to.front(), {}});
      wiring.lines[at->second].interconnections.push_back(q);
    } else {
      const auto [at, fresh] = notes.emplace(flow, wiring.notes.size());
      if (fresh) wiring.notes.push_back({flow, {}});
      wiring.notes[at->second].interconnections.push_back(q);
    }
  }
}

}  // namespace

Wiring wiring_of(const automata::Plant& plant, const Blocks& blocks) {
  const std::size_t count = plant.variables.size();
  Wiring wiring{{}, {}, {}, std::vector<bool>(count, false), std::vector<bool>(count, false)};
  connect(plant, blocks, wiring);
  const auto draw = [&](VariableId variable, Side side) {
    if (!blocks.is_inside(variable)) return;
    const auto block = blocks.block_of(variable);
    if (!block || blocks.all()[*block].component != nullptr) wiring.ports.emplace(variable, side);
  };
  for (const automata::Control& control : plant.controls) {
    wiring.commanded[control.variable.index()] = true;
    draw(control.variable, Side::left);
  }
  for (const VariableId observable : plant.observables) {
    wiring.observed[observable.index()] = true;
    draw(observable, Side::right);
  }
  return wiring;
}

}  // namespace rmpl::compiler
