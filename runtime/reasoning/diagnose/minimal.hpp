// The complete set of minimum-cardinality diagnoses of a circuit, found, counted or listed.
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "automata/logic/variables.hpp"
#include "runtime/reasoning/diagnose/circuit.hpp"
#include "runtime/reasoning/diagnose/enumerate.hpp"
#include "runtime/reasoning/diagnose/sections.hpp"

namespace rmpl::runtime {

struct MinimalDiagnoses {
  std::size_t cardinality = 0;
  boost::multiprecision::cpp_int count = 0;  ///< exact; 1 where only the first was asked for
  std::size_t checked = 0;                   ///< questions to the solver
};

/// Diagnoses snapshots of one circuit. Dominators are computed for the observed nets and kept while these stay the
/// same.
class CircuitDiagnosis {
 public:
  explicit CircuitDiagnosis(const Circuit& circuit) : circuit_(circuit) {}

  enum class Scope { first, count, list };
  /// Explains `observation`. With `list`, `report` is called with every diagnosis, each once, in an order that the
  /// observation determines; with `first`, with one of them. Nothing where an input is unobserved (then the values of
  /// the nets are not determined by the faulty gates) or where no set of faults explains the observation.
  std::optional<MinimalDiagnoses> solve(std::span<const automata::Assignment> observation, Scope scope,
                                        const std::function<void(const FaultSet&)>& report);

 private:
  void prepare(const std::vector<bool>& observed);

  const Circuit& circuit_;
  std::vector<bool> observed_;
  Sections sections_;
};

}  // namespace rmpl::runtime
