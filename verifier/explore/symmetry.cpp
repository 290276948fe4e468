// Symmetry: sorting states by a group of automorphisms.
// SPDX-License-Identifier: MIT
#include "verifier/explore/symmetry.hpp"

#include <algorithm>
#include <set>

namespace verifier {

using automata::ComponentId;
using automata::ModeId;
using automata::Modes;

namespace {

constexpr std::size_t most_generators = 4096;

bool swaps(const Permutation& p) { return composed(p, p).empty(); }

/// With every two swaps g and h also g h g: generators of a full group of arrangements become all of its swaps.
void close(std::vector<Permutation>& generators) {
  std::set<Permutation> known(generators.begin(), generators.end());
  for (std::size_t i = 0; i < generators.size(); ++i) {
    for (std::size_t j = 0; j < i && generators.size() < most_generators; ++j) {
      for (const auto& [g, h] : {std::pair{i, j}, std::pair{j, i}}) {
        const Permutation both = composed(composed(generators[g], generators[h]), generators[g]);
        if (!swaps(both) || both.size() > std::max(generators[i].size(), generators[j].size())) continue;
        if (known.insert(both).second) generators.push_back(both);
      }
    }
  }
}

/// Whether the permuted order of clocks (position to original clock) makes the matrix lexicographically less: first
/// what each clock can read, then how they stand to each other.
bool less(const Zone& zone, const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (zone.bound(0, a[i]) != zone.bound(0, b[i])) return zone.bound(0, a[i]) < zone.bound(0, b[i]);
    if (zone.bound(a[i], 0) != zone.bound(b[i], 0)) return zone.bound(a[i], 0) < zone.bound(b[i], 0);
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < a.size(); ++j) {
      if (a[i] == b[i] && a[j] == b[j]) continue;
      const Units one = zone.bound(a[i], a[j]);
      const Units other = zone.bound(b[i], b[j]);
      if (one != other) return one < other;
    }
  }
  return false;
}

}  // namespace

Modes renamed(const Modes& modes, const Permutation& permutation) {
  Modes result = modes;
  for (const Renaming& r : permutation) result[r.to] = ModeId(r.modes[modes[r.component].index()]);
  return result;
}

Symmetry::Symmetry(std::vector<Permutation> generators) : generators_(std::move(generators)) {
  const std::size_t given = generators_.size();
  for (std::size_t g = 0; g < given; ++g) {
    if (!swaps(generators_[g])) generators_.push_back(inverse(generators_[g]));
  }
  close(generators_);
}

Permutation Symmetry::sort(Modes& modes, std::vector<ComponentId>& live, std::size_t others, Zone& zone,
                           bool applied) const {
  Permutation all;
  // Which of the given clocks each of the clocks now is.
  std::vector<std::size_t> order(zone.clocks());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i + 1;
  std::vector<std::size_t> other;
  bool sorted = false;
  while (!sorted) {
    sorted = true;
    for (const Permutation& g : generators_) {
      const Modes next = renamed(modes, g);
      if (next > modes) continue;
      // Where each live component goes, and with it its clock.
      std::vector<std::pair<ComponentId, std::size_t>> moved;
      bool moves = false;
      for (std::size_t i = 0; i < live.size(); ++i) {
        const auto r =
            std::find_if(g.begin(), g.end(), [&](const Renaming& n) { return n.component == live[i].value; });
        moved.emplace_back(r == g.end() ? live[i] : ComponentId(r->to), order[others + i]);
        moves = moves || moved.back().first != live[i];
      }
      if (next == modes && !moves) continue;
      std::sort(moved.begin(), moved.end());
      other.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(others));
      for (const auto& [component, clock] : moved) other.push_back(clock);
      if (next == modes && !less(zone, other, order)) continue;
      modes = next;
      order = other;
      for (std::size_t i = 0; i < live.size(); ++i) live[i] = moved[i].first;
      if (applied) all = composed(all, g);
      sorted = false;
    }
  }
  if (!std::is_sorted(order.begin(), order.end())) zone = zone.select(order);
  return all;
}

}  // namespace verifier
