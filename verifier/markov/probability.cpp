// Which way a question of probability is decided.
// SPDX-License-Identifier: MIT
#include "verifier/markov/probability.hpp"

#include <algorithm>
#include <functional>
#include <memory>

#include "base/bounded_cache.hpp"
#include "base/error.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "verifier/markov/bounded.hpp"
#include "verifier/markov/dense.hpp"
#include "verifier/markov/loop_process.hpp"
#include "verifier/markov/outlook.hpp"
#include "verifier/markov/plant_process.hpp"
#include "verifier/markov/unbounded.hpp"
#include "verifier/markov/walk.hpp"
#include "verifier/property/initial_modes.hpp"

namespace rmpl::verifier {

using automata::Modes;
using automata::Ticks;

namespace {

constexpr std::size_t answers_remembered = std::size_t{1} << 16;
/// Of what is walked: first what is less likely than this is left out, then less and less.
constexpr Real first_ignored = 1e-12L;
constexpr Real least_ignored = 1e-60L;
/// Once something is known of the probability, such parts of what bounds may be apart are left out at will: of all, and
/// of an episode, within which others may begin.
constexpr Real of_all = 0.4L;
constexpr Real of_episode = 0.05L;
/// Of what is explored as a whole, outcomes of a step that are less likely than this are left out: where there are many
/// components, most outcomes are many coincidences at once.
constexpr Real coincidence = 1e-50L;
/// Clocks on which nothing depends for more steps than this are kept apart from states.
constexpr Units longest_in_state = 64;

std::function<bool(const Modes&)> holds_in(automata::PlantStep& step, const ProbabilityQuestion& question) {
  using Answers = base::BoundedCache<Modes, bool, automata::ModesHash>;
  const automata::Theory::Handle handle = step.theory().encode(question.target);
  const auto answers = std::make_shared<Answers>(answers_remembered);
  return [&step, handle, certain = question.entailed, answers](const Modes& modes) {
    return answers->find_or(modes, [&] {
      const std::vector<automata::Assignment> store = automata::assignments_of(step.plant(), modes);
      return certain ? step.theory().entails(store, handle) : step.theory().allows(store, handle);
    });
  };
}

/// The steps that the question is about: the points of the curve, and the last one.
std::vector<Units> steps_of(const ProbabilityQuestion& question) {
  const Units last = question.within->count / question.period->count;
  std::vector<Units> result;
  for (std::size_t i = 0; i + 1 < question.points; ++i) {
    const auto part = static_cast<long double>(i) / static_cast<long double>(question.points - 1);
    result.push_back(static_cast<Units>(part * static_cast<long double>(last)));
  }
  result.push_back(last);
  return result;
}

class Decision {
 public:
  /// Makes the process with these outcomes left out; `apart`: long clocks are kept apart from states.
  using Make = std::function<std::unique_ptr<Process>(const Walked& walked, bool apart)>;

  Decision(const ProbabilityQuestion& question, Walked walked, Make make, Meter& meter)
      : question_(question), walked_(std::move(walked)), make_(std::move(make)), meter_(meter) {
    walked_.left_out.faults_beyond = question.faults;
  }

  ProbabilityAnswer run(bool chain) {
    answer_.faults_at_most = question_.faults;
    if (chain) {
      Likelihood& only = answer_.only.emplace();
      if (question_.within) walk_to(only);
      if (!question_.within || question_.mean_time) explore_for(only, Aim::greatest);
    } else {
      if (question_.least) explore_for(answer_.least.emplace(), Aim::least);
      if (question_.greatest) explore_for(answer_.greatest.emplace(), Aim::greatest);
    }
    for (const auto* one : {&answer_.only, &answer_.least, &answer_.greatest}) {
      if (*one) answer_.precise = answer_.precise && is_precise(**one);
    }
    return std::move(answer_);
  }

 private:
  [[nodiscard]] Real precision() const { return static_cast<Real>(question_.precision); }
  [[nodiscard]] bool is_precise(const Likelihood& one) const {
    return is_within(one.probability, precision()) &&
           (!one.mean_time || one.mean_time->infinite || is_within(one.mean_time->seconds, precision()));
  }

  /// What is left out is made less and less until the bounds are near to each other, or that does not help any more:
  /// runs with more faults than may be followed stay unknown.
  void walk_to(Likelihood& result) {
    const std::vector<Units> steps = steps_of(question_);
    std::optional<Real> width;
    const std::unique_ptr<Process> process = make_(walked_, true);
    KnownRows known;
    Tolerance tolerance{first_ignored, 0, 0};
    Real share = 1;
    while (tolerance.ignored > least_ignored) {
      const std::vector<Reached> reached = walk(*process, steps, tolerance, known, meter_);
      note(reached, result);
      answer_.startless = process->initial().empty();
      const Real now = result.probability.upper - result.probability.lower;
      if (is_within(result.probability, precision())) return;
      if (process->tells_more_apart()) {
        known.clear();
        continue;
      }
      if (question_.faults && width && now > *width / 2) return;
      width = now;
      tolerance.ignored = less_than(tolerance.ignored, result.probability);
      tolerance.all = share * of_all * precision() * result.probability.lower;
      tolerance.part = share * of_episode * precision();
      share /= 2;
    }
  }

  /// What to leave out in the next round: where the probability is known by half, what many such things may sum up to;
  /// else the less, the further apart bounds are.
  [[nodiscard]] Real less_than(Real ignored, const Enclosure& found) const {
    constexpr Real least_factor = 1e3L;
    constexpr Real greatest_factor = 1e9L;
    constexpr Real many = 1e7L;
    if (found.lower > found.upper / 2) return std::min(ignored / least_factor, precision() * found.lower / many);
    const Real apart = (found.upper - found.lower) / (precision() * found.upper);
    return ignored / std::clamp(apart * apart, least_factor, greatest_factor);
  }

