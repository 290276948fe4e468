// The leading candidates by conflict-directed search; each thread is a decision.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/model_diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "automata/logic/theory.hpp"
#include "automata/software/threads.hpp"
#include "runtime/reasoning/diagnose/threads.hpp"
#include "runtime/reasoning/estimate/marking/marking_estimator.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"

namespace rmpl::runtime {
namespace {

using automata::Assignment;
using automata::Formula;
using automata::Marking;
using automata::ModelProgram;
using automata::ValueId;
using automata::VariableId;

/// The threads as variables of a theory, whose first value stands for all likely markings; no name holds a space.
class Moment {
 public:
  Moment(const ModelProgram& program, const automata::Observation& observation)
      : program_(program),
        threads_(judged_threads(program)),
        theory_(with_threads(program), automata::Theory::Upkeep::maintained) {
    for (const automata::Interconnection& told : program.constraints) theory_.tell(told.constraint);
    for (const Assignment& reading : observation) theory_.tell(automata::is(reading.variable, reading.value));
    for (std::size_t t = 0; t < threads_.size(); ++t) {
      std::vector<Formula> likely;
      for (const Marking& marking : threads_[t].likely) likely.push_back(automata::told(program_, marking));
      theory_.tell_if(is(t, 0), automata::disjunction(std::move(likely)));
      for (std::size_t f = 0; f < threads_[t].faults.size(); ++f) {
        theory_.tell_if(is(t, f + 1), automata::told(program_, threads_[t].faults[f].marked));
      }
    }
  }

  /// Whether every thread has a consistent start.
  [[nodiscard]] bool starts() const {
    return std::none_of(threads_.begin(), threads_.end(),
                        [](const JudgedThread& thread) { return thread.likely.empty() && thread.faults.empty(); });
  }

  [[nodiscard]] OptimalSearch::Costs costs() const {
    OptimalSearch::Costs costs;
    for (const JudgedThread& thread : threads_) {
      auto& values = costs.emplace_back(1, 0.0);
      for (const JudgedThread::Fault& fault : thread.faults) values.push_back(-std::log(fault.probability));
    }
    return costs;
  }

  std::optional<Conflict> refute(std::span<const std::uint32_t> candidate) {
    if (theory_.consistent(assumed(candidate))) return std::nullopt;
    Conflict conflict;
    for (const Assignment& a : theory_.conflict()) {
      conflict.push_back({static_cast<std::uint32_t>(a.variable.index() - program_.variables.size()), a.value.value});
    }
    return conflict;
  }

  ModelDiagnosis diagnosis(std::span<const std::uint32_t> candidate) {
    ModelDiagnosis result;
    for (std::size_t t = 0; t < candidate.size(); ++t) {
      if (candidate[t] == 0) continue;
      const JudgedThread::Fault& fault = threads_[t].faults[candidate[t] - 1];
      result.probability *= fault.probability;
      result.faults.push_back(fault.marked);
    }
    const std::vector<Assignment> all = assumed(candidate);
    std::vector<Assignment> world;
    if (theory_.consistent(all)) {
      for (std::size_t v = 0; v < program_.variables.size(); ++v) {
        world.push_back({VariableId(v), theory_.value(VariableId(v))});
      }
    }
    for (const Assignment& value : world) {
      if (!theory_.allows_other(all, value)) result.values.push_back(value);
    }
    return result;
  }

 private:
  [[nodiscard]] automata::Variables with_threads(const ModelProgram& program) const {
    automata::Variables variables = program.variables;
    for (std::size_t t = 0; t < threads_.size(); ++t) {
      std::vector<std::string> values{"likely"};
      for (std::size_t f = 0; f < threads_[t].faults.size(); ++f) values.push_back("fault " + std::to_string(f));
      variables.add({"thread " + std::to_string(t), std::move(values)});
    }
    return variables;
  }
  [[nodiscard]] Assignment is(std::size_t thread, std::size_t status) const {
    return {VariableId(program_.variables.size() + thread), ValueId(status)};
  }
  [[nodiscard]] std::vector<Assignment> assumed(std::span<const std::uint32_t> candidate) const {
    std::vector<Assignment> result;
    for (std::size_t t = 0; t < candidate.size(); ++t) result.push_back(is(t, candidate[t]));
    return result;
  }

  const ModelProgram& program_;
  std::vector<JudgedThread> threads_;
  automata::Theory theory_;
};

}  // namespace

ModelDiagnoses diagnose(const ModelProgram& program, const automata::Observation& observation, std::size_t k,
                        double ratio) {
  Moment moment(program, observation);
  OptimalSearch search(moment.costs());
  const auto check = [&](std::span<const std::uint32_t> candidate) { return moment.refute(candidate); };
  constexpr double tolerance = 1e-9;
  ModelDiagnoses result;
  // Each thread may have a start, and all together none.
  result.starts = moment.starts() && make_marking_estimator(program, {.k = 1})->estimate().possible;
  double limit = std::numeric_limits<double>::infinity();
  // One candidate at a time: none is checked that would be too unlikely.
  while (result.diagnoses.size() < k && search.bound() <= limit) {
    search.set_budget(1);
    const OptimalSearch::Outcome outcome = search.next(check);
    if (outcome == OptimalSearch::Outcome::exhausted) break;
    if (outcome == OptimalSearch::Outcome::budget) continue;
    if (result.diagnoses.empty()) limit = search.cost() + std::log(ratio) + tolerance;
    if (search.cost() > limit) break;
    result.diagnoses.push_back(moment.diagnosis(search.values()));
  }
  result.checked = search.checked();
  return result;
}

}  // namespace rmpl::runtime
