// The coarsest partition that the steps respect, refined from names and what is told.
// SPDX-License-Identifier: MIT
#include "automata/software/like_markings.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "automata/software/names.hpp"

namespace rmpl::automata {
namespace {

std::string joined(const std::set<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text.append(part).append("\n");
  return text;
}

std::string telling(const ModelProgram& program, const ThreadMarking& marking) {
  std::set<std::string> parts;
  for (const Formula& part : conjuncts_of(told(program, marking.marked))) {
    parts.insert(to_text(part, program.variables));
  }
  return joined(parts) + (marking.possible ? "" : "impossible");
}

std::string conditions(const ModelProgram& program, const ThreadStep& step) {
  std::set<std::string> parts;
  for (const Condition& condition : step.under) {
    parts.insert((condition.entailed ? "+" : "-") + to_text(condition.constraint, program.variables));
  }
  return joined(parts);
}

class Partition {
 public:
  Partition(const ModelProgram& program, const Thread& thread) : thread_(thread) {
    std::map<std::string, std::size_t> names, conditions_known;
    for (const ThreadMarking& marking : thread.markings) {
      const std::string key = name_of(program, marking.marked) + '\n' + telling(program, marking);
      classes_.push_back(names.try_emplace(key, names.size()).first->second);
      auto& own = under_.emplace_back();
      for (const ThreadStep& step : marking.steps) {
        own.push_back(conditions_known.try_emplace(conditions(program, step), conditions_known.size()).first->second);
      }
    }
    count_ = names.size();
    for (std::size_t before = 0; before != count_;) {
      before = count_;
      refine();
    }
  }

  /// By marking; numbered in the order of the first of each.
  [[nodiscard]] const std::vector<std::size_t>& classes() const { return classes_; }
  [[nodiscard]] std::size_t count() const { return count_; }

  /// One outcome for each class by likely draws, and one by improbable ones, as rare as the likeliest.
  [[nodiscard]] std::vector<ThreadOutcome> merged(const std::vector<ThreadOutcome>& outcomes) const {
    std::map<std::pair<std::size_t, bool>, ThreadOutcome> all;
    for (const ThreadOutcome& outcome : outcomes) {
      const std::size_t to = classes_[outcome.target];
      ThreadOutcome& one = all.try_emplace({to, outcome.rarity < 1}, ThreadOutcome{to, 0, 0}).first->second;
      one.probability += outcome.probability;
      one.rarity = std::max(one.rarity, outcome.rarity);
    }
    std::vector<ThreadOutcome> result;
    result.reserve(all.size());
    for (const auto& [to, outcome] : all) result.push_back(outcome);
    return result;
  }

 private:
  /// The conditions of a step, and where it leads.
  using Step = std::pair<std::size_t, std::vector<std::tuple<std::size_t, double, double>>>;

  void refine() {
    std::map<std::pair<std::size_t, std::vector<Step>>, std::size_t> known;
    std::vector<std::size_t> finer;
    finer.reserve(classes_.size());
    for (std::size_t m = 0; m < thread_.markings.size(); ++m) {
      std::vector<Step> steps;
      steps.reserve(under_[m].size());
      for (std::size_t s = 0; s < under_[m].size(); ++s) {
        Step& step = steps.emplace_back(under_[m][s], Step::second_type{});
        for (const ThreadOutcome& outcome : merged(thread_.markings[m].steps[s].outcomes)) {
          step.second.emplace_back(outcome.target, outcome.probability, outcome.rarity);
        }
      }
      std::sort(steps.begin(), steps.end());
      finer.push_back(known.try_emplace({classes_[m], std::move(steps)}, known.size()).first->second);
    }
    classes_ = std::move(finer);
    count_ = known.size();
  }

  const Thread& thread_;
  std::vector<std::vector<std::size_t>> under_;  ///< by marking and step: its conditions, by number
  std::vector<std::size_t> classes_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<std::vector<Marking>> merge_like(const ModelProgram& program, Thread& thread) {
  const Partition partition(program, thread);
  std::vector<std::vector<Marking>> stands_for(partition.count());
  std::vector<ThreadMarking> kept;
  for (std::size_t m = 0; m < thread.markings.size(); ++m) {
    const std::size_t to = partition.classes()[m];
    stands_for[to].push_back(thread.markings[m].marked);
    if (to < kept.size()) continue;
    ThreadMarking& one = kept.emplace_back(thread.markings[m]);
    for (ThreadStep& step : one.steps) step.outcomes = partition.merged(step.outcomes);
  }
  thread.start = partition.merged(thread.start);
  thread.markings = std::move(kept);
  return stands_for;
}

}  // namespace rmpl::automata
