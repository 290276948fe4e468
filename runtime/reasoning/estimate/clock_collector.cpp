// Equal clocks become one.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/clock_collector.hpp"

#include <cstring>
#include <type_traits>

#include "base/hash.hpp"

namespace rmpl::runtime {

using automata::Ticks;

namespace {

/// Among so few each is looked at.
constexpr std::size_t few_clocks = 4;

/// As `==`, in one pass over the bytes: there is a time for each component of a plant.
bool same(const std::vector<Ticks>& a, const std::vector<Ticks>& b) {
  static_assert(std::has_unique_object_representations_v<Ticks>);
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Ticks)) == 0;
}

}  // namespace

void ClockCollector::begin(std::vector<Clocked>& clocks, const std::vector<std::size_t>& telling) {
  clocks_ = &clocks;
  telling_ = &telling;
  size_ = indexed_ = 0;
}

std::vector<Ticks>& ClockCollector::draft(const std::vector<Ticks>& starts) {
  if (size_ == clocks_->size()) clocks_->emplace_back();
  std::vector<Ticks>& result = (*clocks_)[size_].starts;
  result = starts;
  return result;
}

void ClockCollector::add(std::size_t among, double probability) {
  const std::size_t same = find(among);
  if (same < among) {
    (*clocks_)[same].probability += probability;
  } else {
    (*clocks_)[size_++].probability = probability;
  }
}

/// The draft among the first ones; else how many these are.
std::size_t ClockCollector::find(std::size_t among) {
  const std::vector<Ticks>& starts = (*clocks_)[size_].starts;
  if (among <= few_clocks) {
    std::size_t i = 0;
    while (i < among && !same((*clocks_)[i].starts, starts)) ++i;
    return i;
  }
  index(among);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t slot = hash_of(starts) & mask; slots_[slot] != 0; slot = (slot + 1) & mask) {
    if (same((*clocks_)[slots_[slot] - 1].starts, starts)) return slots_[slot] - 1;
  }
  return among;
}

std::size_t ClockCollector::hash_of(const std::vector<Ticks>& starts) const {
  std::uint64_t hash = base::hash_seed;
  for (const std::size_t c : *telling_) hash = base::mix(hash, static_cast<std::uint64_t>(starts[c].count));
  return static_cast<std::size_t>(hash);
}

void ClockCollector::index(std::size_t up_to) {
  if (indexed_ == 0 || 2 * up_to > slots_.size()) {
    std::size_t slots = 4 * few_clocks;
    while (slots < 4 * up_to) slots *= 2;
    slots_.assign(slots, 0);
    indexed_ = 0;
  }
  const std::size_t mask = slots_.size() - 1;
  for (; indexed_ < up_to; ++indexed_) {
    std::size_t slot = hash_of((*clocks_)[indexed_].starts) & mask;
    while (slots_[slot] != 0) slot = (slot + 1) & mask;
    slots_[slot] = static_cast<std::uint32_t>(indexed_ + 1);
  }
}

}  // namespace rmpl::runtime
