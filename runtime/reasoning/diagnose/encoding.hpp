// A circuit under one observation in clauses, cone by cone.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "automata/logic/sat.hpp"
#include "runtime/reasoning/diagnose/circuit.hpp"
#include "runtime/reasoning/diagnose/sections.hpp"
#include "runtime/reasoning/diagnose/simulate.hpp"

namespace rmpl::runtime {

/// What must hold of undominated gates for some observed nets to be as observed. An observed net is cut: what reads it
/// reads the observed value, and the gate that drives it has to give that. So observed nets share nothing but the
/// gates of their cones, and a net whose cone is left out puts no demand on anything: fewer cones are a relaxation,
/// which often says all that there is to say.
///
/// Constants are folded, so what the inputs decide costs nothing; a dominated gate works and is no more than a part of
/// the functions that read it. A literal is positive if it holds while no gate is faulty (an observed net being cut):
/// the solver, which tries "true" first, leaves alone what no fault has touched.
class Encoding {
 public:
  /// `nominal`: the value of every net where no gate is faulty. `suspects`, per gate: which may be faulty; all where it
  /// is empty. All arguments must outlive this object.
  Encoding(const Circuit& circuit, const Sections& sections, const Known& known, const std::vector<Word>& nominal,
           const std::vector<bool>& suspects);

  /// Adds the cone of an observed net that a gate drives; once.
  void include(NetId observed);
  /// Gates of cones that are added from now on work.
  void no_more_faults() { faults_ = false; }

  automata::Sat sat;
  std::vector<std::size_t> tops;           ///< undominated gates that may be faulty and matter, and beside them:
  std::vector<automata::Literal> healthy;  ///< "this gate works"
  /// The literal that holds where the gate at this place of `tops` gives "true".
  [[nodiscard]] automata::Literal output(std::size_t place) const { return nets_[circuit_.gates[tops[place]].output]; }

 private:
  enum class Operation { none, conjunction, equivalence };

  void add(std::size_t gate);
  void define(automata::Literal works, automata::Literal output);
  void function(const CircuitGate& gate);
  void conjunction(std::size_t from);
  void equivalence();
  void negate();
  automata::Literal settle();
  void clause(std::span<const automata::Literal> literals);
  void clause(std::initializer_list<automata::Literal> literals) {
    clause(std::span<const automata::Literal>(literals.begin(), literals.size()));
  }
  automata::Literal fresh(bool nominally) { return nominally ? sat.fresh() : -sat.fresh(); }

  const Circuit& circuit_;
  const Sections& sections_;
  const Known& known_;
  const std::vector<Word>& nominal_;
  const std::vector<bool>& suspects_;
  automata::Literal true_;
  bool faults_ = true;
  std::vector<automata::Literal> nets_;  ///< per net; 0 where not yet added
  std::vector<std::uint8_t> added_;      ///< per gate
  std::vector<std::size_t> cone_;        ///< while a cone is added
  // While a function is added: values; where the last operation has no literal yet it stands on top as 0.
  std::vector<automata::Literal> stack_;
  Operation operation_ = Operation::none;
  bool negated_ = false;
  std::vector<automata::Literal> operands_;
  std::vector<automata::Literal> closing_;  ///< a clause
  std::vector<automata::Literal> folded_;   ///< likewise
};

}  // namespace rmpl::runtime
