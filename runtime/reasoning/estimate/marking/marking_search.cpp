// A queue over sources; each is an optimal constraint satisfaction problem over the parts of its step.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/marking/marking_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "runtime/reasoning/estimate/order.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"

namespace rmpl::runtime {
namespace {

using automata::LocationId;
using automata::Marking;
using automata::MarkingMoves;
using automata::MarkingOutcome;
using automata::MarkingStep;

bool subset(const Marking& part, const Marking& whole) {
  return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
}

/// How likely the moves are to lead to exactly this marking: no two parts have a location in common.
double probability_of(const MarkingMoves& moves, const Marking& target) {
  if (!subset(moves.certain, target)) return 0;
  std::size_t covered = moves.certain.size();
  double result = 1;
  for (const auto& part : moves.parts) {
    const MarkingOutcome* fits = nullptr;
    for (const MarkingOutcome& outcome : part) {
      const bool larger = fits == nullptr || outcome.marked.size() > fits->marked.size();
      if (larger && subset(outcome.marked, target)) fits = &outcome;
    }
    if (fits == nullptr) return 0;
    covered += fits->marked.size();
    result *= fits->probability;
  }
  return covered == target.size() ? result : 0;
}

OptimalSearch::Costs costs_of(const MarkingMoves& moves) {
  OptimalSearch::Costs costs;
  for (const auto& part : moves.parts) {
    auto& values = costs.emplace_back();
    for (const MarkingOutcome& outcome : part) values.push_back(std::max(0.0, -std::log(outcome.probability)));
  }
  return costs;
}

/// By how much more each possible outcome is worth, as the others cannot happen; 1 where they are too many to be
/// listed. What is worth less than it should be is missing then.
double scale_of(const MarkingStep::Ways& ways) {
  if (!ways) return 1;
  double possible = 0;
  for (const MarkingStep::Way& way : *ways) possible += way.probability;
  return possible > 0 ? 1 / possible : 0;
}

struct Source {
  Source(const MarkingMoves& from, double probability) : moves(&from), weight(probability), search(costs_of(from)) {}
  [[nodiscard]] double bound() const { return weight * std::exp(-search.bound()); }

  const MarkingMoves* moves;
  double weight;
  OptimalSearch search;
};

class Search {
 public:
  Search(MarkingStep& step, const NumberedBelief& sources, Worth worth, std::size_t candidates)
      : step_(step), worth_(worth), candidates_(candidates) {
    for (const NumberedEntry& entry : sources) {
      if (!step.permits(entry.marking)) continue;
      sources_.emplace_back(step.moves(entry.marking), entry.probability * scale_of(step.ways(entry.marking)));
      result_.unfound += entry.probability;
    }
  }

  BestMarkings run(std::size_t k) {
    while (!enough(k)) {
      const auto next = std::max_element(sources_.begin(), sources_.end(),
                                         [](const Source& a, const Source& b) { return a.bound() < b.bound(); });
      if (next == sources_.end() || !(next->bound() > 0)) break;
      if (result_.checked >= candidates_ && !result_.found.empty()) {
        result_.cut = true;
        break;
      }
      advance(*next);
    }
    const bool exhausted =
        std::none_of(sources_.begin(), sources_.end(), [](const Source& s) { return s.bound() > 0; });
    result_.unfound = exhausted ? 0 : std::max(result_.unfound, 0.0);
    return std::move(result_);
  }

 private:
  Marking target(const Source& source, std::span<const std::uint32_t> candidate) const {
    Marking marking = source.moves->certain;
    for (std::size_t p = 0; p < candidate.size(); ++p) {
      const Marking& more = source.moves->parts[p][candidate[p]].marked;
      marking.insert(marking.end(), more.begin(), more.end());
    }
    std::sort(marking.begin(), marking.end());
    return marking;
  }

  /// Nothing where the marking is possible, and explains what is seen; else the outcomes that mark what contradicts.
  std::optional<Conflict> check(const Source& source, std::span<const std::uint32_t> candidate) {
    const MarkingStep::Number number = step_.number(target(source, candidate));
    if (step_.possible(number) && step_.factor(number) > 0) return std::nullopt;
    const Marking blamed = step_.conflict(number, true);
    Conflict conflict;
    for (std::size_t p = 0; p < candidate.size(); ++p) {
      const Marking& marked = source.moves->parts[p][candidate[p]].marked;
      const bool guilty = std::any_of(marked.begin(), marked.end(), [&](LocationId l) {
        return std::binary_search(blamed.begin(), blamed.end(), l);
      });
      if (guilty) conflict.push_back({static_cast<std::uint32_t>(p), candidate[p]});
    }
    return conflict;
  }

  void advance(Source& source) {
    const std::size_t before = source.search.checked();
    source.search.set_budget(1);
    const auto outcome = source.search.next([&](std::span<const std::uint32_t> c) { return check(source, c); });
    result_.checked += source.search.checked() - before;
    if (outcome != OptimalSearch::Outcome::solution) return;
    const MarkingStep::Number number = step_.number(target(source, source.search.values()));
    if (!known_.insert(number).second) return;
    double prior = 0;
    for (const Source& from : sources_) prior += from.weight * probability_of(*from.moves, step_[number]);
    result_.unfound -= prior;
    const double worth = worth_ == Worth::posterior ? prior * step_.factor(number) : prior;
    if (worth > 0) result_.found.push_back({number, worth});
  }

  /// Whether nothing that was not found yet can be among the k best.
  bool enough(std::size_t k) {
    if (result_.found.size() < k) return false;
    if (worths_.size() != result_.found.size()) {
      worths_.clear();
      for (const NumberedEntry& entry : result_.found) worths_.push_back(entry.probability);
      std::nth_element(worths_.begin(), worths_.begin() + static_cast<std::ptrdiff_t>(k - 1), worths_.end(),
                       std::greater<>());
      worst_ = worths_[k - 1];
    }
    double left = 0;
    for (const Source& source : sources_) left += source.bound();
    return left < worst_ * (1 - tie_tolerance);
  }

  MarkingStep& step_;
  Worth worth_;
  std::size_t candidates_;
  std::vector<Source> sources_;
  std::set<MarkingStep::Number> known_;
  std::vector<double> worths_;
  double worst_ = 0;
  BestMarkings result_;
};

}  // namespace

BestMarkings best_markings(MarkingStep& step, const NumberedBelief& sources, Worth worth, std::size_t k,
                           std::size_t candidates) {
  return Search(step, sources, worth, candidates).run(k);
}

}  // namespace rmpl::runtime
