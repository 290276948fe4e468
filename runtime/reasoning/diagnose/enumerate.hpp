// All minimum-cardinality diagnoses, once their number of faults is known.
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "runtime/reasoning/diagnose/encoding.hpp"
#include "runtime/reasoning/diagnose/reach.hpp"
#include "runtime/reasoning/diagnose/sections.hpp"
#include "runtime/reasoning/diagnose/simulate.hpp"

namespace rmpl::runtime {

/// Faulty components, ascending.
using FaultSet = std::vector<automata::ComponentId>;

/// Enumerates the diagnoses of minimum cardinality.
///
/// First the undominated gates are found that are faulty in any of them, and the nets whose value is the same in all:
/// these may as well be observed, and be cut. Where the gates then fall into parts that reach no such net in common,
/// each part has to explain its own nets, with its own least number of faults: the diagnoses are the product of the
/// parts'. A part is encoded anew with its gates as the only suspects, which leaves little of the circuit, and its
/// top-level diagnoses are enumerated.
class Enumeration {
 public:
  using Report = std::function<void(const FaultSet&)>;

  /// With `list`, diagnoses are reported, not only counted. The circuit and its sections must outlive this object.
  Enumeration(const Circuit& circuit, const Sections& sections, Known known, bool list)
      : circuit_(circuit), sections_(sections), known_(std::move(known)), list_(list) {}

  /// `encoding` holds the cones of all observed nets and admits diagnoses of minimum cardinality alone. The number of
  /// diagnoses; `report` is called with each, once, where they are listed.
  boost::multiprecision::cpp_int run(Encoding& encoding, const Report& report);
  /// Asked of the solvers of the parts.
  [[nodiscard]] std::size_t questions() const { return questions_; }

 private:
  using Gates = std::vector<std::size_t>;

  Gates possible_gates(Encoding& encoding);
  boost::multiprecision::cpp_int enumerate(const Reach& reach, const std::vector<Word>& nominal, const Gates& part,
                                           std::vector<FaultSet>& sets);
  void keep(const std::vector<Gates>& choices, std::vector<FaultSet>& sets) const;

  const Circuit& circuit_;
  const Sections& sections_;
  Known known_;  ///< also what follows from the observation and the number of faults
  bool list_;
  std::size_t questions_ = 0;
};

}  // namespace rmpl::runtime
