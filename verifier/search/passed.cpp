// The states that a search has found, packed.
// SPDX-License-Identifier: MIT
#include "verifier/search/passed.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "base/check.hpp"
#include "verifier/zone/covering.hpp"
#include "verifier/zone/union.hpp"

namespace rmpl::verifier {
namespace {

/// A node grows by what is among so many others, cut into so many pieces.
constexpr std::size_t most_parts = 32;
constexpr std::size_t most_pieces = 256;
/// Longer lists are put into a forest.
constexpr std::size_t most_in_list = 64;

template <class Entry>
bool fits(std::span<const Units> matrix) {
  constexpr Units no_bound = std::numeric_limits<Entry>::max();
  return std::all_of(matrix.begin(), matrix.end(),
                     [](Units bound) { return bound == unbounded || (-no_bound < bound && bound < no_bound); });
}

}  // namespace

template <class Entry>
std::uint64_t Passed::Arena<Entry>::add(std::span<const Units> matrix) {
  CHECK(matrix.size() <= chunk);
  if (used_ + matrix.size() > chunk) {
    chunks_.push_back(std::make_unique_for_overwrite<Entry[]>(chunk));
    used_ = 0;
  }
  Entry* to = &chunks_.back()[used_];
  for (const Units bound : matrix) {
    *to++ = bound == unbounded ? std::numeric_limits<Entry>::max() : static_cast<Entry>(bound);
  }
  const std::uint64_t position = (chunks_.size() - 1) * chunk + used_;
  used_ += matrix.size();
  return position;
}

Passed::Passed(TransitionSystem& system, bool steps_counted)
    : system_(system), steps_counted_(steps_counted), slots_(1024, none) {}

std::pair<std::uint64_t, Passed::Width> Passed::add(std::span<const Units> matrix) {
  if (fits<std::int16_t>(matrix)) return {twos_.add(matrix), Width::two};
  if (fits<std::int32_t>(matrix)) return {fours_.add(matrix), Width::four};
  return {eights_.add(matrix), Width::eight};
}

template <class Use>
auto Passed::with_matrix(const Node& node, const Use& use) const {
  switch (node.width) {
    case Width::two:
      return use(twos_.at(node.zone));
    case Width::four:
      return use(fours_.at(node.zone));
    case Width::eight:
      break;
  }
  return use(eights_.at(node.zone));
}

SymbolicState Passed::state(std::uint32_t number) const {
  const Node& node = nodes_[number];
  std::vector<Units> matrix(std::size_t{node.dimension} * node.dimension);
  with_matrix(node, [&]<class Entry>(const Entry* entries) {
    std::transform(entries, entries + matrix.size(), matrix.begin(),
                   [](Entry bound) { return bound == std::numeric_limits<Entry>::max() ? unbounded : Units{bound}; });
  });
  return {node.discrete, node.faults, Zone::of_matrix(std::move(matrix), node.dimension - 1u)};
}

bool Passed::covered_by(const Node& node, const SymbolicState& state, std::uint32_t steps) const {
  if ((steps_counted_ && node.steps > steps) || !system_.no_more_faults(node.faults, state.faults)) return false;
  return with_matrix(node, [&](const auto* matrix) {
    const Units* own = state.zone.matrix().data();
    return limits_.empty() ? verifier::includes(matrix, own, node.dimension)
                           : verifier::covers(matrix, own, node.dimension, limits_);
  });
}

bool Passed::covers(const SymbolicState& state, const Node& node) const {
  if (!system_.no_more_faults(state.faults, node.faults)) return false;
  return with_matrix(node, [&](const auto* matrix) {
    const Units* own = state.zone.matrix().data();
    return limits_.empty() ? verifier::includes(own, matrix, node.dimension)
                           : verifier::covers(own, matrix, node.dimension, limits_);
  });
}

std::uint32_t& Passed::first(std::uint64_t discrete) {
  const auto slot_of = [this](std::uint64_t key) {
    std::uint64_t hash = key * 0x9e3779b97f4a7c15u;
    std::size_t slot = (hash ^ hash >> 32) & (slots_.size() - 1);
    while (slots_[slot] != none && nodes_[slots_[slot]].discrete != key) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  };
  if (2 * discretes_ >= slots_.size()) {
    const std::vector<std::uint32_t> old = std::move(slots_);
    slots_.assign(old.size() * 2, none);
    for (const std::uint32_t node : old) {
      if (node != none) slots_[slot_of(nodes_[node].discrete)] = node;
    }
  }
  return slots_[slot_of(discrete)];
}

std::size_t Passed::mark_covered(std::uint32_t head, const SymbolicState& state) {
  std::size_t length = 0;
  std::uint32_t* link = nullptr;
  for (std::uint32_t n = head; n != none; n = nodes_[n].next, ++length) {
    if (!nodes_[n].covered && covers(state, nodes_[n])) nodes_[n].covered = true;
    if (nodes_[n].covered && n != head) {
      *link = nodes_[n].next;
    } else {
      link = &nodes_[n].next;
    }
  }
  return length;
}

bool Passed::row_of(std::uint32_t number, std::span<Units> row) const {
  const Node& node = nodes_[number];
  if (node.covered) return false;
  const std::size_t entries = std::size_t{node.dimension} * node.dimension;
  with_matrix(node, [&]<class Entry>(const Entry* matrix) {
    std::transform(matrix, matrix + entries, row.begin(),
                   [](Entry bound) { return bound == std::numeric_limits<Entry>::max() ? unbounded : Units{bound}; });
  });
  const auto measures = system_.fault_measures(node.faults);
  std::copy(measures.begin(), measures.end(), row.begin() + static_cast<std::ptrdiff_t>(entries));
  row.back() = steps_counted_ ? -Units{node.steps} : 0;
  return true;
}

void Passed::index(std::uint64_t discrete, std::uint32_t head) {
  const std::size_t entries = std::size_t{nodes_[head].dimension} * nodes_[head].dimension;
  BoundingForest& forest =
      forests_.try_emplace(discrete, entries + std::tuple_size_v<TransitionSystem::FaultMeasures> + 1).first->second;
  for (std::uint32_t n = head; n != none; n = nodes_[n].next) {
    forest.add(n, [this](std::uint32_t node, std::span<Units> row) { return row_of(node, row); });
  }
  nodes_[head].indexed = true;
}

bool Passed::forest_covers(const BoundingForest& forest, const SymbolicState& state, std::uint32_t steps) const {
  const std::size_t n = state.zone.clocks() + 1;
  const auto measures = system_.fault_measures(state.faults);
  const Units* own = state.zone.matrix().data();
  const auto may = [&](const Units* greatest) {
    const Units* rest = greatest + n * n;
    if (!std::equal(measures.begin(), measures.end(), rest, std::less_equal<>())) return false;
    if (steps_counted_ && rest[measures.size()] < -Units{steps}) return false;
    return limits_.empty() ? verifier::includes(greatest, own, n) : verifier::covers(greatest, own, n, limits_);
  };
  return forest.above(
      may, [&](std::uint32_t node) { return !nodes_[node].covered && covered_by(nodes_[node], state, steps); });
}

void Passed::mark_covered(const BoundingForest& forest, const SymbolicState& state) {
  const std::size_t n = state.zone.clocks() + 1;
  const auto measures = system_.fault_measures(state.faults);
  const Units* own = state.zone.matrix().data();
  const auto may = [&](const Units* least) {
    if (!std::equal(measures.begin(), measures.end(), least + n * n, std::greater_equal<>())) return false;
    return limits_.empty() ? verifier::includes(own, least, n) : verifier::covers(own, least, n, limits_);
  };
  forest.below(may, [&](std::uint32_t node) {
    if (!nodes_[node].covered && covers(state, nodes_[node])) nodes_[node].covered = true;
    return false;
  });
}

std::uint32_t Passed::add(const SymbolicState& state, const Label& label, std::uint32_t parent, std::uint32_t steps) {
  system_.limits(state.discrete, limits_);
  std::uint32_t& head = first(state.discrete);
  BoundingForest* const forest =
      head != none && nodes_[head].indexed ? &forests_.find(state.discrete)->second : nullptr;
  std::size_t length = 0;
  if (forest != nullptr) {
    if (forest_covers(*forest, state, steps)) return none;
    mark_covered(*forest, state);
  } else {
    for (std::uint32_t n = head; n != none; n = nodes_[n].next) {
      if (!nodes_[n].covered && covered_by(nodes_[n], state, steps)) return none;
    }
    length = mark_covered(head, state);
  }
  CHECK(nodes_.size() < none && "more states than there are numbers");
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  const auto [zone, width] = add(state.zone.matrix());
  const auto dimension = static_cast<std::uint16_t>(state.zone.clocks() + 1);
  Node node{state.discrete, zone, label, parent, steps, state.faults, none, dimension, width};
  if (head == none) {
    ++discretes_;
    head = number;
  } else {
    // Second in the list: the last one found covers most of what follows.
    node.next = nodes_[head].next;
    nodes_[head].next = number;
  }
  nodes_.push_back(node);
  if (forest != nullptr) {
    forest->add(number, [this](std::uint32_t one, std::span<Units> row) { return row_of(one, row); });
  } else if (length >= most_in_list) {
    index(state.discrete, head);
  }
  return number;
}

std::uint32_t Passed::grown(std::uint32_t number) {
  const auto may_join = [](const Node& other, const Node& grows) {
    return !other.explored && other.faults == grows.faults;
  };
  nodes_[number].explored = true;
  const Node node = nodes_[number];
  std::vector<std::uint32_t> others;
  bool some_wait = false;
  const std::uint32_t head = first(node.discrete);
  std::uint32_t* link = nullptr;
  for (std::uint32_t n = head; n != none && others.size() < most_parts; n = nodes_[n].next) {
    if (nodes_[n].covered && n != head) {
      *link = nodes_[n].next;
      continue;
    }
    link = &nodes_[n].next;
    if (nodes_[n].covered || n == number || !system_.no_more_faults(nodes_[n].faults, node.faults)) continue;
    others.push_back(n);
    some_wait = some_wait || may_join(nodes_[n], node);
  }
  if (!some_wait) return number;
  SymbolicState result = state(number);
  std::vector<Zone> parts = {result.zone};
  for (const std::uint32_t n : others) parts.push_back(state(n).zone);
  bool grows = false;
  for (std::size_t other = 1; other < parts.size(); ++other) {
    if (!may_join(nodes_[others[other - 1]], node) || result.zone.includes(parts[other])) continue;
    Zone both = hull(result.zone, parts[other]);
    // The two come first: they leave the fewest pieces for the others.
    std::swap(parts[1], parts[other]);
    const bool whole = within_union(both, parts, most_pieces);
    std::swap(parts[1], parts[other]);
    if (!whole) continue;
    result.zone = std::move(both);
    parts[0] = result.zone;
    grows = true;
  }
  if (!grows) return number;
  nodes_[number].covered = true;
  const std::uint32_t merged = add(result, node.label, node.parent, node.steps);
  if (merged == none) return none;
  nodes_[merged].explored = true;
  nodes_[merged].merged = true;
  return merged;
}

Corridor Passed::corridor(std::uint32_t node) const {
  std::map<std::uint64_t, std::vector<std::uint32_t>> alike;
  for (std::uint32_t n = 0; n <= node; ++n) alike[nodes_[n].discrete].push_back(n);
  Corridor result;
  std::vector<bool> seen(node + std::size_t{1}, false);
  std::vector<std::uint32_t> open = {node};
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    if (seen[n]) continue;
    seen[n] = true;
    const std::uint32_t parent = nodes_[n].parent;
    result.emplace(parent == none ? before_all : nodes_[parent].discrete, nodes_[n].discrete);
    if (parent != none) open.push_back(parent);
    if (!nodes_[n].merged) continue;
    for (const std::uint32_t part : alike[nodes_[n].discrete]) {
      if (part < n) open.push_back(part);
    }
  }
  return result;
}

std::vector<PathState> Passed::path(std::uint32_t node) const {
  std::vector<PathState> result;
  for (; node != none; node = nodes_[node].parent) result.push_back({nodes_[node].discrete, nodes_[node].label});
  std::reverse(result.begin(), result.end());
  return result;
}

}  // namespace rmpl::verifier
