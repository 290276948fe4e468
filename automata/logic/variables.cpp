// The table of finite-domain variables.
// SPDX-License-Identifier: MIT
#include "automata/logic/variables.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::automata {

std::optional<ValueId> Variable::find(std::string_view value) const {
  const auto at = std::find(values.begin(), values.end(), value);
  if (at == values.end()) return std::nullopt;
  return ValueId(static_cast<std::size_t>(at - values.begin()));
}

VariableId Variables::add(Variable variable) {
  const VariableId id(table_.size());
  const bool fresh = by_name_.emplace(variable.name, id).second;
  CHECK(fresh && "a variable's name is new");
  (void)fresh;
  table_.push_back(std::move(variable));
  return id;
}

ValueId Variables::add_value(VariableId id, const std::string& value) {
  Variable& variable = table_[id.index()];
  if (const auto known = variable.find(value)) return *known;
  variable.values.push_back(value);
  return ValueId(variable.values.size() - 1);
}

std::optional<VariableId> Variables::find(std::string_view name) const {
  const auto at = by_name_.find(name);
  if (at == by_name_.end()) return std::nullopt;
  return at->second;
}

}  // namespace rmpl::automata
