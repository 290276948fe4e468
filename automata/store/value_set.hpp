// Which values of a variable a constraint allows, listed or as all but a few.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "automata/logic/formula.hpp"
#include "base/function_ref.hpp"

namespace rmpl::automata {

/// The size of a set is that of what is listed: a set of many values costs little where it is all but a few.
class ValueSet {
 public:
  static ValueSet all() { return {true, {}}; }
  static ValueSet none() { return {false, {}}; }
  /// `values` is sorted, without doubles.
  static ValueSet of(std::vector<ValueId> values) { return {false, std::move(values)}; }

  [[nodiscard]] ValueSet complement() const { return {!excepted_, values_}; }
  [[nodiscard]] ValueSet operator&(const ValueSet& other) const;
  [[nodiscard]] ValueSet operator|(const ValueSet& other) const {
    return (complement() & other.complement()).complement();
  }
  /// How many these are, of a domain of so many values.
  [[nodiscard]] std::size_t size(std::size_t domain) const {
    return excepted_ ? domain - values_.size() : values_.size();
  }
  /// The least one; there is one but in an empty set.
  [[nodiscard]] std::optional<ValueId> first() const;

 private:
  ValueSet(bool excepted, std::vector<ValueId> values) : excepted_(excepted), values_(std::move(values)) {}

  bool excepted_;  ///< all but `values_`
  std::vector<ValueId> values_;
};

/// The values of a variable that make all formulas true; `value_of` tells what the others are. Without clocks and
/// knowledge. Linear in the size of the formulas.
ValueSet values_left(std::span<const Formula> formulas, VariableId variable,
                     base::FunctionRef<ValueId(VariableId)> value_of);

}  // namespace rmpl::automata
