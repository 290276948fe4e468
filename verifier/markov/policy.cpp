// Policies made better.
// SPDX-License-Identifier: MIT
#include "verifier/markov/policy.hpp"

#include <algorithm>
#include <cmath>

#include "verifier/markov/elimination.hpp"

namespace rmpl::verifier {

namespace {

/// More rounds than it takes where all states are made better at once.
constexpr std::size_t most_improvements = 1000;

struct Change {
  Real lower = 0, upper = 0;
};

class PolicySearch {
 public:
  PolicySearch(const Choices& choices, const std::vector<bool>& pays, Payment payment, Aim aim, Meter& meter)
      : choices_(choices),
        pays_(pays),
        payment_(payment),
        aim_(aim),
        meter_(meter),
        chosen_(choices.size(), 0),
        values_(choices.size(), 0) {}

  BestPolicy run() {
    choose_some();
    evaluate();
    for (std::size_t round = 0; round < most_improvements && make_better(); ++round) evaluate();
    BestPolicy result{values_, {}, 0, 0};
    for (const Fate& fate : fates_of_choices(false)) {
      const Enclosure ends{fate.wanted.lower, rounding::up(fate.wanted.upper + fate.unknown.upper, 1)};
      result.certain.push_back(payment_ == Payment::each_step ? fate.time : as_probability(ends));
    }
    for (std::size_t s = 0; s < choices_.size(); ++s) {
      for (std::size_t r = 0; r < choices_[s].size(); ++r) {
        const Change change = change_by(s, r);
        if (aim_ == Aim::greatest || r == chosen_[s]) result.above = std::max(result.above, change.upper);
        if (aim_ == Aim::least || r == chosen_[s]) result.below = std::max(result.below, -change.lower);
      }
    }
    return result;
  }

 private:
  /// Choices that lead to an end some day: from each state to one that has chosen before, or out of what is known.
  void choose_some() {
    std::vector<bool> done;
    for (const auto& rows : choices_) done.push_back(rows.empty());
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t s = done.size(); s-- > 0;) {
        for (std::size_t r = 0; r < choices_[s].size() && !done[s]; ++r) {
          const Row& row = *choices_[s][r];
          const bool leads = row.left_out > 0 || std::any_of(row.edges.begin(), row.edges.end(),
                                                             [&](const Branch& edge) { return done[edge.to]; });
          if (!leads) continue;
          chosen_[s] = r;
          done[s] = changed = true;
        }
      }
    }
  }

  /// What becomes of runs by the choices. `middle`: probabilities are taken in the middle of their bounds.
  [[nodiscard]] std::vector<Fate> fates_of_choices(bool middle) const {
    DecisionProcess chain{std::vector<std::vector<Row>>(choices_.size()), pays_, {}};
    for (std::size_t s = 0; s < choices_.size(); ++s) {
      if (choices_[s].empty()) continue;
      Row& row = chain.rows[s].emplace_back(*choices_[s][chosen_[s]]);
      for (Branch& edge : row.edges) {
        if (!middle) break;
        const Real own = (edge.probability.lower + edge.probability.upper) / 2;
        edge.probability = {own, own};
      }
    }
    return fates(chain, {}, meter_);
  }

  /// What is chosen, as near as numbers go: where states are worth all but the same, errors that they share do no harm.
  void evaluate() {
    const std::vector<Fate> all = fates_of_choices(true);
    for (std::size_t s = 0; s < values_.size(); ++s) {
      const Enclosure& own = payment_ == Payment::each_step ? all[s].time : all[s].wanted;
      values_[s] = choices_[s].empty() ? end_value(s) : (own.lower + own.upper) / 2;
    }
  }

  [[nodiscard]] Real end_value(std::size_t state) const { return payment_ == Payment::at_end && pays_[state] ? 1 : 0; }

  /// Whether another choice is certain to be better, somewhere: it is taken.
  bool make_better() {
    bool better = false;
    for (std::size_t s = 0; s < choices_.size(); ++s) {
      if (choices_[s].size() < 2) continue;
      meter_.poll();
      const std::size_t before = chosen_[s];
      const Change own = change_by(s, before);
      Real best = aim_ == Aim::greatest ? own.upper : -own.lower;
      for (std::size_t r = 0; r < choices_[s].size(); ++r) {
        const Change change = change_by(s, r);
        const Real worth = aim_ == Aim::greatest ? change.lower : -change.upper;
        if (!(worth > best)) continue;
        best = worth;
        chosen_[s] = r;
      }
      better = better || chosen_[s] != before;
    }
    return better;
  }

  /// What the payment of one step and the values that follow are more than the value: a sum over differences, which
  /// loses no digits where values are great and all but the same. Probabilities sum to 1.
  [[nodiscard]] Change change_by(std::size_t state, std::size_t choice) const {
    const Row& row = *choices_[state][choice];
    const Real paid = payment_ == Payment::each_step ? 1 : 0;
    Enclosure gain{paid, paid};
    Enclosure loss;
    std::size_t count = 8;
    for (const Branch& edge : row.edges) {
      const Real difference = values_[edge.to] - values_[state];
      Enclosure& side = difference > 0 ? gain : loss;
      side.lower += edge.probability.lower * std::fabs(difference);
      side.upper += edge.probability.upper * std::fabs(difference);
      count += 3;
    }
    if (payment_ == Payment::at_end) gain.upper += row.left_out;
    loss.upper += row.left_out * values_[state];
    const Real slack = rounding::up(rounding::unit * (gain.upper + loss.upper), count) * static_cast<Real>(count);
    return {gain.lower - loss.upper - slack, gain.upper - loss.lower + slack};
  }

  const Choices& choices_;
  const std::vector<bool>& pays_;
  Payment payment_;
  Aim aim_;
  Meter& meter_;
  std::vector<std::size_t> chosen_;  ///< by state: of its choices
  std::vector<Real> values_;
};

}  // namespace

BestPolicy best_policy(const Choices& choices, const std::vector<bool>& pays, Payment payment, Aim aim, Meter& meter) {
  return PolicySearch(choices, pays, payment, aim, meter).run();
}

}  // namespace rmpl::verifier
