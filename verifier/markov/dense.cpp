// Uniformisation with certain bounds.
// SPDX-License-Identifier: MIT
#include "verifier/markov/dense.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "verifier/markov/elimination.hpp"
#include "verifier/markov/jumps.hpp"
#include "verifier/markov/sparse.hpp"
#include "verifier/markov/unbounded.hpp"
#include "verifier/property/initial_modes.hpp"

namespace rmpl::verifier {

using automata::Ticks;

namespace {

/// Jumps of the uniformised chain that a stretch of time has in the mean, at most: e to the minus of it is far from the
/// least number there is.
constexpr Real longest_stretch = 256;
/// Beyond so many jumps in the mean, a stretch of one jump is made a matrix, and that is squared.
constexpr Real most_jumps = 200'000;

/// The chance of so many jumps where there are `mean` in the mean, one after the other, and of more.
struct Jumped {
  std::vector<Enclosure> chances;  ///< from 0 on
  Real more = 0;                   ///< at most
};

/// `mean` is at most `longest_stretch`. What is cut off is less than `negligible`.
Jumped jumped(const Enclosure& mean, Real negligible) {
  // exp of a bound that is off by one unit is off by `mean` of them.
  constexpr std::size_t errors = 1024;
  Jumped result;
  Enclosure chance = outward({std::exp(-mean.upper), std::exp(-mean.lower)}, errors);
  for (std::size_t k = 0;; ++k) {
    result.chances.push_back(chance);
    const Real next = static_cast<Real>(k + 1);
    const Enclosure ratio = outward({mean.lower / next, mean.upper / next}, 1);
    chance = chance * ratio;
    // From there on each is less than nine tenths of the one before, and all of them less than ten times this one.
    if (ratio.upper < 0.9L && 11 * chance.upper < negligible) {
      result.more = rounding::up(11 * chance.upper, 1);
      return result;
    }
  }
}

class Uniformised {
 public:
  /// The chain that jumps at one rate everywhere, now and then to where it is; behind its states what is wanted and
  /// what is unknown.
  Uniformised(const Jumps& jumps, Meter& meter) : meter_(meter), wanted_(jumps.chain.size()) {
    for (const Enclosure& rate : jumps.rates) rate_ = std::max(rate_, rate.upper);
    rate_ = rounding::up(rate_, 1);
    std::vector<SparseMatrix::SparseRow> rows;
    const auto wanted = static_cast<std::uint32_t>(wanted_);
    for (std::size_t s = 0; s < jumps.chain.size(); ++s) {
      auto& own = rows.emplace_back();
      if (jumps.chain.wanted[s]) {
        own.push_back({wanted, certain()});
        continue;
      }
      if (jumps.chain.rows[s].empty()) continue;
      const Row& row = jumps.chain.rows[s].front();
      const Enclosure leaves = jumps.rates[s] / Enclosure{rate_, rate_};
      std::map<std::uint32_t, Enclosure> sums;
      for (const Branch& edge : row.edges) {
        Enclosure& sum = sums[jumps.chain.wanted[edge.to] ? wanted : edge.to];
        sum = sum + leaves * edge.probability;
      }
      if (row.left_out > 0) sums[wanted + 1] = leaves * Enclosure{0, row.left_out};
      Enclosure& stays = sums[static_cast<std::uint32_t>(s)];
      // Jumps back to the state itself, by way of instants, are among `leaves`.
      stays = stays + Enclosure{rounding::down(std::max<Real>(1 - leaves.upper, 0), 1),
                                std::min<Real>(rounding::up(std::max<Real>(1 - leaves.lower, 0), 1), 1)};
      for (const auto& [to, sum] : sums) own.push_back({to, as_probability(sum)});
    }
    rows.push_back({{wanted, certain()}});
    rows.push_back({{wanted + 1, certain()}});
    steps_.emplace(std::move(rows));
  }

  [[nodiscard]] std::vector<Enclosure> start(const Jumps& jumps) const {
    std::vector<Enclosure> result(wanted_ + 2);
    for (const auto& [point, probability] : jumps.chain.start) {
      Enclosure& own = result[jumps.chain.wanted[point.state] ? wanted_ : point.state];
      own = own + probability;
    }
    return result;
  }

  [[nodiscard]] Enclosure reached(const std::vector<Enclosure>& distribution) const {
    const Real unknown = distribution[wanted_ + 1].upper;
    return as_probability({distribution[wanted_].lower, rounding::up(distribution[wanted_].upper + unknown, 1)});
  }

  /// The distribution so much later.
  [[nodiscard]] std::vector<Enclosure> later(std::vector<Enclosure> distribution, Ticks time, Real negligible) const {
    const Real seconds = static_cast<Real>(time.count) / Ticks::per_second;
    const Real jumps = rate_ * seconds;
    if (jumps == 0) return distribution;
    const bool squares = jumps > most_jumps;
    const Real parts = std::ceil(jumps / (squares ? 1 : longest_stretch));
    const Real mean = jumps / parts;
    const Jumped chances = jumped(outward({mean, mean}, 8), negligible / parts);
    if (squares) {
      return after_steps(std::move(distribution), stretch(chances), static_cast<std::uint64_t>(parts), negligible,
                         meter_);
    }
    for (Real part = 0; part < parts; ++part) distribution = after(distribution, chances);
    return distribution;
  }

