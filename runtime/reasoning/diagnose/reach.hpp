// What a faulty gate can be seen by.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "runtime/reasoning/diagnose/circuit.hpp"
#include "runtime/reasoning/diagnose/simulate.hpp"

namespace rmpl::runtime {

/// For each gate of a circuit the observed nets that it reaches, an observed net being cut.
class Reach {
 public:
  /// `circuit` must outlive this object.
  Reach(const Circuit& circuit, const Known& known);

  /// Gates that reach an observed net in common, directly or by way of others; each group ascending.
  [[nodiscard]] std::vector<std::vector<std::size_t>> groups(std::span<const std::size_t> gates) const;
  /// The observed nets that some of these gates reach.
  [[nodiscard]] std::vector<NetId> observed(std::span<const std::size_t> gates) const;
  /// These gates and all whose inputs depend on them, ascending.
  [[nodiscard]] std::vector<std::size_t> cone(std::span<const std::size_t> gates) const;

 private:
  using Mask = std::vector<Word>;  ///< a set of observed nets

  const Circuit& circuit_;
  std::vector<NetId> observed_;                    ///< those that a gate drives
  std::vector<Mask> masks_;                        ///< per gate
  std::vector<std::vector<std::size_t>> readers_;  ///< per net; of an observed net none
};

}  // namespace rmpl::runtime
