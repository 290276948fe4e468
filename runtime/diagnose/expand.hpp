// From one top-level diagnosis to all diagnoses with the same sections.
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "runtime/diagnose/minimal.hpp"
#include "runtime/diagnose/simulate.hpp"

namespace runtime {

/// Expands the undominated gates of a top-level diagnosis into their sections. Let the outputs of the gates
/// d1 … dk be fixed to a vector v; all other nets follow. v is a witness if every observed net then has its value. A
/// choice of one gate out of each section is a diagnosis if for some witness v each chosen gate, flipped, gives its
/// section's output the value in v.
class Expansion {
 public:
  Expansion(const Circuit& circuit, const Sections& sections, const Known& known);

  /// Simulates every vector v: for at most this many gates.
  static constexpr std::size_t exhaustive_limit = 12;

  /// All witnesses of the gates in `tops`, each as one value per gate. |tops| <= exhaustive_limit.
  std::vector<std::vector<bool>> witnesses(std::span<const std::size_t> tops);
  /// The number of diagnoses that `tops` stands for; `report` is called with each where it is given.
  boost::multiprecision::cpp_int expand(std::span<const std::size_t> tops,
                                        const std::vector<std::vector<bool>>& witnesses,
                                        const std::function<void(const FaultSet&)>& report);

 private:
  /// Which witnesses a gate serves: bit i is the i-th witness.
  using Mask = std::vector<Word>;
  struct Choice {
    Mask mask;
    std::vector<std::size_t> gates;
  };

  void simulate(std::span<const std::size_t> tops, const std::vector<Word>& forced);
  std::vector<std::vector<Choice>> choices(std::span<const std::size_t> tops,
                                           const std::vector<std::vector<bool>>& witnesses);
  void list(const std::vector<std::vector<Choice>>& all, std::size_t position, const Mask& mask, FaultSet& chosen,
            const std::function<void(const FaultSet&)>& report) const;

  const Circuit& circuit_;
  const Sections& sections_;
  const Known& known_;
  std::vector<Word> words_;    ///< per net, of the last simulation
  std::vector<Word> flipped_;  ///< per net, while a section is simulated again
  GateEvaluator evaluate_;
};

}  // namespace runtime
