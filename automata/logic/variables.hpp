// The table of finite-domain variables that formulas speak of.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "automata/logic/ids.hpp"

namespace rmpl::automata {

/// A variable with a finite domain. Two variables are comparable when their `values` are the same list.
struct Variable {
  std::string name;                 ///< full name, as in `prop.engine.temp`
  std::vector<std::string> values;  ///< the domain, in declaration order
  bool operator==(const Variable&) const = default;

  [[nodiscard]] std::optional<ValueId> find(std::string_view value) const;
};

/// `variable = value`, the papers' proposition.
struct Assignment {
  VariableId variable;
  ValueId value;
  auto operator<=>(const Assignment&) const = default;
};

/// Variables by position and by name. Names are unique.
class Variables {
 public:
  /// Adds a variable and returns its position. The name must be new.
  VariableId add(Variable variable);
  /// The position of `value` in the domain of `id`, appended where it is new (for tables built from what is mentioned).
  ValueId add_value(VariableId id, const std::string& value);

  [[nodiscard]] std::optional<VariableId> find(std::string_view name) const;
  [[nodiscard]] const Variable& operator[](VariableId id) const { return table_[id.index()]; }
  [[nodiscard]] std::size_t size() const { return table_.size(); }
  [[nodiscard]] auto begin() const { return table_.begin(); }
  [[nodiscard]] auto end() const { return table_.end(); }
  [[nodiscard]] const std::string& name(VariableId id) const { return table_[id.index()].name; }
  [[nodiscard]] const std::string& value(Assignment a) const {
    return table_[a.variable.index()].values[a.value.index()];
  }
  bool operator==(const Variables& other) const { return table_ == other.table_; }

 private:
  std::vector<Variable> table_;
  /// Looks names up without a copy.
  struct NameHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const noexcept { return std::hash<std::string_view>{}(name); }
  };
  std::unordered_map<std::string, VariableId, NameHash, std::equal_to<>> by_name_;
};

}  // namespace rmpl::automata