 private:
  [[nodiscard]] std::vector<Enclosure> after(const std::vector<Enclosure>& distribution, const Jumped& jumped) const {
    std::vector<Enclosure> result(distribution.size());
    std::vector<Enclosure> now = distribution;
    for (std::size_t k = 0; k < jumped.chances.size(); ++k) {
      meter_.poll();
      if (k > 0) now = steps_->from_left(now);
      for (std::size_t s = 0; s < now.size(); ++s) {
        if (now[s].upper > 0) result[s] = result[s] + jumped.chances[k] * now[s];
      }
    }
    result[wanted_ + 1] = result[wanted_ + 1] + Enclosure{0, jumped.more};
    return result;
  }

  /// What a stretch does, state by state.
  [[nodiscard]] SparseMatrix stretch(const Jumped& jumped) const {
    std::vector<SparseMatrix::SparseRow> rows;
    for (std::size_t s = 0; s < steps_->size(); ++s) {
      meter_.poll();
      std::map<std::uint32_t, Enclosure> sums;
      std::map<std::uint32_t, Enclosure> now{{static_cast<std::uint32_t>(s), certain()}};
      for (std::size_t k = 0; k < jumped.chances.size(); ++k) {
        if (k > 0) {
          std::map<std::uint32_t, Enclosure> next;
          for (const auto& [at, value] : now) {
            for (const auto& [to, probability] : steps_->row(at)) next[to] = next[to] + value * probability;
          }
          now = std::move(next);
        }
        for (const auto& [at, value] : now) sums[at] = sums[at] + jumped.chances[k] * value;
      }
      Enclosure& unknown = sums[static_cast<std::uint32_t>(wanted_ + 1)];
      unknown = unknown + Enclosure{0, jumped.more};
      auto& row = rows.emplace_back();
      for (const auto& [at, value] : sums) row.push_back({at, as_probability(value)});
    }
    rows[wanted_] = {{static_cast<std::uint32_t>(wanted_), certain()}};
    rows[wanted_ + 1] = {{static_cast<std::uint32_t>(wanted_ + 1), certain()}};
    return SparseMatrix(std::move(rows));
  }

  Meter& meter_;
  std::size_t wanted_;
  Real rate_ = 0;
  std::optional<SparseMatrix> steps_;
};

std::vector<Ticks> times_of(const ProbabilityQuestion& question) {
  std::vector<Ticks> result;
  for (std::size_t i = 0; i + 1 < question.points; ++i) {
    const auto part = static_cast<long double>(i) / static_cast<long double>(question.points - 1);
    result.push_back({static_cast<std::int64_t>(part * static_cast<long double>(question.within->count))});
  }
  result.push_back(*question.within);
  return result;
}

void walk_to(const Jumps& jumps, const ProbabilityQuestion& question, Likelihood& result, Meter& meter) {
  const Uniformised chain(jumps, meter);
  // What is cut off is made less until it does not matter beside the answer.
  for (Real negligible = 1e-12L; negligible > 1e-300L; negligible *= negligible) {
    std::vector<Enclosure> distribution = chain.start(jumps);
    Ticks now{};
    result.curve.clear();
    for (const Ticks time : times_of(question)) {
      distribution = chain.later(std::move(distribution), time - now, negligible);
      now = time;
      result.probability = chain.reached(distribution);
      if (question.points > 0) result.curve.push_back({time, result.probability});
    }
    if (is_within(result.probability, static_cast<Real>(question.precision)) || question.faults) return;
  }
}

}  // namespace

ProbabilityAnswer dense_probability(automata::PlantStep& step, const ProbabilityQuestion& question,
                                    const std::function<bool(const automata::Modes&)>& wanted, Meter& meter) {
  demand_modes(step.plant(), question.from);
  std::size_t actions = 0;
  for_each_action(step.plant(), question.commands, [&](const automata::ControlAction&) { ++actions; });
  if (actions > 1) {
    throw base::InputError(
        "dense time: a command could come at any moment, and which is best is not worked out; expected --commands "
        "none, "
        "or a period in --time");
  }
  const Jumps chain = jumps(step, {wanted, question.from, question.faults}, meter);
  ProbabilityAnswer answer;
  answer.faults_at_most = question.faults;
  answer.startless = chain.chain.start.empty();
  Likelihood& only = answer.only.emplace();
  const auto precision = static_cast<Real>(question.precision);
  const std::vector<bool> possible = may_reach(chain.chain);
  const bool any = std::any_of(chain.chain.start.begin(), chain.chain.start.end(),
                               [&](const Process::Start& start) { return possible[start.point.state]; });
  if (question.within && (any || question.points > 0)) {
    walk_to(chain, question, only, meter);
  } else if (any) {
    only.probability = ever(chain.chain, Aim::greatest, meter);
  }
  answer.precise = is_within(only.probability, precision);
  if (!question.mean_time) return answer;
  MeanTime& mean = only.mean_time.emplace();
  const std::vector<bool> sure = surely_reach(chain.chain, Aim::least);
  mean.infinite = std::any_of(chain.chain.start.begin(), chain.chain.start.end(),
                              [&](const Process::Start& start) { return !sure[start.point.state]; });
  if (mean.infinite) return answer;
  std::vector<Enclosure> times;
  for (const Enclosure& rate : chain.rates) times.push_back(rate.upper > 0 ? certain() / rate : Enclosure{});
  std::vector<Enclosure> values;
  for (const Fate& fate : fates(chain.chain, times, meter)) values.push_back(fate.time);
  mean.seconds = chain.chain.at_start(values);
  answer.precise = answer.precise && is_within(mean.seconds, precision);
  return answer;
}

}  // namespace rmpl::verifier
