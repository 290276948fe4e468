// Modes of all components, packed and numbered.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/state.hpp"
#include "automata/store/support.hpp"

namespace rmpl::verifier {

/// A table of mode vectors without doubles: a few bits a component in one array, found by open addressing.
class ModesTable {
 public:
  explicit ModesTable(const automata::Plant& plant);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// The position of the modes, added at the end where they are new.
  std::uint32_t intern(const automata::Modes& modes);
  void read(std::uint32_t position, automata::Modes& modes) const;

 private:
  struct Field {
    std::uint32_t word;
    std::uint32_t shift;
    std::uint64_t mask;
  };
  /// Writes the modes behind the last row; where they are in the table, or belong.
  std::size_t write(const automata::Modes& modes);
  [[nodiscard]] std::size_t slot_of(const std::uint64_t* words) const;
  void grow();

  static constexpr std::uint32_t empty = UINT32_MAX;
  std::vector<Field> fields_;  ///< by component
  std::size_t width_ = 1;      ///< words a row
  std::size_t size_ = 0;
  std::vector<std::uint64_t> words_;  ///< row by row
  std::vector<std::uint32_t> slots_;  ///< positions, a power of two of them
};

}  // namespace rmpl::verifier
