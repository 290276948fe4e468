// Chains by elimination, choices by policies.
// SPDX-License-Identifier: MIT
#include "verifier/markov/unbounded.hpp"

#include <algorithm>

#include "verifier/markov/elimination.hpp"
#include "verifier/markov/policy.hpp"

namespace rmpl::verifier {

namespace {

bool everywhere(const DecisionProcess& decisions, const std::vector<bool>& where) {
  return std::all_of(decisions.start.begin(), decisions.start.end(),
                     [&](const Process::Start& start) { return where[start.point.state]; });
}

/// States that may stay together for ever are one, which has the choices to leave of them all.
DecisionProcess collapsed(const DecisionProcess& decisions, Meter& meter) {
  const std::vector<std::uint32_t> part = end_components(decisions, meter);
  std::vector<StateNumber> first_of(decisions.size() + 2, 0);
  std::vector<StateNumber> name(decisions.size());
  std::vector<bool> known(decisions.size() + 2, false);
  for (std::size_t s = 0; s < decisions.size(); ++s) {
    name[s] = static_cast<StateNumber>(s);
    if (part[s] == 0) continue;
    if (!known[part[s]]) first_of[part[s]] = static_cast<StateNumber>(s);
    known[part[s]] = true;
    name[s] = first_of[part[s]];
  }
  DecisionProcess result{std::vector<std::vector<Row>>(decisions.size()), decisions.wanted, decisions.start};
  for (Process::Start& start : result.start) start.point.state = name[start.point.state];
  for (std::size_t s = 0; s < decisions.size(); ++s) {
    for (const Row& row : decisions.rows[s]) {
      Row renamed{{}, row.left_out};
      bool leaves = row.left_out > 0;
      for (Branch edge : row.edges) {
        edge.to = name[edge.to];
        leaves = leaves || part[s] == 0 || edge.to != name[s];
        const auto at = std::find_if(renamed.edges.begin(), renamed.edges.end(),
                                     [&](const Branch& other) { return other.to == edge.to; });
        if (at == renamed.edges.end()) {
          renamed.edges.push_back(edge);
        } else {
          at->probability = at->probability + edge.probability;
        }
      }
      if (leaves) result.rows[name[s]].push_back(std::move(renamed));
    }
  }
  return result;
}

/// A row that leads back to its own state, as what it leads to where it leaves.
void leave_at_once(DecisionProcess& decisions) {
  for (std::size_t s = 0; s < decisions.size(); ++s) {
    for (Row& row : decisions.rows[s]) {
      Enclosure out{0, row.left_out};
      bool stays = false;
      for (const Branch& edge : row.edges) {
        if (edge.to == s) {
          stays = true;
        } else {
          out = out + edge.probability;
        }
      }
      if (!stays || out.lower == 0) continue;
      std::erase_if(row.edges, [&](const Branch& edge) { return edge.to == s; });
      for (Branch& edge : row.edges) edge.probability = as_probability(edge.probability / out);
      if (row.edges.size() == 1 && row.left_out == 0) row.edges.front().probability = certain();
      row.left_out = std::min<Real>(rounding::up(row.left_out / out.lower, 1), 1);
    }
  }
}

Enclosure of_chain(const DecisionProcess& chain, Meter& meter) {
  const std::vector<Fate> all = fates(chain, {}, meter);
  std::vector<Enclosure> values;
  values.reserve(all.size());
  for (const Fate& fate : all) {
    values.push_back({fate.wanted.lower, rounding::up(fate.wanted.upper + fate.unknown.upper, 1)});
  }
  return as_probability(chain.at_start(values));
}

/// What all choices together may be worth: on one side the policy is as good as it is for certain, on the other it may
/// be as far from the best as `bounds` say.
Enclosure within(const BestPolicy& best, std::size_t state, Aim aim, Enclosure bounds) {
  const Enclosure& own = best.certain[state];
  if (aim == Aim::greatest) {
    bounds.lower = std::max(bounds.lower, own.lower);
  } else {
    bounds.upper = std::min(bounds.upper, own.upper);
  }
  return {std::min(bounds.lower, bounds.upper), bounds.upper};
}

/// Bounds of the mean number of steps until an end. Values to which a step more adds the part c of itself at most are
/// too small by that part at most: 1 / (1 - c) times as much loses nothing by a step more, and is no less than the
/// best. Lower bounds likewise. Nothing is known above where a step adds itself or more.
std::vector<Enclosure> steps_by(const Choices& choices, Aim aim, Meter& meter) {
  std::vector<bool> ends;
  for (const auto& rows : choices) ends.push_back(rows.empty());
  const BestPolicy best = best_policy(choices, ends, Payment::each_step, aim, meter);
  std::vector<Enclosure> result(choices.size());
  for (std::size_t s = 0; s < choices.size(); ++s) {
    if (choices[s].empty()) continue;
    const Real above = best.above < 1 ? rounding::up(best.values[s] / (1 - best.above), 4) : unbounded_time;
    result[s] = within(best, s, aim, {rounding::down(best.values[s] / (1 + best.below), 4), above});
  }
  return result;
}

/// Bounds of what choices without end components are worth. Values that are w more, where no choice adds more than c in
/// a step, and w pays for c in each step of all runs, are no less than the best: one step more adds nothing to them.
std::vector<Enclosure> reached_by(const Choices& choices, const std::vector<bool>& pays, Aim aim, Meter& meter) {
  const BestPolicy best = best_policy(choices, pays, Payment::at_end, aim, meter);
  const std::vector<Enclosure> steps = steps_by(choices, Aim::greatest, meter);
  std::vector<Enclosure> result(choices.size());
  for (std::size_t s = 0; s < choices.size(); ++s) {
    const Real value = best.values[s];
    if (choices[s].empty()) {
      result[s] = {value, value};
      continue;
    }
    const Real below = best.below > 0 ? rounding::up(best.below * steps[s].upper, 2) : 0;
    const Real above = best.above > 0 ? rounding::up(best.above * steps[s].upper, 2) : 0;
    const Real lower = value > below ? rounding::down(value - below, 2) : 0;
    result[s] = as_probability(within(best, s, aim, {lower, rounding::up(value + above, 2)}));
  }
  return result;
}

}  // namespace

Enclosure ever(const DecisionProcess& original, Aim aim, Meter& meter) {
  const std::vector<bool> sure = surely_reach(original, aim);
  if (everywhere(original, sure)) return original.start.empty() ? Enclosure{} : certain();
  std::vector<bool> none = aim == Aim::greatest ? may_reach(original) : may_avoid(original);
  if (aim == Aim::greatest) none.flip();
  if (everywhere(original, none)) return {};
  if (original.is_chain()) return of_chain(original, meter);
  DecisionProcess decisions = aim == Aim::greatest ? collapsed(original, meter) : original;
  leave_at_once(decisions);
  // Where the graph decides, a run has come to its end.
  Choices choices(decisions.size());
  std::vector<bool> pays(decisions.size());
  for (std::size_t s = 0; s < choices.size(); ++s) {
    pays[s] = decisions.wanted[s] || sure[s];
    if (pays[s] || none[s]) continue;
    for (const Row& row : decisions.rows[s]) choices[s].push_back(&row);
  }
  return as_probability(decisions.at_start(reached_by(choices, pays, aim, meter)));
}

Enclosure mean_steps(const DecisionProcess& decisions, Aim aim, Meter& meter) {
  // The least mean is that of choices that are sure to come there; the greatest is infinite where any are not.
  const std::vector<bool> sure = surely_reach(decisions, aim == Aim::least ? Aim::greatest : Aim::least);
  if (!everywhere(decisions, sure)) return {unbounded_time, unbounded_time};
  if (decisions.is_chain()) {
    std::vector<Enclosure> values;
    for (const Fate& fate : fates(decisions, {}, meter)) values.push_back(fate.time);
    return decisions.at_start(values);
  }
  Choices choices(decisions.size());
  for (std::size_t s = 0; s < choices.size(); ++s) {
    for (const Row& row : decisions.rows[s]) {
      const bool stays = row.left_out == 0 && !row.edges.empty() &&
                         std::all_of(row.edges.begin(), row.edges.end(), [&](const Branch& e) { return sure[e.to]; });
      if (sure[s] && stays) choices[s].push_back(&row);
    }
  }
  return decisions.at_start(steps_by(choices, aim, meter));
}

}  // namespace rmpl::verifier
