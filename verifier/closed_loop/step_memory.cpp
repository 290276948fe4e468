// What follows symbolic states of the loop.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/step_memory.hpp"

#include "base/bounded_cache.hpp"
#include "base/hash.hpp"

namespace rmpl::verifier {
namespace {

/// Of an entry or a step beside its zone.
constexpr std::size_t words_beside = 16;

}  // namespace

std::size_t StepMemory::KeyHash::operator()(const Key& key) const noexcept {
  std::uint64_t hash = base::mix(base::mix(base::hash_seed, key.discrete), key.faults);
  for (const Units bound : key.zone) hash = base::mix(hash, static_cast<std::uint64_t>(bound));
  return hash;
}

StepMemory::Entry* StepMemory::find(const SymbolicState& state) {
  if (!base::caches_on()) return nullptr;
  const auto matrix = state.zone.matrix();
  Key key{state.discrete, state.faults, {matrix.begin(), matrix.end()}};
  const auto known = entries_.find(key);
  if (known != entries_.end()) return &known->second;
  if (!room_.is_left()) return nullptr;
  room_.take(matrix.size() + words_beside);
  return &entries_.try_emplace(std::move(key)).first->second;
}

void StepMemory::count(const Step& step) { room_.take(step.state.zone.matrix().size() + words_beside); }

}  // namespace rmpl::verifier
