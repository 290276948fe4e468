// Symmetry: sorting states by a group of automorphisms.
// SPDX-License-Identifier: MIT
#include "verifier/symmetry/symmetry.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace rmpl::verifier {

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

/// A state as it is sorted: its modes, and the clocks of its zone in the order of the components that have them.
class Arrangement {
 public:
  Arrangement(Modes& modes, const std::vector<ComponentId>& live, std::size_t others, const Zone& zone)
      : modes_(modes), zone_(zone), clocks_(modes.size(), 0), places_(modes.size()), others_(others) {
    for (std::size_t i = 0; i < live.size(); ++i) clocks_[live[i].index()] = others + i + 1;
    put_in_order();
  }

  /// Applies the permutation if that makes the state less.
  bool lessened_by(const Permutation& permutation) {
    const int compared = compare(permutation);
    if (compared > 0 || (compared == 0 && !makes_zone_less(permutation))) return false;
    images_.clear();
    for (const Renaming& r : permutation) {
      images_.emplace_back(r.modes[modes_[r.component].index()], clocks_[r.component]);
    }
    for (std::size_t i = 0; i < images_.size(); ++i) {
      std::tie(modes_[permutation[i].to], clocks_[permutation[i].to]) = images_[i];
    }
    put_in_order();
    return true;
  }

  /// The clocks, those that belong to no component first.
  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }
  [[nodiscard]] std::vector<ComponentId> live() const {
    std::vector<ComponentId> result;
    for (std::size_t c = 0; c < clocks_.size(); ++c) {
      if (clocks_[c] != 0) result.emplace_back(c);
    }
    return result;
  }

 private:
  /// Whether the permutation makes the modes less (-1), greater (1), or leaves them as they are (0).
  [[nodiscard]] int compare(const Permutation& permutation) const {
    std::uint32_t first = UINT32_MAX;
    bool less = false;
    for (const Renaming& r : permutation) {
      const ModeId mode(r.modes[modes_[r.component].index()]);
      if (r.to >= first || mode == modes_[r.to]) continue;
      first = r.to;
      less = mode < modes_[r.to];
    }
    return first == UINT32_MAX ? 0 : less ? -1 : 1;
  }

  /// Whether a permutation that leaves the modes as they are makes the matrix lexicographically less: first what each
  /// clock can read, then how they stand to each other. Equal modes have clocks alike, so that clocks only change
  /// places among themselves; what lies between two that keep theirs is not looked at.
  [[nodiscard]] bool makes_zone_less(const Permutation& permutation) {
    moved_.clear();
    for (const Renaming& r : permutation) {
      if (clocks_[r.component] != clocks_[r.to]) moved_.push_back({places_[r.to], clocks_[r.component]});
    }
    if (moved_.empty()) return false;
    std::sort(moved_.begin(), moved_.end());
    for (const auto& [place, clock] : moved_) {
      const std::size_t now = order_[place];
      if (zone_.bound(0, clock) != zone_.bound(0, now)) return zone_.bound(0, clock) < zone_.bound(0, now);
      if (zone_.bound(clock, 0) != zone_.bound(now, 0)) return zone_.bound(clock, 0) < zone_.bound(now, 0);
    }
    after_ = order_;
    for (const auto& [place, clock] : moved_) after_[place] = clock;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const auto compare_at = [&](std::size_t j) {
        const Units one = zone_.bound(after_[i], after_[j]);
        const Units other = zone_.bound(order_[i], order_[j]);
        return one < other ? -1 : one > other ? 1 : 0;
      };
      int compared = 0;
      if (after_[i] != order_[i]) {
        for (std::size_t j = 0; j < order_.size() && compared == 0; ++j) compared = compare_at(j);
      } else {
        for (std::size_t k = 0; k < moved_.size() && compared == 0; ++k) compared = compare_at(moved_[k].first);
      }
      if (compared != 0) return compared < 0;
    }
    return false;
  }

  void put_in_order() {
    order_.clear();
    for (std::size_t i = 0; i < others_; ++i) order_.push_back(i + 1);
    for (std::size_t c = 0; c < clocks_.size(); ++c) {
      places_[c] = order_.size();
      if (clocks_[c] != 0) order_.push_back(clocks_[c]);
    }
  }

  Modes& modes_;
  const Zone& zone_;
  std::vector<std::size_t> clocks_;  ///< by component, 0 where it has none
  std::vector<std::size_t> places_;  ///< by component, in `order_`
  std::size_t others_;
  std::vector<std::size_t> order_;
  // Room that is used again:
  std::vector<std::pair<std::size_t, std::size_t>> moved_;  ///< places whose clock changes, with the new clock
  std::vector<std::size_t> after_;
  std::vector<std::pair<ModeId, std::size_t>> images_;
};

}  // namespace

Permutation Symmetry::sort(Modes& modes, std::vector<ComponentId>& live, std::size_t others, Zone& zone,
                           bool applied) const {
  Permutation all;
  Arrangement state(modes, live, others, zone);
  // Round and round, until a whole round has changed nothing.
  std::size_t unchanged = 0;
  for (std::size_t i = 0; unchanged < generators_.size(); i = (i + 1) % generators_.size()) {
    if (state.lessened_by(generators_[i])) {
      if (applied) all = composed(all, generators_[i]);
      unchanged = 0;
    } else {
      ++unchanged;
    }
  }
  live = state.live();
  const auto& order = state.order();
  if (!std::is_sorted(order.begin(), order.end())) zone = zone.select(order);
  return all;
}

}  // namespace rmpl::verifier
