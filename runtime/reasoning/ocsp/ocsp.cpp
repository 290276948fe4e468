// Conflict-directed best-first search over disjoint sets of assignments.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/ocsp/ocsp.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"

namespace rmpl::runtime {

void ConflictSet::add(Conflict conflict) {
  std::sort(conflict.begin(), conflict.end());
  if (std::find(conflicts_.begin(), conflicts_.end(), conflict) != conflicts_.end()) return;
  conflicts_.push_back(std::move(conflict));
}

namespace {

/// Of the finest units in which such a sum stays below 2^62 of them.
int exponent_of(double sum) { return sum > 0 ? std::ilogb(sum) + 1 - 62 : std::numeric_limits<int>::min(); }

}  // namespace

OptimalSearch::Domain::Domain(std::span<const double> costs, int exponent) {
  for (const double cost : costs) {
    CHECK(cost >= 0);
    if (std::isfinite(cost)) greatest_ = std::max(greatest_, cost);
  }
  exponent_ = std::max(exponent, exponent_of(greatest_));
  choices_.reserve(costs.size());
  for (std::size_t v = 0; v < costs.size(); ++v) {
    if (!std::isfinite(costs[v])) continue;
    choices_.push_back({static_cast<std::uint32_t>(v), std::llround(std::ldexp(costs[v], -exponent_)), costs[v]});
  }
  std::sort(choices_.begin(), choices_.end(), [](const PricedValue& a, const PricedValue& b) {
    return a.units != b.units ? a.units < b.units : a.value < b.value;
  });
}

OptimalSearch::OptimalSearch(const Costs& costs, std::shared_ptr<ConflictSet> conflicts) {
  std::vector<Domain> domains;
  std::vector<const Domain*> shared;
  domains.reserve(costs.size());
  for (const auto& values : costs) shared.push_back(&domains.emplace_back(values));
  restart(shared, std::move(conflicts));
  if (own_.empty()) own_ = std::move(domains);
}

void OptimalSearch::restart(std::span<const Domain* const> domains, std::shared_ptr<ConflictSet> conflicts) {
  conflicts_ = conflicts ? std::move(conflicts) : std::make_shared<ConflictSet>();
  candidate_.assign(domains.size(), 0);
  rank_.assign(domains.size(), 0);
  deviating_.clear();
  fixed_in_.assign(domains.size(), 0);
  split_number_ = 0;
  of_cheapest_.clear();
  first_watched_.assign(domains.size(), none);
  next_watched_.clear();
  queue_.clear();
  splits_.clear();
  alternatives_.clear();
  deviations_.clear();
  budget_ = std::numeric_limits<std::size_t>::max();
  checked_ = 0;

  double greatest = 1;
  for (const Domain* const domain : domains) greatest += domain->greatest();
  const int exponent = std::max(Domain::finest, exponent_of(greatest));
  unit_ = std::ldexp(1.0, exponent);
  own_.clear();
  choices_.clear();
  if (exponent == Domain::finest) {
    for (const Domain* const domain : domains) choices_.push_back(domain->choices());
  } else {
    own_.reserve(domains.size());
    for (const Domain* const domain : domains) {
      std::vector<double> costs;
      for (const PricedValue& choice : domain->choices()) {
        costs.resize(std::max<std::size_t>(costs.size(), choice.value + 1), std::numeric_limits<double>::infinity());
        costs[choice.value] = choice.cost;
      }
      choices_.push_back(own_.emplace_back(costs, exponent).choices());
    }
  }

  Node root{.cost = 0, .split = none, .position = 0, .deviations = {}};
  for (const auto& choices : choices_) {
    if (choices.empty()) return;
    root.cost += choices.front().units;
  }
  for (std::size_t x = 0; x < choices_.size(); ++x) candidate_[x] = choices_[x].front().value;
  push(root);
}

OptimalSearch::Outcome OptimalSearch::next(const Check& check) {
  const auto by_priority = [this](const Node& a, const Node& b) { return later(a, b); };
  while (!queue_.empty()) {
    const Node node = queue_.front();
    take_candidate(node);
    const Conflict* known = known_conflict(node);
    if (known == nullptr && budget_ == 0) return Outcome::budget;

    std::pop_heap(queue_.begin(), queue_.end(), by_priority);
    queue_.pop_back();
    if (node.split != none) push_child(node.split, node.position + 1);
    if (known != nullptr) {
      split(node, *known);
      continue;
    }
    --budget_;
    ++checked_;
    const std::optional<Conflict> conflict = check(candidate_);
    if (!conflict) {
      decisions_.clear();
      for (std::uint32_t x = 0; x < candidate_.size(); ++x) decisions_.push_back({x, candidate_[x]});
      split(node, decisions_);
      return Outcome::solution;
    }
    CHECK(std::all_of(conflict->begin(), conflict->end(),
                      [this](const Decision& d) { return candidate_[d.variable] == d.value; }));
    conflicts_->add(*conflict);
    if (conflict->empty()) {
      queue_.clear();
    } else {
      split(node, *conflict);
    }
    if (budget_ == 0 && !queue_.empty()) return Outcome::budget;
  }
  return Outcome::exhausted;
}

double OptimalSearch::cost() const {
  double sum = 0;
  for (std::size_t x = 0; x < choices_.size(); ++x) sum += choices_[x][rank_[x]].cost;
  return sum;
}

double OptimalSearch::bound() const {
  if (queue_.empty()) return std::numeric_limits<double>::infinity();
  // Each cost was rounded by half a unit at most.
  const double rounding = 0.5 * static_cast<double>(choices_.size()) * unit_;
  return std::max(0.0, static_cast<double>(queue_.front().cost) * unit_ - rounding);
}

/// Whether `a` comes after `b`: by cost, then by candidates in lexicographic order. Sets of nodes never overlap, so
/// candidates differ; as a candidate is the least of its node in this order, solutions come out in it.
bool OptimalSearch::later(const Node& a, const Node& b) const {
  if (a.cost != b.cost) return a.cost > b.cost;
  const auto in_a = std::span(deviations_).subspan(a.deviations.begin, a.deviations.size);
  const auto in_b = std::span(deviations_).subspan(b.deviations.begin, b.deviations.size);
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < in_a.size() || j < in_b.size()) {
    const bool a_deviates = i < in_a.size() && (j == in_b.size() || in_a[i].variable <= in_b[j].variable);
    const bool b_deviates = j < in_b.size() && (i == in_a.size() || in_b[j].variable <= in_a[i].variable);
    const std::uint32_t of_a = a_deviates ? value(in_a[i]) : choices_[in_b[j].variable].front().value;
    const std::uint32_t of_b = b_deviates ? value(in_b[j]) : choices_[in_a[i].variable].front().value;
    if (of_a != of_b) return of_a > of_b;
    i += a_deviates ? 1 : 0;
    j += b_deviates ? 1 : 0;
  }
  return false;
}

