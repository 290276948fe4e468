// A tracked marking is a marking of each group; its successors are found best first over the groups' ways.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/marking_beam.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "automata/dependencies/marking_groups.hpp"
#include "automata/step/marking_step.hpp"
#include "base/check.hpp"
#include "runtime/reasoning/estimate/best_tuples.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/marking_parts.hpp"
#include "runtime/reasoning/estimate/order.hpp"
#include "runtime/reasoning/estimate/product.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"

namespace rmpl::runtime {
namespace {

using automata::Command;
using automata::Marking;
using automata::MarkingStep;
using automata::Observation;

using Numbers = std::vector<MarkingStep::Number>;  // by group
using Way = MarkingStep::Way;

/// A tracked marking with where each of its groups may go; of ways that are equally likely the first in order.
struct Source {
  double weight = 0;
  std::vector<std::vector<Way>> ways;
};

double probability_of(const Source& source, const Numbers& target) {
  double result = 1;
  for (std::size_t g = 0; g < target.size(); ++g) {
    const auto way =
        std::find_if(source.ways[g].begin(), source.ways[g].end(), [&](const Way& w) { return w.target == target[g]; });
    if (way == source.ways[g].end()) return 0;
    result *= way->probability;
  }
  return result;
}

/// One source's successors, best first.
class Successors {
 public:
  explicit Successors(const Source& source) : source_(&source), search_(costs_of(source)) {}

  [[nodiscard]] double bound() const { return source_->weight * std::exp(-search_.bound()); }
  bool next() {
    const auto anything = [](std::span<const std::uint32_t>) -> std::optional<Conflict> { return std::nullopt; };
    return search_.next(anything) == OptimalSearch::Outcome::solution;
  }
  [[nodiscard]] Numbers found() const {
    Numbers result;
    for (std::size_t g = 0; g < source_->ways.size(); ++g) {
      result.push_back(source_->ways[g][search_.values()[g]].target);
    }
    return result;
  }

 private:
  static OptimalSearch::Costs costs_of(const Source& source) {
    OptimalSearch::Costs costs;
    for (const auto& ways : source.ways) {
      auto& values = costs.emplace_back();
      for (const Way& way : ways) values.push_back(std::max(0.0, -std::log(way.probability)));
    }
    return costs;
  }

  const Source* source_;
  OptimalSearch search_;
};

class MarkingBeam final : public MarkingEstimator {
 public:
  MarkingBeam(const automata::ModelProgram& program, const MarkingOptions& options)
      : k_(options.k), listed_(options.listed), candidates_(options.candidates), groups_(program) {
    for (std::size_t g = 0; g < groups_.size(); ++g) steps_.emplace_back(groups_[g].program);
    MarkingBeam::start({});
  }

  const MarkingEstimate& start(const Observation& observation) override {
    CHECK(!updated_);
    const auto seen = groups_.divide(observation);
    for (std::size_t g = 0; g < steps_.size(); ++g) steps_[g].observe(seen[g]);
    Source nowhere{1, {}};
    for (MarkingStep& step : steps_) {
      const auto initial = step.initial();
      if (!initial) refuse();
      nowhere.ways.push_back(*initial);
    }
    estimate_ = {};
    tracked_.clear();
    follow({nowhere});
    return estimate_;
  }

  const MarkingEstimate& update(const Command& command, const Observation& observation) override {
    updated_ = true;
    forget();
    const auto commands = groups_.divide(command);
    const auto seen = groups_.divide(observation);
    std::vector<Source> sources;
    for (std::size_t g = 0; g < steps_.size(); ++g) {
      steps_[g].command(commands[g]);
      steps_[g].observe(seen[g]);
    }
    for (const Tracked& tracked : tracked_) {
      Source& source = sources.emplace_back(Source{tracked.probability, {}});
      for (std::size_t g = 0; g < steps_.size(); ++g) {
        const MarkingStep::Ways& ways = steps_[g].ways(tracked.marking[g]);
        if (!ways) refuse();
        source.ways.push_back(*ways);
      }
    }
    estimate_ = {};
    follow(sources);
    return estimate_;
  }

  [[nodiscard]] MarkingBelief belief() override {
    MarkingBelief result;
    std::vector<const std::vector<automata::Assignment>*> values(steps_.size());
    for (const Tracked& tracked : tracked_) {
      for (std::size_t g = 0; g < steps_.size(); ++g) values[g] = &steps_[g].values(tracked.marking[g]);
      result.push_back({whole(tracked.marking), tracked.probability, joined(groups_, values)});
    }
    put_in_order(result, [](const MarkingEntry& a, const MarkingEntry& b) { return a.marking < b.marking; });
    if (result.size() > listed_) result.resize(listed_);
    return result;
  }
  [[nodiscard]] std::vector<MarkingTrajectory> history() override { return {}; }
  [[nodiscard]] const MarkingEstimate& estimate() const override { return estimate_; }
  [[nodiscard]] std::size_t groups() const override { return steps_.size(); }
  [[nodiscard]] std::size_t questions() override {
    std::size_t sum = 0;
    for (MarkingStep& step : steps_) sum += step.store().questions();
    return sum;
  }
  [[nodiscard]] std::size_t solver_calls() override {
    std::size_t sum = 0;
    for (MarkingStep& step : steps_) sum += step.store().solver_calls();
    return sum;
  }

