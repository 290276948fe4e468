// All minimum-cardinality diagnoses, once their number of faults is known.
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "runtime/diagnose/encoding.hpp"
#include "runtime/diagnose/expand.hpp"

namespace runtime {

/// Enumerates the models of an encoding that holds the cones of all observed nets and admits diagnoses of minimum
/// cardinality alone.
///
/// First the gates are found that are faulty in any of them. Where these fall into parts that reach no observed net in
/// common, each part has to explain its own nets, with its own least number of faults: the diagnoses are the product of
/// the parts', and only the parts are enumerated.
class Enumeration {
 public:
  using Report = std::function<void(const FaultSet&)>;
  /// All must outlive this object.
  Enumeration(const Circuit& circuit, Encoding& encoding, Expansion& expansion)
      : circuit_(circuit), encoding_(encoding), expansion_(expansion) {}

  /// The number of diagnoses; `report`, where it is one, is called with each, once. The expansion must list them then.
  boost::multiprecision::cpp_int run(const Report& report);

 private:
  using Places = std::vector<std::size_t>;

  void take_model();
  void find_possible();
  std::vector<Places> parts() const;
  boost::multiprecision::cpp_int enumerate(const Places& part, std::vector<FaultSet>* sets);
  std::vector<Expansion::Witness> witnesses(std::span<const std::size_t> group);

  const Circuit& circuit_;
  Encoding& encoding_;
  Expansion& expansion_;
  Places faulty_;               ///< places of the gates that are faulty in the last model
  std::vector<bool> possible_;  ///< per place: faulty in some model
};

}  // namespace runtime
