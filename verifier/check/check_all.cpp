// Several properties at once.
// SPDX-License-Identifier: MIT
#include "verifier/check/check_all.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>

#include "verifier/check/check.hpp"
#include "verifier/slice/empty_claims.hpp"

namespace rmpl::verifier {

using automata::Formula;

namespace {

/// What a property looks for, where it may be looked for together with others.
struct Sought {
  const Formula* formula;
  const Window* window;
  bool wanted;  ///< reachability: a witness makes it hold
};

std::optional<Sought> target_of(const Question& question) {
  const CheckOptions& options = question.options;
  if (options.entailed || options.fewest_faults || options.cut_sets) return std::nullopt;
  if (const auto* p = std::get_if<Reachability>(&question.property)) {
    if (!p->fastest) return Sought{&p->target, &p->window, true};
  }
  if (const auto* p = std::get_if<Safety>(&question.property)) {
    if (!p->fastest) return Sought{&p->never, &p->window, false};
  }
  return std::nullopt;
}

/// Whether two questions leave the same things free.
bool alike(const Question& a, const Question& b) {
  const auto key = [](const Question& q) {
    const Window& window = *target_of(q)->window;
    const CheckOptions& o = q.options;
    return std::tie(o.period, o.faults, o.commands, o.from, window.not_before, window.by);
  };
  return key(a) == key(b);
}

class CheckAll {
 public:
  CheckAll(Slices& slices, const std::vector<Question>& questions, const Limits& limits)
      : slices_(slices), questions_(questions), limits_(limits), answers_(questions.size()) {}

  std::vector<Answer> run() {
    for (const std::vector<std::size_t>& group : explored_together(slices_, questions_)) {
      if (target_of(questions_[group.front()])) {
        look_for(group);
      } else {
        ask_alone(group.front());
      }
    }
    return std::move(answers_);
  }

 private:
  void look_for(std::vector<std::size_t> group) {
    while (!group.empty()) {
      std::vector<Formula> targets;
      targets.reserve(group.size());
      for (const std::size_t q : group) targets.push_back(*target_of(questions_[q])->formula);
      const Question& first = questions_[group.front()];
      const Reachability any{automata::disjunction(std::move(targets)), *target_of(first)->window, false};
      const Answer found = check(slices_, any, first.options, remaining(limits_, spent_));
      spend(found);
      // What cuts runs off may leave one of them alone, as parts of it tell.
      if (group.size() > 1 && (found.cut_off.ends() || found.cut_off.spent)) {
        std::for_each(group.begin(), group.end(), [this](std::size_t q) { ask_alone(q); });
        return;
      }
      const auto decided = std::stable_partition(group.begin(), group.end(), [&](std::size_t q) {
        return found.witness && !holds_at_end(*target_of(questions_[q])->formula, *found.witness);
      });
      std::for_each(decided, group.end(), [&](std::size_t q) { answer(q, found); });
      group.erase(decided, group.end());
    }
  }

  void ask_alone(std::size_t q) {
    answers_[q] = check(slices_, questions_[q].property, questions_[q].options, remaining(limits_, spent_));
    spend(answers_[q]);
  }

  void answer(std::size_t q, const Answer& found) {
    answers_[q] = found;
    if (found.verdict == Verdict::undecided) return;
    const bool reached = found.witness.has_value();
    answers_[q].verdict = reached == target_of(questions_[q])->wanted ? Verdict::holds : Verdict::violated;
    const auto* safety = std::get_if<Safety>(&questions_[q].property);
    if (safety != nullptr) answers_[q].vacuous = vacuity_of_never(slices_, safety->never, false);
  }

  bool holds_at_end(const Formula& formula, const Witness& witness) {
    return slices_.allows(witness.events.back().modes, formula);
  }

  void spend(const Answer& result) {
    spent_.seconds += result.progress.seconds;
    spent_.states += result.progress.states;
  }

  Slices& slices_;
  const std::vector<Question>& questions_;
  const Limits& limits_;
  std::vector<Answer> answers_;
  Progress spent_;
};

}  // namespace

std::vector<std::vector<std::size_t>> explored_together(Slices& slices, const std::vector<Question>& questions) {
  std::vector<std::optional<Cone>> cones;  // of those that may be looked for together
  for (const Question& question : questions) {
    const auto target = target_of(question);
    cones.push_back(target ? std::optional(slices.cone(std::span(target->formula, 1))) : std::nullopt);
  }
  std::vector<std::vector<std::size_t>> groups;
  std::vector<bool> taken(questions.size(), false);
  for (std::size_t q = 0; q < questions.size(); ++q) {
    if (taken[q]) continue;
    groups.push_back({q});
    if (!cones[q]) continue;
    for (std::size_t other = q + 1; other < questions.size(); ++other) {
      if (taken[other] || cones[other] != cones[q] || !alike(questions[q], questions[other])) continue;
      taken[other] = true;
      groups.back().push_back(other);
    }
  }
  return groups;
}

std::vector<Answer> check_all(Slices& slices, const std::vector<Question>& questions, const Limits& limits) {
  return CheckAll(slices, questions, limits).run();
}

}  // namespace rmpl::verifier
