// All minimum-cardinality diagnoses, once their number of faults is known.
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "runtime/diagnose/encoding.hpp"
#include "runtime/diagnose/reach.hpp"
#include "runtime/diagnose/sections.hpp"
#include "runtime/diagnose/simulate.hpp"

namespace runtime {

/// Faulty components, ascending.
using FaultSet = std::vector<automata::ComponentId>;

/// Enumerates the diagnoses of minimum cardinality.
///
/// First the undominated gates are found that are faulty in any of them. Where these fall into parts that reach no
/// observed net in common, each part has to explain its own nets, with its own least number of faults: the diagnoses
/// are the product of the parts'. A part is encoded anew with its gates as the only suspects, which leaves little of
/// the circuit, and its top-level diagnoses are enumerated.
class Enumeration {
 public:
  /// A circuit under an observation; `nominal` are its values without faults.
  struct Subject {
    const Circuit& circuit;
    const Sections& sections;
    const Known& known;
    const std::vector<Word>& nominal;
  };
  using Report = std::function<void(const FaultSet&)>;

  /// With `list`, diagnoses are reported, not only counted. What `subject` refers to must outlive this object.
  Enumeration(const Subject& subject, bool list)
      : subject_(subject), list_(list), reach_(subject.circuit, subject.known) {}

  /// `encoding` holds the cones of all observed nets and admits diagnoses of minimum cardinality alone. The number of
  /// diagnoses; `report` is called with each, once, where they are listed.
  boost::multiprecision::cpp_int run(Encoding& encoding, const Report& report);
  /// Asked of the solvers of the parts.
  [[nodiscard]] std::size_t questions() const { return questions_; }

 private:
  using Gates = std::vector<std::size_t>;

  boost::multiprecision::cpp_int enumerate(const Gates& part, std::vector<FaultSet>& sets);
  void keep(const std::vector<Gates>& choices, std::vector<FaultSet>& sets) const;

  Subject subject_;
  bool list_;
  Reach reach_;
  std::size_t questions_ = 0;
};

}  // namespace runtime
