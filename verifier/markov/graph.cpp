// What the graph of a Markov decision process decides.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>

#include "verifier/markov/decision_process.hpp"
#include "verifier/markov/strong_components.hpp"

namespace rmpl::verifier {

namespace {

using Set = std::vector<bool>;

bool leads_into(const Row& row, const Set& set) {
  return std::any_of(row.edges.begin(), row.edges.end(), [&](const Branch& edge) { return set[edge.to]; });
}
bool stays_in(const Row& row, const Set& set) {
  return row.left_out == 0 &&
         std::all_of(row.edges.begin(), row.edges.end(), [&](const Branch& edge) { return set[edge.to]; });
}

/// Adds states for which `joins` holds until there is none left to add; backward through the numbers first, as states
/// that follow mostly have greater ones.
void grow(Set& set, const std::function<bool(std::size_t)>& joins) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t s = set.size(); s-- > 0;) {
      if (!set[s] && joins(s)) {
        set[s] = true;
        changed = true;
      }
    }
  }
}

}  // namespace

std::vector<bool> may_reach(const DecisionProcess& decisions) {
  Set result = decisions.wanted;
  grow(result, [&](std::size_t s) {
    const auto& rows = decisions.rows[s];
    return std::any_of(rows.begin(), rows.end(),
                       [&](const Row& row) { return row.left_out > 0 || leads_into(row, result); });
  });
  return result;
}

std::vector<bool> may_avoid(const DecisionProcess& decisions) {
  // Those that do not: wanted, or every choice may lead to such a state.
  Set doomed = decisions.wanted;
  grow(doomed, [&](std::size_t s) {
    const auto& rows = decisions.rows[s];
    return !rows.empty() && std::all_of(rows.begin(), rows.end(),
                                        [&](const Row& row) { return row.left_out > 0 || leads_into(row, doomed); });
  });
  doomed.flip();
  return doomed;
}

std::vector<bool> surely_reach(const DecisionProcess& decisions, Aim aim) {
  if (aim == Aim::least) {
    Set fails = may_avoid(decisions);
    grow(fails, [&](std::size_t s) {
      const auto& rows = decisions.rows[s];
      return !decisions.wanted[s] && std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
        return row.left_out > 0 || leads_into(row, fails);
      });
    });
    fails.flip();
    return fails;
  }
  Set within(decisions.size(), true);
  for (;;) {
    Set reached = decisions.wanted;
    grow(reached, [&](std::size_t s) {
      const auto& rows = decisions.rows[s];
      return within[s] && std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
               return stays_in(row, within) && leads_into(row, reached);
             });
    });
    if (reached == within) return within;
    within = std::move(reached);
  }
}

std::vector<std::uint32_t> end_components(const DecisionProcess& decisions, Meter& meter) {
  std::vector<std::uint32_t> part(decisions.size(), 1);
  for (std::size_t s = 0; s < decisions.size(); ++s) {
    if (decisions.wanted[s]) part[s] = 0;
  }
  for (bool changed = true; changed;) {
    meter.poll();
    changed = false;
    const auto stays = [&](std::size_t s, const Row& row) {
      return row.left_out == 0 && !row.edges.empty() &&
             std::all_of(row.edges.begin(), row.edges.end(), [&](const Branch& e) { return part[e.to] == part[s]; });
    };
    const auto sets = strong_components(
        decisions, [&](std::size_t s) { return part[s] != 0; }, stays);
    std::vector<std::uint32_t> next(decisions.size(), 0);
    std::uint32_t count = 0;
    for (const auto& set : sets) {
      ++count;
      for (const StateNumber s : set) {
        const auto& rows = decisions.rows[s];
        if (std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return stays(s, row); })) next[s] = count;
      }
    }
    // A state without a choice that stays goes, and with it the choices that led there.
    for (std::size_t s = 0; s < next.size(); ++s) changed = changed || (next[s] == 0) != (part[s] == 0);
    std::vector<std::uint32_t> sizes_before(decisions.size() + 2, 0);
    std::vector<std::uint32_t> sizes_after(decisions.size() + 2, 0);
    for (std::size_t s = 0; s < next.size(); ++s) {
      ++sizes_before[part[s]];
      ++sizes_after[next[s]];
    }
    for (std::size_t s = 0; s < next.size() && !changed; ++s) {
      changed = part[s] != 0 && sizes_before[part[s]] != sizes_after[next[s]];
    }
    part = std::move(next);
  }
  return part;
}

}  // namespace rmpl::verifier
