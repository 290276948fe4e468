// A distribution over the points of a chain, step by step.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "verifier/markov/walk.hpp"

namespace rmpl::verifier {

/// What states lead to, as it is asked for.
class RowMemory {
 public:
  /// Keeps references.
  RowMemory(Process& process, KnownRows& known) : process_(process), known_(known) {}
  /// With all outcomes that matter as much as that (`Process::rows`). The reference lasts until the next call.
  const KnownRow& of(StateNumber state, Real less_likely_than);

 private:
  Process& process_;
  KnownRows& known_;
};

/// Numbers for points, in the order in which they are met, from 0.
class PointNumbers {
 public:
  std::uint32_t number(const Point& point);
  [[nodiscard]] bool contains(const Point& point) const { return slots_[slot(point)].number != none; }
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  void clear();

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  struct Slot {
    Point point;
    std::uint32_t number = none;
  };
  /// Where the point is, or may go.
  [[nodiscard]] std::size_t slot(const Point& point) const;
  void grow();

  std::vector<Slot> slots_ = std::vector<Slot>(64);  ///< a power of two, half of them free (linear probing)
  std::vector<Point> points_;
};

/// Where runs are, with what they have come to.
class Front {
 public:
  struct Entry {
    Point point;
    Enclosure mass;
  };

  /// Up to the step `last`; `ignored` and `all` are those of a tolerance. Keeps references.
  Front(Process& process, RowMemory& rows, Units last, Real ignored, Real all)
      : process_(process), rows_(rows), last_(last), ignored_(ignored), all_(all) {}

  [[nodiscard]] const std::vector<Entry>& points() const { return points_; }
  [[nodiscard]] const Enclosure& wanted() const { return wanted_; }
  [[nodiscard]] Real unknown() const { return unknown_; }
  /// What has come to be so since this was asked last.
  Enclosure take_wanted() { return std::exchange(wanted_, {}); }
  Real take_unknown() { return std::exchange(unknown_, Real{0}); }
  /// Whether the last step led to the points that it began at.
  [[nodiscard]] bool is_same() const { return same_; }

  void add_wanted(const Enclosure& mass) { wanted_ = wanted_ + mass; }
  void add_unknown(Real mass) { unknown_ = rounding::up(unknown_ + mass, 1); }
  void arrive(const Point& point, const Enclosure& mass);
  /// All points go a step on, which ends at `now`, and arrive.
  void leave(Units now);
  /// What has arrived at `now` is where the next step begins, but for what `takes(point, mass)` takes away.
  template <class Takes>
  void settle(Units now, const Takes& takes);
  /// As if it began here, where nobody is.
  void begin_anew();

 private:
  /// How likely what has arrived is to come to what is wanted, by `worths_`; and how likely it has to be to be
  /// followed.
  Real find_worths(Units now);

  Process& process_;
  RowMemory& rows_;
  Units last_;
  Real ignored_;
  Real all_;
  Real spent_ = 0;  ///< of it
  std::vector<Entry> points_;
  PointNumbers arrived_;
  std::vector<Enclosure> masses_;  ///< of what has arrived
  std::vector<Real> worths_;       ///< likewise
  std::vector<Real> least_;        ///< kept for its memory
  PointNumbers before_;            ///< what had arrived a step ago
  bool same_ = false;
  Enclosure wanted_;
  Real unknown_ = 0;
};

template <class Takes>
void Front::settle(Units now, const Takes& takes) {
  points_.clear();
  const Real least = find_worths(now);
  const std::vector<Point>& arrived = arrived_.points();
  bool all_here = true;
  for (std::size_t i = 0; i < arrived.size(); ++i) {
    if (worths_[i] < least) {
      add_unknown(worths_[i]);
      all_here = all_here && worths_[i] >= ignored_;
    } else if (takes(arrived[i], masses_[i])) {
      all_here = false;
    } else {
      points_.push_back({arrived[i], masses_[i]});
    }
  }
  same_ = all_here && arrived.size() == before_.points().size() &&
          std::all_of(arrived.begin(), arrived.end(), [&](const Point& point) { return before_.contains(point); });
  std::swap(arrived_, before_);
  arrived_.clear();
  masses_.clear();
}

}  // namespace rmpl::verifier
