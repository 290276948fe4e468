// The clocks of one mode combination, put together from the ways that lead there.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/reasoning/estimate/combination.hpp"

namespace rmpl::runtime {

/// Equal clocks become one. They are written into the memory that the list has, so that one that is filled again and
/// again allocates nothing.
class ClockCollector {
 public:
  /// Begins a list anew; it is not to be used until `end`. `telling` are the components whose clocks mostly tell sets
  /// apart: those that matter.
  void begin(std::vector<Clocked>& clocks, const std::vector<std::size_t>& telling);
  void end() { clocks_->resize(size_); }
  /// How many there are.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// A copy of these, which may be altered until `add`.
  [[nodiscard]] std::vector<automata::Ticks>& draft(const std::vector<automata::Ticks>& starts);
  /// Adds the draft, to the same one among the first `among` if that is there. They are never fewer than the last time.
  void add(std::size_t among, double probability);

 private:
  [[nodiscard]] std::size_t find(std::size_t among);
  void index(std::size_t up_to);
  [[nodiscard]] std::size_t hash_of(const std::vector<automata::Ticks>& starts) const;

  std::vector<Clocked>* clocks_ = nullptr;
  const std::vector<std::size_t>* telling_ = nullptr;
  std::size_t size_ = 0;
  std::vector<std::uint32_t> slots_;  ///< open addressing: position + 1, or 0; size a power of two
  std::size_t indexed_ = 0;           ///< so many are in it
};

}  // namespace rmpl::runtime
