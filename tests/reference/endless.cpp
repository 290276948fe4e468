// Runs without end, and runs that cannot go on: slow, and plain.
// SPDX-License-Identifier: MIT
#include "tests/reference/endless.hpp"

#include <algorithm>
#include <map>

namespace rmpl::reference {

namespace {

using Edges = std::vector<RunEdge>;

/// All that can be reached from a state, itself included, along edges or against them.
std::set<std::size_t> reach(const std::map<std::size_t, std::vector<std::size_t>>& next, std::size_t start) {
  std::set<std::size_t> seen{start};
  std::vector<std::size_t> queue{start};
  while (!queue.empty()) {
    const std::size_t s = queue.back();
    queue.pop_back();
    const auto at = next.find(s);
    if (at == next.end()) continue;
    for (const std::size_t t : at->second)
      if (seen.insert(t).second) queue.push_back(t);
  }
  return seen;
}

/// The edges on which one can go round: those whose ends reach each other, part by part.
std::vector<Edges> rounds(const Edges& edges) {
  std::map<std::size_t, std::vector<std::size_t>> ahead, behind;
  std::set<std::size_t> left;
  for (const RunEdge& e : edges) {
    ahead[e.from].push_back(e.to);
    behind[e.to].push_back(e.from);
    left.insert(e.from);
  }
  std::vector<Edges> result;
  std::map<std::size_t, std::size_t> part;
  while (!left.empty()) {
    const std::size_t start = *left.begin();
    const auto after = reach(ahead, start);
    const auto before = reach(behind, start);
    for (const std::size_t s : after)
      if (before.contains(s)) {
        part[s] = result.size();
        left.erase(s);
      }
    result.emplace_back();
  }
  for (const RunEdge& e : edges) {
    const auto from = part.find(e.from);
    const auto to = part.find(e.to);
    if (to != part.end() && from->second == to->second) result[from->second].push_back(e);
  }
  std::erase_if(result, [](const Edges& round) { return round.empty(); });
  return result;
}

bool meet(const std::set<automata::ModeId>& a, const std::set<automata::ModeId>& b) {
  return std::any_of(a.begin(), a.end(), [&](automata::ModeId mode) { return b.contains(mode); });
}

/// Whether one can go round for ever on some of these edges.
bool lasts(const Edges& round, std::size_t components) {
  if (std::none_of(round.begin(), round.end(), [](const RunEdge& e) { return e.time; })) return false;
  for (std::size_t c = 0; c < components; ++c) {
    std::set<automata::ModeId> open;
    for (const RunEdge& e : round)
      if (e.exits != nullptr) open.insert(e.exits->open[c].begin(), e.exits->open[c].end());
    if (open.empty()) continue;
    const auto patient = [&](const RunEdge& e) {
      return e.moves[c] || (e.exits != nullptr && !meet(e.exits->enabled[c], open));
    };
    if (std::any_of(round.begin(), round.end(), patient)) continue;
    // Not on all of them; but perhaps where what is enabled on one of them is open on none.
    std::set<std::set<automata::ModeId>> different;
    for (const RunEdge& e : round)
      if (e.exits != nullptr) different.insert(e.exits->enabled[c]);
    return std::any_of(different.begin(), different.end(), [&](const std::set<automata::ModeId>& enabled) {
      Edges fewer = round;
      std::erase_if(fewer, [&](const RunEdge& e) { return e.exits != nullptr && meet(e.exits->open[c], enabled); });
      const auto parts = rounds(fewer);
      return std::any_of(parts.begin(), parts.end(), [&](const Edges& part) { return lasts(part, components); });
    });
  }
  return true;
}

}  // namespace

bool runs_for_ever(const std::vector<RunEdge>& edges, std::size_t components) {
  const auto parts = rounds(edges);
  return std::any_of(parts.begin(), parts.end(), [&](const Edges& part) { return lasts(part, components); });
}

bool comes_to_a_stop(const std::vector<RunEdge>& edges, const std::vector<bool>& judged) {
  std::map<std::size_t, std::vector<std::size_t>> behind;
  std::vector<std::size_t> queue;
  for (std::size_t s = 0; s < judged.size(); ++s)
    if (!judged[s]) queue.push_back(s);
  for (const RunEdge& e : edges) {
    if (!e.nominal || e.lasts == 0) continue;
    if (e.time)
      queue.push_back(e.from);
    else
      behind[e.to].push_back(e.from);
  }
  std::set<std::size_t> go_on;
  for (const std::size_t s : queue) {
    if (go_on.contains(s)) continue;
    const auto more = reach(behind, s);
    go_on.insert(more.begin(), more.end());
  }
  // The first step of an instant is looked at more closely than those after it.
  std::vector<bool> stops = judged;
  for (const RunEdge& e : edges)
    if (e.nominal && (e.time || (e.lasts == 2 && go_on.contains(e.to)))) stops[e.from] = false;
  return std::find(stops.begin(), stops.end(), true) != stops.end();
}

}  // namespace rmpl::reference
