// Symmetry: sorting states by a group of automorphisms.
// SPDX-License-Identifier: MIT
#include "verifier/explore/symmetry.hpp"

#include <algorithm>
#include <set>
#include <tuple>

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
  for (const Permutation& g : generators_) {
    const bool names_kept = std::all_of(g.begin(), g.end(), [](const Renaming& r) {
      for (std::size_t m = 0; m < r.modes.size(); ++m) {
        if (r.modes[m] != m) return false;
      }
      return true;
    });
    if (g.size() == 2 && names_kept) exchanges_.emplace_back(g[0].component, g[1].component);
  }
  std::sort(exchanges_.begin(), exchanges_.end());
}

namespace {

/// A state as it is sorted: which of the given clocks each component has, or 0.
struct Arrangement {
  Modes& modes;
  std::vector<std::size_t> clocks;

  /// Whether the permutation makes the modes less (-1), greater (1), or leaves them as they are (0).
  [[nodiscard]] int compare(const Permutation& permutation) const {
    std::uint32_t first = UINT32_MAX;
    bool less = false;
    for (const Renaming& r : permutation) {
      const ModeId mode(r.modes[modes[r.component].index()]);
      if (r.to >= first || mode == modes[r.to]) continue;
      first = r.to;
      less = mode < modes[r.to];
    }
    return first == UINT32_MAX ? 0 : less ? -1 : 1;
  }

  [[nodiscard]] bool moves_clocks(const Permutation& permutation) const {
    return std::any_of(permutation.begin(), permutation.end(),
                       [&](const Renaming& r) { return clocks[r.component] != clocks[r.to]; });
  }

  void apply(const Permutation& permutation) {
    std::vector<std::pair<ModeId, std::size_t>> images;
    for (const Renaming& r : permutation) {
      images.emplace_back(r.modes[modes[r.component].index()], clocks[r.component]);
    }
    for (std::size_t i = 0; i < images.size(); ++i) {
      std::tie(modes[permutation[i].to], clocks[permutation[i].to]) = images[i];
    }
  }

  /// The clocks in order of their components, after others that stay where they are.
  void order(std::size_t others, std::vector<std::size_t>& result) const {
    result.clear();
    for (std::size_t i = 0; i < others; ++i) result.push_back(i + 1);
    for (const std::size_t clock : clocks) {
      if (clock != 0) result.push_back(clock);
    }
  }
};

}  // namespace

Permutation Symmetry::sort(Modes& modes, std::vector<ComponentId>& live, std::size_t others, Zone& zone,
                           bool applied) const {
  Permutation all;
  Arrangement state{modes, std::vector<std::size_t>(modes.size(), 0)};
  for (std::size_t i = 0; i < live.size(); ++i) state.clocks[live[i].index()] = others + i + 1;
  std::vector<std::size_t> order, other;
  state.order(others, order);
  bool sorted = false;
  while (!sorted) {
    sorted = true;
    for (const Permutation& g : generators_) {
      const int compared = state.compare(g);
      if (compared > 0 || (compared == 0 && !state.moves_clocks(g))) continue;
      state.apply(g);
      state.order(others, other);
      if (compared == 0 && !less(zone, other, order)) {
        // Modes are as they were: the inverse takes the clocks back.
        state.apply(inverse(g));
        continue;
      }
      order = other;
      if (applied) all = composed(all, g);
      sorted = false;
    }
  }
  live.clear();
  for (std::size_t c = 0; c < modes.size(); ++c) {
    if (state.clocks[c] != 0) live.emplace_back(c);
  }
  if (!std::is_sorted(order.begin(), order.end())) zone = zone.select(order);
  return all;
}

}  // namespace verifier