std::uint32_t OptimalSearch::value(const Deviation& deviation) const {
  return choices_[deviation.variable][deviation.rank].value;
}

/// Puts the ways out of a split in order only as far as they are asked for. Among equal costs the child with the
/// lexicographically smaller candidate comes first: at the first of the two variables one child has the next value and
/// the other still has the present one.
const OptimalSearch::Alternative& OptimalSearch::alternative(std::uint32_t split, std::uint32_t position) {
  Split& parent = splits_[split];
  const auto begin = alternatives_.begin() + static_cast<std::ptrdiff_t>(parent.alternatives.begin);
  if (position >= parent.in_order) {
    const auto earlier = [&](const Alternative& a, const Alternative& b) {
      if (a.delta != b.delta) return a.delta < b.delta;
      if (a.variable == b.variable) return false;
      const Alternative& first = a.variable < b.variable ? a : b;
      const std::span<const PricedValue> choices = choices_[first.variable];
      const std::uint32_t present = choices[rank_in(parent.node, first.variable)].value;
      const bool first_is_smaller = choices[first.rank].value < present;
      return first_is_smaller == (a.variable < b.variable);
    };
    const std::uint32_t wanted = std::min(parent.alternatives.size, std::max(4u, 4 * parent.in_order));
    std::partial_sort(begin + parent.in_order, begin + wanted, begin + parent.alternatives.size, earlier);
    parent.in_order = wanted;
  }
  return begin[static_cast<std::ptrdiff_t>(position)];
}

std::uint32_t OptimalSearch::rank_in(const Node& node, std::uint32_t variable) const {
  for (const Deviation& deviation : std::span(deviations_).subspan(node.deviations.begin, node.deviations.size)) {
    if (deviation.variable == variable) return deviation.rank;
  }
  return 0;
}

void OptimalSearch::take_candidate(const Node& node) {
  const auto take = [this](std::uint32_t variable, std::uint32_t rank) {
    rank_[variable] = rank;
    candidate_[variable] = choices_[variable][rank].value;
  };
  for (const std::uint32_t variable : deviating_) take(variable, 0);
  deviating_.clear();
  for (std::uint32_t i = 0; i < node.deviations.size; ++i) {
    const Deviation& deviation = deviations_[node.deviations.begin + i];
    take(deviation.variable, deviation.rank);
    deviating_.push_back(deviation.variable);
  }
}