  void note(const std::vector<Reached>& reached, Likelihood& result) const {
    result.probability = reached.back().probability;
    result.curve.clear();
    if (question_.points == 0) return;
    for (const Reached& at : reached) {
      result.curve.push_back({Ticks{at.step * question_.period->count}, at.probability});
    }
  }

  const DecisionProcess& whole() {
    if (!decisions_) {
      walked_.left_out.less_likely_than = question_.mean_time ? 0 : coincidence;
      process_ = make_(walked_, false);
      const bool bounded = question_.within && !question_.mean_time;
      decisions_ = explore(*process_, bounded ? std::optional(steps_of(question_).back()) : std::nullopt, meter_);
      answer_.startless = decisions_->start.empty();
    }
    return *decisions_;
  }

  void explore_for(Likelihood& result, Aim aim) {
    const DecisionProcess& decisions = whole();
    if (!question_.within) {
      result.probability = ever(decisions, aim, meter_);
    } else if (!answer_.only) {
      const std::vector<Units> steps = steps_of(question_);
      const std::vector<Enclosure> values = within_steps(decisions, aim, steps, meter_);
      std::vector<Reached> reached;
      for (std::size_t i = 0; i < steps.size(); ++i) reached.push_back({steps[i], values[i]});
      note(reached, result);
    }
    if (!question_.mean_time) return;
    const Enclosure steps = mean_steps(decisions, aim, meter_);
    MeanTime& mean = result.mean_time.emplace();
    mean.infinite = steps.lower == unbounded_time;
    const Enclosure seconds = outward({static_cast<Real>(question_.period->count) / Ticks::per_second,
                                       static_cast<Real>(question_.period->count) / Ticks::per_second},
                                      1);
    if (!mean.infinite) mean.seconds = steps * seconds;
  }

  const ProbabilityQuestion& question_;
  Walked walked_;
  Make make_;
  Meter& meter_;
  std::unique_ptr<Process> process_;
  std::optional<DecisionProcess> decisions_;
  ProbabilityAnswer answer_;
};

Walked walked_of(automata::PlantStep& step, const ProbabilityQuestion& question) {
  demand_modes(step.plant(), question.from);
  Walked result;
  result.period = *question.period;
  result.wanted = holds_in(step, question);
  result.from = question.from;
  result.for_ever = !question.within || question.mean_time;
  result.longest_in_state = longest_in_state;
  if (question.within) result.steps = steps_of(question).back();
  return result;
}

/// Where there is an end by which they tell something.
std::unique_ptr<const Prospects> prospects_of(const automata::Plant& plant, const ProbabilityQuestion& question,
                                              Commands commands, Meter& meter) {
  if (!question.within) return nullptr;
  const Prospects::Question asked{question.target, question.entailed, commands,
                                  question.from,   *question.period,  steps_of(question).back()};
  return std::make_unique<const Prospects>(plant, asked, meter);
}

/// The answer that `decide` gives, or what ended it.
template <class Decide>
ProbabilityAnswer limited(Meter& meter, const Decide& decide) {
  ProbabilityAnswer answer;
  try {
    answer = decide();
  } catch (const LimitReached& reached) {
    answer = {};
    answer.limit = reached.limit;
  }
  answer.progress = meter.progress();
  return answer;
}

}  // namespace

ProbabilityAnswer probability(automata::PlantStep& step, const ProbabilityQuestion& question, const Limits& limits) {
  Meter meter(limits);
  if (!question.period) {
    return limited(meter, [&] { return dense_probability(step, question, holds_in(step, question), meter); });
  }
  Walked walked = walked_of(step, question);
  std::size_t actions = 0;
  for_each_action(step.plant(), question.commands, [&](const automata::ControlAction&) { ++actions; });
  return limited(meter, [&] {
    const auto prospects = actions == 1 ? prospects_of(step.plant(), question, question.commands, meter) : nullptr;
    walked.prospects = prospects.get();
    const auto make = [&](const Walked& own, bool apart) -> std::unique_ptr<Process> {
      return std::make_unique<PlantProcess>(step, question.commands, own, apart, meter);
    };
    return Decision(question, walked, make, meter).run(actions == 1);
  });
}

ProbabilityAnswer probability(const automata::Program& program, automata::PlantStep& step,
                              const ProbabilityQuestion& question, const Limits& limits) {
  if (!question.period) {
    throw base::InputError(
        "dense time: the probability of a program is told for its cycles alone; expected --time with a cycle");
  }
  Meter meter(limits);
  Walked walked = walked_of(step, question);
  const auto reconfigurer = runtime::make_reconfigurer(step, nullptr, *question.period);
  Loop loop(program, step, *reconfigurer, TimeModel::sampled(*question.period), 0, meter, {});
  return limited(meter, [&] {
    const auto prospects = prospects_of(step.plant(), question, Commands::any, meter);
    walked.prospects = prospects.get();
    std::optional<Outlook> outlook;
    if (question.within && !question.faults) {
      outlook.emplace(program, step.plant(),
                      Outlook::Question{question.target, question.entailed, *question.period,
                                        static_cast<Real>(question.precision)},
                      meter);
    }
    const auto make = [&](const Walked& own, bool apart) -> std::unique_ptr<Process> {
      return std::make_unique<LoopProcess>(loop, step, own, apart, apart, apart && outlook ? &*outlook : nullptr,
                                           meter);
    };
    return Decision(question, walked, make, meter).run(true);
  });
}

}  // namespace rmpl::verifier
