// The distribution over the points of a chain, followed forward.
// SPDX-License-Identifier: MIT
#include "verifier/markov/walk.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

#include "base/check.hpp"
#include "verifier/markov/sparse.hpp"

namespace rmpl::verifier {

namespace {

/// Stretches of fewer steps are walked.
constexpr Units shortest_stretch = 16;
/// Where no stretch was found, none is looked for in so many steps.
constexpr Units steps_between_looks = 256;
/// A row is worked out for outcomes that are so much less likely than is asked for.
constexpr Real finer = 64;
/// More points than this are walked: a matrix of them would not stay sparse.
constexpr std::size_t most_points = std::size_t{1} << 15;

struct PointHash {
  std::size_t operator()(const Point& point) const noexcept {
    return (std::uint64_t{point.state} << 32 | point.starts) * 0x9e3779b97f4a7c15u >> 7;
  }
};
using Positions = std::unordered_map<Point, std::uint32_t, PointHash>;  ///< looked up, never iterated

class Walk {
 public:
  Walk(Process& process, Real ignored, KnownRows& known, Meter& meter)
      : process_(process), ignored_(ignored), rows_(known), meter_(meter) {}

  std::vector<Reached> run(const std::vector<Units>& steps) {
    for (const Process::Start& start : process_.initial()) arrive(start.point, start.probability);
    settle();
    std::vector<Reached> result;
    for (const Units step : steps) {
      while (now_ < step && !points_.empty()) {
        if (!stretch(step)) walk_step();
      }
      now_ = step;
      result.push_back({step, reached()});
    }
    return result;
  }

 private:
  /// With all outcomes that are as likely as that. The reference lasts until the next call.
  const KnownRow& row(StateNumber state, Real less_likely_than) {
    if (rows_.size() <= state) rows_.resize(std::max<std::size_t>(state + std::size_t{1}, 2 * rows_.size()));
    std::optional<KnownRow>& known = rows_[state];
    if (!known || known->less_likely_than > less_likely_than) {
      // Some more than is asked for, as masses grow.
      const Real least = less_likely_than / finer;
      const std::vector<Row>& choices = process_.rows(state, least);
      CHECK(choices.size() <= 1 && "a chain has no choices");
      known = KnownRow{choices.empty() ? Row{} : choices.front(), least, {}};
      const std::vector<Branch>& edges = known->row.edges;
      known->rest.resize(edges.size() + 1, 0);
      for (std::size_t e = edges.size(); e-- > 0;) {
        known->rest[e] = rounding::up(known->rest[e + 1] + edges[e].probability.upper, 1);
      }
    }
    return *known;
  }

  /// What has been reached, and at most all that is not known.
  [[nodiscard]] Enclosure reached() const {
    const Enclosure all{wanted_.lower, rounding::up(wanted_.upper + unknown_, 1)};
    return as_probability(all);
  }

  void arrive(const Point& point, const Enclosure& mass) {
    if (process_.wanted(point.state)) {
      wanted_ = wanted_ + mass;
    } else if (mass.upper < ignored_) {
      unknown_ = rounding::up(unknown_ + mass.upper, 1);
    } else {
      const auto [at, fresh] = positions_.try_emplace(point, static_cast<std::uint32_t>(next_.size()));
      if (fresh) {
        next_.emplace_back(point, mass);
      } else {
        next_[at->second].second = next_[at->second].second + mass;
      }
    }
  }

