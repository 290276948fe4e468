// The one way of remembering answers: bounded, counted, and switched off as a whole in tests.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "base/hash.hpp"

namespace rmpl::base {

/// Whether caches remember. What is found must not depend on it: property tests run with and without.
inline std::atomic<bool> caches_remember = true;

[[nodiscard]] inline bool caches_on() noexcept { return caches_remember.load(std::memory_order_relaxed); }

/// As long as it lives no cache of the process remembers more than its last entry. For tests; not to be nested.
class WithoutCaches {
 public:
  WithoutCaches() noexcept { caches_remember = false; }
  ~WithoutCaches() { caches_remember = true; }
  WithoutCaches(const WithoutCaches&) = delete;
  WithoutCaches& operator=(const WithoutCaches&) = delete;
};

struct CacheCounts {
  std::uint64_t hits = 0, misses = 0, evictions = 0;
};

/// A hash map of answers that forgets: past its limit it begins anew, so that long runs through ever new keys stay
/// flat, and lets go of the old entries two at a time, so that no single step pays for it. Holds at most twice `limit`
/// entries, of which the older half is no longer found.
template <class Key, class Value, class Hash = WordsHash>
class BoundedCache {
 public:
  explicit BoundedCache(std::size_t limit) : limit_(limit > 0 ? limit : 1) {}

  /// The value of a key, or null. Lasts until the next `add`.
  [[nodiscard]] Value* find(const Key& key) {
    const auto known = caches_on() ? known_.find(key) : known_.end();
    if (known == known_.end()) {
      ++counts_.misses;
      return nullptr;
    }
    ++counts_.hits;
    return &known->second;
  }

  /// Remembers the value of a key that `find` did not find just now. The reference lasts until the next `add`.
  Value& add(Key key, Value value) {
    if (known_.size() >= limit_ || !caches_on()) begin_anew();
    for (int i = 0; i < 2 && !retired_.empty(); ++i) retired_.erase(retired_.begin());
    return known_.insert_or_assign(std::move(key), std::move(value)).first->second;
  }

  /// The remembered value, or `ask()`, which is then remembered. `ask` may use the cache.
  template <class Ask>
  Value& find_or(const Key& key, const Ask& ask) {
    if (Value* known = find(key)) return *known;
    return add(key, ask());
  }

  [[nodiscard]] std::size_t size() const noexcept { return known_.size(); }
  [[nodiscard]] const CacheCounts& counts() const noexcept { return counts_; }

 private:
  void begin_anew() {
    counts_.evictions += known_.size();
    retired_.clear();  // empty already, but where entries came slower than they went: the limit is one or two
    std::swap(known_, retired_);
  }

  std::size_t limit_;
  std::unordered_map<Key, Value, Hash> known_;    ///< looked up, never iterated
  std::unordered_map<Key, Value, Hash> retired_;  ///< shrinks by two with each entry that comes
  CacheCounts counts_;
};

}  // namespace rmpl::base
