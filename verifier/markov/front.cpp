// Distributions over points.
// SPDX-License-Identifier: MIT
#include "verifier/markov/front.hpp"

#include <algorithm>
#include <limits>

#include "base/check.hpp"
#include "base/hash.hpp"

namespace rmpl::verifier {

namespace {

/// A row is worked out for outcomes that are so much less likely than is asked for, as masses grow.
constexpr Real finer_than_asked = 64;

}  // namespace

const KnownRow& RowMemory::of(StateNumber state, Real less_likely_than) {
  if (known_.size() <= state) known_.resize(std::max<std::size_t>(state + std::size_t{1}, 2 * known_.size()));
  std::optional<KnownRow>& known = known_[state];
  if (!known || known->less_likely_than > less_likely_than) {
    const Real least = less_likely_than / finer_than_asked;
    const std::vector<Row>& choices = process_.rows(state, least);
    CHECK(choices.size() <= 1 && "a chain has no choices");
    known = KnownRow{choices.empty() ? Row{} : choices.front(), least, 0, {}};
    std::vector<Branch>& edges = known->row.edges;
    const auto unwanted = std::stable_partition(edges.begin(), edges.end(),
                                                [this](const Branch& edge) { return process_.wanted(edge.to); });
    known->wanted = static_cast<std::size_t>(unwanted - edges.begin());
    for (const Branch& edge : edges) known->prospects.push_back(process_.prospect(edge.to));
  }
  return *known;
}

std::size_t PointNumbers::slot(const Point& point) const {
  const std::uint64_t word = std::uint64_t{point.state} << 32 | point.starts;
  std::size_t at = base::mix(base::hash_seed, word) & (slots_.size() - 1);
  while (slots_[at].number != none && slots_[at].point != point) at = (at + 1) & (slots_.size() - 1);
  return at;
}

std::uint32_t PointNumbers::number(const Point& point) {
  std::size_t found = slot(point);
  if (slots_[found].number == none) {
    if (2 * points_.size() >= slots_.size()) {
      grow();
      found = slot(point);
    }
    slots_[found] = {point, static_cast<std::uint32_t>(points_.size())};
    points_.push_back(point);
  }
  return slots_[found].number;
}

void PointNumbers::grow() {
  slots_.assign(2 * slots_.size(), Slot{});
  for (std::size_t i = 0; i < points_.size(); ++i)
    slots_[slot(points_[i])] = {points_[i], static_cast<std::uint32_t>(i)};
}

void PointNumbers::clear() {
  // A table that has become far too large would cost at each step.
  if (slots_.size() > 64 && 16 * points_.size() < slots_.size()) slots_.resize(slots_.size() / 2);
  std::fill(slots_.begin(), slots_.end(), Slot{});
  points_.clear();
}

void Front::arrive(const Point& point, const Enclosure& mass) {
  if (process_.wanted(point.state)) return add_wanted(mass);
  const std::uint32_t number = arrived_.number(point);
  if (number == masses_.size()) masses_.emplace_back();
  masses_[number] = masses_[number] + mass;
}

void Front::begin_anew() {
  points_.clear();
  before_.clear();
}

Real Front::find_worths(Units now) {
  const std::vector<Point>& arrived = arrived_.points();
  worths_.clear();
  for (std::size_t i = 0; i < arrived.size(); ++i) {
    worths_.push_back(rounding::up(masses_[i].upper * process_.prospect(arrived[i].state).within(last_ - now), 1));
  }
  if (last_ <= 0 || all_ == 0) return ignored_;
  const Real left = all_ * static_cast<Real>(std::min(now, last_)) / static_cast<Real>(last_) - spent_;
  least_ = worths_;
  std::sort(least_.begin(), least_.end());
  Real sum = 0;
  for (const Real worth : least_) {
    if (sum + worth > left) {
      spent_ += sum;
      return std::max(ignored_, worth);
    }
    sum += worth;
  }
  spent_ += sum;
  return std::numeric_limits<Real>::infinity();
}

void Front::leave(Units now) {
  for (const auto& [point, mass] : points_) {
    const KnownRow& next = rows_.of(point.state, ignored_ / mass.upper);
    Real rest = rounding::up(next.row.left_out + next.row.foreseen.within(last_ - now), 1);
    for (std::size_t e = 0; e < next.row.edges.size(); ++e) {
      const Branch& edge = next.row.edges[e];
      const Enclosure part = mass * edge.probability;
      if (e < next.wanted) {
        add_wanted(part);
        continue;
      }
      const Real prospect = next.prospects[e].within(last_ - now);
      if (part.upper * prospect < ignored_) {
        rest = rounding::up(rest + edge.probability.upper * prospect, 2);
      } else {
        arrive(process_.follow(point, edge, now), part);
      }
    }
    if (rest > 0) unknown_ = rounding::up(unknown_ + mass.upper * rest, 2);
  }
}

}  // namespace rmpl::verifier