  /// What has arrived is where the next step begins.
  void settle() {
    std::sort(next_.begin(), next_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    same_ = std::equal(points_.begin(), points_.end(), next_.begin(), next_.end(),
                       [](const auto& a, const auto& b) { return a.first == b.first; });
    points_.swap(next_);
    next_.clear();
    positions_.clear();
  }

  void walk_step() {
    meter_.poll();
    meter_.at_steps(static_cast<std::size_t>(now_), points_.size());
    ++now_;
    for (const auto& [point, mass] : points_) {
      const KnownRow& next = row(point.state, ignored_ / mass.upper);
      Real rest = next.row.left_out;
      for (std::size_t e = 0; e < next.row.edges.size(); ++e) {
        const Branch& edge = next.row.edges[e];
        const Enclosure part = mass * edge.probability;
        if (part.upper < ignored_) {
          rest = rounding::up(rest + next.rest[e], 1);
          break;
        }
        arrive(process_.follow(point, edge, now_), part);
      }
      if (rest > 0) unknown_ = rounding::up(unknown_ + mass.upper * rest, 2);
    }
    settle();
  }

  /// Many steps at once, none later than `end`; none where they are not all alike.
  bool stretch(Units end) {
    if (!same_ || now_ < not_before_) return false;
    Units until = end;
    for (const auto& [point, mass] : points_) until = std::min(until, process_.lasts_until(point));
    if (until - now_ < shortest_stretch) return false;
    auto matrix = matrix_until(until);
    if (!matrix) {
      not_before_ = now_ + steps_between_looks;
      return false;
    }
    std::vector<Enclosure> masses(stay_.size() + 2);
    for (std::size_t i = 0; i < points_.size(); ++i) masses[i] = points_[i].second;
    masses =
        after_steps(std::move(masses), std::move(*matrix), static_cast<std::uint64_t>(until - now_), ignored_, meter_);
    now_ = until;
    points_.clear();
    wanted_ = wanted_ + masses[stay_.size()];
    unknown_ = rounding::up(unknown_ + masses[stay_.size() + 1].upper, 1);
    for (std::size_t i = 0; i < stay_.size(); ++i) arrive(stay_[i], masses[i]);
    settle();
    same_ = false;
    return true;
  }

  /// What one step does until then, over the points that a likely run may meet, `stay_`, and two more: what is wanted,
  /// and what is unknown. Nothing where a long clock may come to a bound, or start anew, on such a run.
  std::optional<SparseMatrix> matrix_until(Units until) {
    const Real steps = static_cast<Real>(until - now_);
    Positions positions;
    std::vector<Real> likely;  // at most how likely a run is there at some time, by order of magnitude
    stay_.clear();
    const auto meet = [&](const Point& point, Real mass) {
      const auto [at, fresh] = positions.try_emplace(point, static_cast<std::uint32_t>(stay_.size()));
      if (fresh) {
        stay_.push_back(point);
        likely.push_back(mass);
      }
      return at->second;
    };
    for (const auto& [point, mass] : points_) meet(point, mass.upper);
    struct Raw {
      std::vector<std::pair<std::uint32_t, Enclosure>> inside;
      Enclosure wanted;
      Real unknown = 0;
    };
    std::vector<Raw> raw;
    for (std::size_t i = 0; i < stay_.size(); ++i) {
      meter_.poll();
      if (stay_.size() > most_points) return std::nullopt;
      const Point point = stay_[i];
      Raw& own = raw.emplace_back();
      // Of all steps together.
      const Real least = ignored_ / (likely[i] * steps * finer);
      const KnownRow& next = row(point.state, least);
      own.unknown = next.row.left_out;
      for (std::size_t e = 0; e < next.row.edges.size(); ++e) {
        const Branch& edge = next.row.edges[e];
        if (edge.probability.upper < least) {
          own.unknown = rounding::up(own.unknown + next.rest[e], 1);
          break;
        }
        const Point to = process_.follow(point, edge, now_ + 1);
        if (process_.wanted(to.state)) {
          own.wanted = own.wanted + edge.probability;
          continue;
        }
        const Real mass = likely[i] * std::min<Real>(1, steps * edge.probability.upper);
        const bool known = positions.contains(to);
        if (!known && mass < ignored_) {
          own.unknown = rounding::up(own.unknown + edge.probability.upper, 1);
          continue;
        }
        if (process_.follow(point, edge, until) != to || process_.lasts_until(to) < until) return std::nullopt;
        own.inside.emplace_back(meet(to, mass), edge.probability);
      }
    }
    const auto last = static_cast<std::uint32_t>(stay_.size());
    std::vector<SparseMatrix::SparseRow> rows;
    for (Raw& own : raw) {
      auto& row = rows.emplace_back(std::move(own.inside));
      std::sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      if (own.wanted.upper > 0) row.emplace_back(last, as_probability(own.wanted));
      if (own.unknown > 0) row.emplace_back(last + 1, Enclosure{0, std::min<Real>(own.unknown, 1)});
    }
    rows.push_back({{last, certain()}});
    rows.push_back({{last + 1, certain()}});
    return SparseMatrix(std::move(rows));
  }

  Process& process_;
  Real ignored_;
  KnownRows& rows_;
  Meter& meter_;
  Units now_ = 0;
  std::vector<std::pair<Point, Enclosure>> points_;  ///< where runs are, sorted
  std::vector<std::pair<Point, Enclosure>> next_;
  Positions positions_;   ///< in `next_`
  bool same_ = false;     ///< the last step led to the points that it began at
  Units not_before_ = 0;  ///< no stretch was found, and none is looked for sooner
  std::vector<Point> stay_;
  Enclosure wanted_;
  Real unknown_ = 0;
};

}  // namespace

std::vector<Reached> walk(Process& process, const std::vector<Units>& steps, Real ignored, KnownRows& known,
                          Meter& meter) {
  return Walk(process, ignored, known, meter).run(steps);
}

}  // namespace rmpl::verifier
