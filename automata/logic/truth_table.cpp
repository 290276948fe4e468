// A decision diagram, written out: a column at a time, values that lead to the same joined.
// SPDX-License-Identifier: MIT
#include "automata/logic/truth_table.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>

namespace rmpl::automata {

namespace {

/// Of more rows than this the first column with two branches will do.
constexpr std::size_t many_rows = 2000;

/// What is left once some columns are decided.
using Rows = std::map<std::vector<ValueId>, bool>;

/// Values of one column that lead to the same.
struct Branch {
  std::vector<ValueId> values;
  Rows rest;
};

/// Adds the rows of another; false, and then nothing is changed, where both tell a row and differ.
bool join(Rows& into, const Rows& other) {
  for (const auto& [values, holds] : other) {
    const auto known = into.find(values);
    if (known != into.end() && known->second != holds) return false;
  }
  into.insert(other.begin(), other.end());
  return true;
}

std::vector<Branch> split(const Rows& rows, std::size_t column) {
  std::map<ValueId, Rows> by_value;
  for (const auto& [values, holds] : rows) {
    std::vector<ValueId> rest = values;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(column));
    by_value[values[column]].emplace(std::move(rest), holds);
  }
  std::vector<Branch> branches;
  for (auto& entry : by_value) {
    Rows& rest = entry.second;
    const auto same = std::find_if(branches.begin(), branches.end(), [&](Branch& one) { return join(one.rest, rest); });
    if (same != branches.end()) {
      same->values.push_back(entry.first);
    } else {
      branches.push_back({{entry.first}, std::move(rest)});
    }
  }
  return branches;
}

Formula formula_of(const Rows& rows, std::vector<VariableId> columns) {
  const auto all = [&](bool wanted) {
    return std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return row.second == wanted; });
  };
  if (all(true)) return constant(true);
  if (all(false)) return constant(false);
  std::size_t chosen = 0;
  std::vector<Branch> branches;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    std::vector<Branch> these = split(rows, c);
    if (!branches.empty() && these.size() >= branches.size()) continue;
    chosen = c;
    branches = std::move(these);
    if (branches.size() == 1 || (branches.size() == 2 && rows.size() > many_rows)) break;
  }
  const VariableId column = columns[chosen];
  columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(chosen));
  if (branches.size() == 1) return formula_of(branches.front().rest, std::move(columns));
  std::vector<Formula> cases;
  for (const Branch& branch : branches) {
    Formula rest = formula_of(branch.rest, columns);
    if (rest == constant(false)) continue;
    Formula test = member(column, branch.values);
    cases.push_back(rest.is_true() ? std::move(test) : conjunction({std::move(test), std::move(rest)}));
  }
  return disjunction(std::move(cases));
}

}  // namespace

Formula TruthTable::formula() const { return formula_of(Rows(rows_.begin(), rows_.end()), columns_); }

}  // namespace rmpl::automata
