// The distribution over the points of a chain, followed forward.
// SPDX-License-Identifier: MIT
#include "verifier/markov/walk.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "verifier/markov/episodes.hpp"
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

class Walk {
 public:
  Walk(Process& process, Units last, const Tolerance& tolerance, KnownRows& known, Meter& meter)
      : process_(process),
        last_(last),
        ignored_(tolerance.ignored),
        rows_(process, known),
        meter_(meter),
        front_(process, rows_, last, tolerance.ignored, tolerance.all),
        episodes_(process, rows_, last, tolerance, meter) {}

  std::vector<Reached> run(const std::vector<Units>& steps) {
    for (const Process::Start& start : process_.initial()) front_.arrive(start.point, start.probability);
    settle();
    std::vector<Reached> result;
    for (const Units step : steps) {
      while (now_ < step && !(front_.points().empty() && episodes_.none_goes_on())) {
        if (!stretch(step)) walk_step();
      }
      now_ = step;
      result.push_back({step, reached()});
    }
    return result;
  }

 private:
  /// What has been reached, and at most all that is not known.
  [[nodiscard]] Enclosure reached() const {
    const Enclosure all{front_.wanted().lower, rounding::up(front_.wanted().upper + front_.unknown(), 1)};
    return as_probability(all);
  }

  void settle() {
    front_.settle(
        now_, [this](const Point& point, const Enclosure& mass) { return episodes_.takes(point, mass, now_, front_); });
  }

  void walk_step() {
    meter_.poll();
    meter_.at_steps(static_cast<std::size_t>(now_), front_.points().size());
    ++now_;
    front_.leave(now_);
    episodes_.leave(now_, front_);
    settle();
  }

  /// Many steps at once, none later than `end`; none where they are not all alike.
  bool stretch(Units end) {
    if (!front_.is_same() || !episodes_.none_goes_on() || now_ < not_before_) return false;
    Units until = end;
    for (const auto& [point, mass] : front_.points()) until = std::min(until, process_.lasts_until(point));
    if (until - now_ < shortest_stretch) return false;
    auto matrix = matrix_until(until);
    if (!matrix) {
      not_before_ = now_ + steps_between_looks;
      return false;
    }
    const std::vector<Point>& stay = stay_.points();
    std::vector<Enclosure> masses(stay.size() + 2);
    for (std::size_t i = 0; i < front_.points().size(); ++i) masses[i] = front_.points()[i].mass;
    masses =
        after_steps(std::move(masses), std::move(*matrix), static_cast<std::uint64_t>(until - now_), ignored_, meter_);
    now_ = until;
    front_.begin_anew();
    front_.add_wanted(masses[stay.size()]);
    front_.add_unknown(masses[stay.size() + 1].upper);
    for (std::size_t i = 0; i < stay.size(); ++i) front_.arrive(stay[i], masses[i]);
    settle();
    return true;
  }

  /// What one step does until then, over the points that a likely run may meet, `stay_`, and two more: what is wanted,
  /// and what is unknown. Nothing where a long clock may come to a bound, or start anew, on such a run.
  std::optional<SparseMatrix> matrix_until(Units until) {
    const Real steps = static_cast<Real>(until - now_);
    std::vector<Real> likely;  // at most how likely a run is there at some time, by order of magnitude
    stay_.clear();
    const auto meet = [&](const Point& point, Real mass) {
      const std::uint32_t at = stay_.number(point);
      if (at == likely.size()) likely.push_back(mass);
      return at;
    };
    for (const auto& [point, mass] : front_.points()) meet(point, mass.upper);
    struct Raw {
      std::vector<std::pair<std::uint32_t, Enclosure>> inside;
      Enclosure wanted;
      Real unknown = 0;
    };
    std::vector<Raw> raw;
    for (std::size_t i = 0; i < stay_.points().size(); ++i) {
      meter_.poll();
      if (stay_.points().size() > most_points) return std::nullopt;
      const Point point = stay_.points()[i];
      Raw& own = raw.emplace_back();
      // Of all steps together.
      const Real least = ignored_ / (likely[i] * steps * finer);
      const KnownRow& next = rows_.of(point.state, least);
      own.unknown = rounding::up(next.row.left_out + next.row.foreseen.within(last_ - now_), 1);
      for (std::size_t e = 0; e < next.row.edges.size(); ++e) {
        const Branch& edge = next.row.edges[e];
        if (e < next.wanted) {
          own.wanted = own.wanted + edge.probability;
          continue;
        }
        const Real mass = likely[i] * std::min<Real>(1, steps * edge.probability.upper);
        const Real prospect = next.prospects[e].within(last_ - now_);
        const Point to = process_.follow(point, edge, now_ + 1);
        const bool known = stay_.contains(to);
        if (!known && mass * prospect < ignored_) {
          own.unknown = rounding::up(own.unknown + edge.probability.upper * prospect, 2);
          continue;
        }
        if (process_.follow(point, edge, until) != to || process_.lasts_until(to) < until) return std::nullopt;
        own.inside.emplace_back(meet(to, mass), edge.probability);
      }
    }
    const auto last = static_cast<std::uint32_t>(stay_.points().size());
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
  Units last_;
  Real ignored_;
  RowMemory rows_;
  Meter& meter_;
  Units now_ = 0;
  Front front_;
  Episodes episodes_;
  Units not_before_ = 0;  ///< no stretch was found, and none is looked for sooner
  PointNumbers stay_;
};

}  // namespace

std::vector<Reached> walk(Process& process, const std::vector<Units>& steps, const Tolerance& tolerance,
                          KnownRows& known, Meter& meter) {
  return Walk(process, steps.back(), tolerance, known, meter).run(steps);
}

}  // namespace rmpl::verifier