 private:
  struct Tracked {
    Numbers marking;
    double probability = 0;
  };

  [[noreturn]] static void refuse() {
    throw TooManyStates("one group of threads may go on in more ways than can be listed; expected no --beam");
  }

  Marking whole(const Numbers& marking) {
    std::vector<const Marking*> parts;
    for (std::size_t g = 0; g < steps_.size(); ++g) parts.push_back(&steps_[g].whole(marking[g]));
    return joined(groups_, parts);
  }

  void forget() {
    for (std::size_t g = 0; g < steps_.size(); ++g) {
      Numbers kept;
      for (const Tracked& tracked : tracked_) kept.push_back(tracked.marking[g]);
      std::sort(kept.begin(), kept.end());
      kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
      if (!steps_[g].forget_but(kept)) continue;
      for (Tracked& tracked : tracked_) {
        const auto place = std::lower_bound(kept.begin(), kept.end(), tracked.marking[g]);
        tracked.marking[g] = static_cast<MarkingStep::Number>(place - kept.begin());
      }
    }
  }

  /// Those sources that have somewhere to go, with `seen` where that explains the readings.
  std::vector<Source> open(std::vector<Source> sources, bool seen) {
    for (Source& source : sources) {
      for (std::size_t g = 0; seen && g < steps_.size(); ++g) {
        std::erase_if(source.ways[g], [&](const Way& way) { return !(steps_[g].factor(way.target) > 0); });
      }
    }
    std::erase_if(sources, [](const Source& source) {
      return std::any_of(source.ways.begin(), source.ways.end(), [](const auto& ways) { return ways.empty(); });
    });
    return sources;
  }

  void follow(const std::vector<Source>& sources) {
    std::vector<Source> from = open(sources, true);
    estimate_.explained = !from.empty();
    if (!estimate_.explained) from = open(sources, false);
    estimate_.possible = !from.empty();
    if (!estimate_.possible) return;
    tracked_ = best(from);
    double sum = 0;
    for (Tracked& tracked : tracked_) {
      for (std::size_t g = 0; estimate_.explained && g < steps_.size(); ++g) {
        tracked.probability *= steps_[g].factor(tracked.marking[g]);
      }
      sum += tracked.probability;
    }
    for (Tracked& tracked : tracked_) tracked.probability /= sum;
  }

  /// The `k` targets of greatest predicted probability; ties to the smaller location numbers.
  std::vector<Tracked> best(const std::vector<Source>& sources) {
    std::vector<Successors> fronts(sources.begin(), sources.end());
    std::map<Numbers, double> found;
    std::vector<double> worths;  // falling
    while (true) {
      double left = 0;
      for (const Successors& front : fronts) left += front.bound();
      if (worths.size() >= k_ && left < worths[k_ - 1] * (1 - tie_tolerance)) break;
      const auto next = std::max_element(
          fronts.begin(), fronts.end(), [](const Successors& a, const Successors& b) { return a.bound() < b.bound(); });
      if (!(next->bound() > 0)) break;
      if (estimate_.checked >= candidates_) {
        estimate_.cut = true;
        break;
      }
      if (!next->next()) continue;
      ++estimate_.checked;
      const auto [place, fresh] = found.try_emplace(next->found(), 0.0);
      if (!fresh) continue;
      for (const Source& source : sources) place->second += source.weight * probability_of(source, place->first);
      worths.insert(std::upper_bound(worths.begin(), worths.end(), place->second, std::greater<>()), place->second);
    }
    struct Candidate {
      double probability;
      Marking whole;
      const Numbers* marking;
    };
    std::vector<Candidate> candidates;
    for (const auto& [marking, probability] : found) candidates.push_back({probability, whole(marking), &marking});
    put_in_order(candidates, [](const Candidate& a, const Candidate& b) { return a.whole < b.whole; });
    if (candidates.size() > k_) candidates.resize(k_);
    std::vector<Tracked> result;
    for (const Candidate& candidate : candidates) result.push_back({*candidate.marking, candidate.probability});
    return result;
  }

  std::size_t k_, listed_, candidates_;
  automata::MarkingGroups groups_;
  std::deque<MarkingStep> steps_;
  std::vector<Tracked> tracked_;
  MarkingEstimate estimate_;
  bool updated_ = false;
};

}  // namespace

std::unique_ptr<MarkingEstimator> make_marking_beam(const automata::ModelProgram& program,
                                                    const MarkingOptions& options) {
  return std::make_unique<MarkingBeam>(program, options);
}

}  // namespace rmpl::runtime
