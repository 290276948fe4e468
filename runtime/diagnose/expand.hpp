// From one top-level diagnosis to all diagnoses with the same sections.
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "runtime/diagnose/circuit.hpp"
#include "runtime/diagnose/sections.hpp"
#include "runtime/diagnose/simulate.hpp"

namespace runtime {

/// Faulty components, ascending.
using FaultSet = std::vector<automata::ComponentId>;

/// Expands the undominated gates of a top-level diagnosis into their sections. Let the outputs of the gates
/// d1 … dk be fixed to a vector v; all other nets follow. v is a witness if every observed net then has its value. A
/// choice of one gate out of each section is a diagnosis if for some witness v each chosen gate, flipped, gives its
/// section's output the value in v.
///
/// Gates that reach no observed net in common know nothing of each other: a diagnosis falls apart into groups, and its
/// choices are the product of theirs. Top-level diagnoses differ in few gates, so most of their groups were met before,
/// and are remembered.
class Expansion {
 public:
  /// Values for the gates of a group, one bit a gate.
  using Witness = std::vector<bool>;
  /// Gives the witnesses of a group of more than `exhaustive_limit` gates.
  using Ask = std::function<std::vector<Witness>(std::span<const std::size_t> group)>;
  /// Every vector is simulated for at most this many gates.
  static constexpr std::size_t exhaustive_limit = 12;

  /// `nominal`: the value of every net where no gate is faulty. With `list`, expansions keep their diagnoses. All
  /// references must outlive this object.
  Expansion(const Circuit& circuit, const Sections& sections, const Known& known, const std::vector<Word>& nominal,
            bool list);

  /// Gates that reach an observed net in common, directly or by way of others; each group ascending.
  [[nodiscard]] std::vector<std::vector<std::size_t>> groups(std::span<const std::size_t> tops) const;
  /// The observed nets that some of these gates reach.
  [[nodiscard]] std::vector<NetId> observed(std::span<const std::size_t> gates) const;
  /// The number of diagnoses that the undominated gates `tops` stand for; `report` is called with each where they are
  /// listed.
  boost::multiprecision::cpp_int expand(std::span<const std::size_t> tops, const Ask& ask,
                                        const std::function<void(const FaultSet&)>& report);

 private:
  using Gates = std::vector<std::size_t>;
  /// A set of observed nets, or of witnesses.
  using Mask = std::vector<Word>;
  /// The gates of a section that serve the same witnesses.
  struct Choice {
    Mask mask;
    Gates gates;
  };
  struct Group {
    boost::multiprecision::cpp_int count;
    std::vector<Gates> choices;  ///< each a gate out of every section; only where they are listed
  };

  const Group& group(const Gates& tops, const Ask& ask);
  void find_cone(const Gates& tops);
  Word simulate(const Gates& tops, const std::vector<Word>& forced);
  std::vector<Witness> witnesses(const Gates& tops);
  std::vector<std::vector<Choice>> choices(const Gates& tops, const std::vector<Witness>& witnesses);
  Word serves(const Gates& section, std::size_t member, Word forced);
  static void list(const std::vector<std::vector<Choice>>& all, const Mask& mask, Gates& chosen, Group& group);

  const Circuit& circuit_;
  const Sections& sections_;
  const Known& known_;
  const std::vector<Word>& nominal_;
  bool list_;
  std::vector<NetId> observed_;                    ///< that a gate drives
  std::vector<Mask> reaches_;                      ///< per gate: observed nets
  std::vector<std::vector<std::size_t>> readers_;  ///< per net; of an observed net none, it is cut
  std::map<Gates, Group> groups_;
  Gates cone_;               ///< what a group reaches, in topological order
  std::vector<Word> words_;  ///< per net: nominal outside the cone
  std::vector<Word> saved_;  ///< of a section, while it is simulated again
  GateEvaluator evaluate_;
};

}  // namespace runtime