/// Other searches may have found some.
void OptimalSearch::watch_new_conflicts() {
  const std::vector<Conflict>& conflicts = conflicts_->conflicts();
  for (std::size_t i = next_watched_.size(); i < conflicts.size(); ++i) {
    const auto watched = std::find_if(conflicts[i].begin(), conflicts[i].end(), [this](const Decision& d) {
      return choices_[d.variable].front().value != d.value;
    });
    if (watched == conflicts[i].end()) {
      of_cheapest_.push_back(static_cast<std::uint32_t>(i));
      next_watched_.push_back(none);
    } else {
      next_watched_.push_back(std::exchange(first_watched_[watched->variable], static_cast<std::uint32_t>(i)));
    }
  }
}

/// The first conflict, in order of adding, that the node's candidate holds; null where there is none. It lasts until
/// the next is added.
const Conflict* OptimalSearch::known_conflict(const Node& node) {
  watch_new_conflicts();
  const std::vector<Conflict>& conflicts = conflicts_->conflicts();
  const auto held = [&](std::uint32_t i) {
    return std::all_of(conflicts[i].begin(), conflicts[i].end(),
                       [this](const Decision& d) { return candidate_[d.variable] == d.value; });
  };
  const auto of_cheapest = std::find_if(of_cheapest_.begin(), of_cheapest_.end(), held);
  std::uint32_t first = of_cheapest == of_cheapest_.end() ? none : *of_cheapest;
  for (const Deviation& deviation : std::span(deviations_).subspan(node.deviations.begin, node.deviations.size)) {
    for (std::uint32_t i = first_watched_[deviation.variable]; i != none; i = next_watched_[i]) {
      if (i < first && held(i)) first = i;
    }
  }
  return first == none ? nullptr : &conflicts[first];
}

/// Whether a conflict says that the decision, which is not the cheapest of its variable, cannot be made at all.
bool OptimalSearch::excluded(const Decision& decision) const {
  const std::vector<Conflict>& conflicts = conflicts_->conflicts();
  for (std::uint32_t i = first_watched_[decision.variable]; i != none; i = next_watched_[i]) {
    if (conflicts[i].size() == 1 && conflicts[i].front() == decision) return true;
  }
  return false;
}

/// Divides the node, whose candidate makes all decisions of `conflict`, into the ways out of it. A variable that is
/// fixed or has no choice left gives no way out. The candidate itself is left behind.
void OptimalSearch::split(const Node& node, std::span<const Decision> conflict) {
  ++split_number_;
  for (const Node* ancestor = &node; ancestor->split != none; ancestor = &splits_[ancestor->split].node) {
    for (std::uint32_t i = 0; i < ancestor->position; ++i) {
      fixed_in_[alternative(ancestor->split, i).variable] = split_number_;
    }
  }
  const auto begin = alternatives_.size();
  for (const Decision& d : conflict) {
    if (fixed_in_[d.variable] == split_number_) continue;
    const std::span<const PricedValue> choices = choices_[d.variable];
    const std::uint32_t present = rank_[d.variable];
    std::uint32_t rank = present + 1;
    while (rank < choices.size() && excluded({d.variable, choices[rank].value})) ++rank;
    if (rank == choices.size()) continue;
    alternatives_.push_back({d.variable, rank, choices[rank].units - choices[present].units});
  }
  if (alternatives_.size() == begin) return;
  splits_.push_back(
      {node, {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(alternatives_.size() - begin)}, 0});
  push_child(static_cast<std::uint32_t>(splits_.size() - 1), 0);
}

void OptimalSearch::push(Node node) {
  queue_.push_back(node);
  std::push_heap(queue_.begin(), queue_.end(), [this](const Node& a, const Node& b) { return later(a, b); });
}

/// Queues the child at `position` of a split; nothing where there is none.
void OptimalSearch::push_child(std::uint32_t split, std::uint32_t position) {
  if (position >= splits_[split].alternatives.size) return;
  const Alternative& way = alternative(split, position);
  const Split& parent = splits_[split];
  const Slice inherited = parent.node.deviations;
  const auto begin = static_cast<std::uint32_t>(deviations_.size());
  bool placed = false;
  for (std::uint32_t i = 0; i < inherited.size; ++i) {
    const Deviation deviation = deviations_[inherited.begin + i];
    if (!placed && way.variable <= deviation.variable) {
      deviations_.push_back({way.variable, way.rank});
      placed = true;
      if (way.variable == deviation.variable) continue;
    }
    deviations_.push_back(deviation);
  }
  if (!placed) deviations_.push_back({way.variable, way.rank});
  const Slice own{begin, static_cast<std::uint32_t>(deviations_.size()) - begin};
  push({.cost = parent.node.cost + way.delta, .split = split, .position = position, .deviations = own});
}

}  // namespace rmpl::runtime
