// Hitting sets of conflicts among readings, and a theory that finds the conflicts.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/set_aside.hpp"

#include <algorithm>
#include <utility>

#include "automata/store/model.hpp"

namespace rmpl::runtime {
namespace {

using automata::Assignment;
using automata::Formula;
using automata::Observation;
using automata::Theory;
using automata::ValueId;

/// Conflicts as sets of positions, and the first smallest set that meets all of them.
class HittingSets {
 public:
  explicit HittingSets(std::size_t elements) : chosen_(elements, false) {}

  void add(std::vector<std::size_t> conflict) { conflicts_.push_back(std::move(conflict)); }

  /// The elements of the first smallest set, ascending.
  std::vector<std::size_t> first_smallest() {
    chosen_.assign(chosen_.size(), false);
    while (!can_meet(0, size_)) ++size_;
    std::vector<std::size_t> result;
    std::size_t from = 0;
    for (std::size_t left = size_; left > 0; --left) {
      while (true) {
        chosen_[from] = true;
        if (can_meet(from + 1, left - 1)) break;
        chosen_[from++] = false;
      }
      result.push_back(from++);
    }
    return result;
  }

 private:
  [[nodiscard]] bool is_met(const std::vector<std::size_t>& conflict) const {
    return std::any_of(conflict.begin(), conflict.end(), [&](std::size_t e) { return chosen_[e]; });
  }

  /// Whether `left` more elements, none before `from`, are enough to meet all conflicts.
  bool can_meet(std::size_t from, std::size_t left) {
    // Conflicts that have no element in common need one each.
    std::vector<bool> taken(chosen_.size(), false);
    const std::vector<std::size_t>* first = nullptr;
    std::size_t apart = 0;
    for (const auto& conflict : conflicts_) {
      if (is_met(conflict)) continue;
      if (std::any_of(conflict.begin(), conflict.end(), [&](std::size_t e) { return taken[e]; })) continue;
      for (const std::size_t e : conflict) taken[e] = true;
      if (++apart > left) return false;
      if (first == nullptr || conflict.size() < first->size()) first = &conflict;
    }
    if (first == nullptr) return true;
    for (const std::size_t e : *first) {
      if (e < from) continue;
      chosen_[e] = true;
      const bool met = can_meet(from, left - 1);
      chosen_[e] = false;
      if (met) return true;
    }
    return false;
  }

  std::vector<std::vector<std::size_t>> conflicts_;
  std::vector<bool> chosen_;
  std::size_t size_ = 0;  ///< of the smallest set; conflicts only make it larger
};

}  // namespace

std::optional<Observation> readings_to_set_aside(const Observation& seen, Refute refute) {
  if (refute({})) return std::nullopt;
  HittingSets sets(seen.size());
  std::vector<bool> aside(seen.size(), false);
  const auto rest = [&](const std::vector<bool>& left_out) {
    Observation result;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (!left_out[i]) result.push_back(seen[i]);
    }
    return result;
  };
  while (true) {
    // Conflicts that have nothing in common are found at once.
    std::vector<bool> left_out = aside;
    bool refuted = false;
    while (const auto conflict = refute(rest(left_out))) {
      refuted = true;
      std::vector<std::size_t> positions;
      for (std::size_t i = 0; i < seen.size(); ++i) {
        if (std::find(conflict->begin(), conflict->end(), seen[i]) == conflict->end()) continue;
        positions.push_back(i);
        left_out[i] = true;
      }
      sets.add(std::move(positions));
    }
    if (!refuted) break;
    aside.assign(seen.size(), false);
    for (const std::size_t i : sets.first_smallest()) aside[i] = true;
  }
  aside.flip();
  return rest(aside);
}

Observation without(const Observation& seen, const Observation& set_aside) {
  Observation result;
  for (const Assignment& reading : seen) {
    if (std::find(set_aside.begin(), set_aside.end(), reading) == set_aside.end()) result.push_back(reading);
  }
  return result;
}

Observation minimal_conflict(Observation refuted, base::FunctionRef<bool(const Observation&)> explained) {
  for (std::size_t i = 0; i < refuted.size();) {
    Observation fewer = refuted;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (explained(fewer)) {
      ++i;
    } else {
      refuted = std::move(fewer);
    }
  }
  return refuted;
}

StepTargets::StepTargets(const automata::Plant& plant) : plant_(plant) {
  std::size_t modes = 0;
  for (const automata::Component& component : plant.components) {
    first_.push_back(modes);
    modes += component.modes.size();
  }
  first_.push_back(modes);
}

void StepTargets::begin() {
  reaches_.clear();
  reach_.reset();
}

/// A state that reaches no more than another one adds nothing; that is looked at for some of the others.
void StepTargets::add(const std::vector<std::vector<automata::Move>>& moves) {
  constexpr std::size_t looked_at = 64;
  Reach reach((first_.back() + 63) / 64, 0);
  for (std::size_t c = 0; c < moves.size(); ++c) {
    for (const automata::Move& move : moves[c]) {
      const std::size_t bit = first_[c] + move.mode.index();
      reach[bit / 64] |= std::uint64_t{1} << (bit % 64);
    }
  }
  const auto within = [](const Reach& less, const Reach& more) {
    return std::equal(less.begin(), less.end(), more.begin(), [](auto l, auto m) { return (l & ~m) == 0; });
  };
  const std::size_t most = std::min(reaches_.size(), looked_at);
  const auto end = reaches_.begin() + static_cast<std::ptrdiff_t>(most);
  if (std::any_of(reaches_.begin(), end, [&](const Reach& other) { return within(reach, other); })) return;
  reach_.reset();
  std::erase_if(reaches_, [&](const Reach& other) { return within(other, reach); });
  reaches_.push_back(std::move(reach));
}

Theory::Handle StepTargets::some_reach() {
  if (reach_) return *reach_;
  constexpr std::size_t most_uses = 64;
  if (!theory_ || ++uses_ > most_uses) {
    theory_.emplace(automata::model_theory(plant_));
    uses_ = 0;
  }
  std::vector<Formula> some;
  for (const Reach& reach : reaches_) {
    std::vector<Formula> all;
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      std::vector<ValueId> modes;
      for (std::size_t bit = first_[c]; bit < first_[c + 1]; ++bit) {
        if ((reach[bit / 64] >> (bit % 64) & 1) != 0) modes.emplace_back(bit - first_[c]);
      }
      if (modes.size() == plant_.components[c].modes.size()) continue;
      all.push_back(automata::member(plant_.components[c].mode, std::move(modes)));
    }
    some.push_back(automata::conjunction(std::move(all)));
  }
  return reach_.emplace(theory_->encode(automata::disjunction(std::move(some))));
}

std::optional<Observation> StepTargets::refute(const Observation& readings) {
  const Theory::Handle reach = some_reach();
  if (theory_->allows(readings, reach)) return std::nullopt;
  return theory_->minimal_conflict(theory_->conflict(), reach);
}

}  // namespace rmpl::runtime
