// Properties of a plant and of a program that controls it, at once.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/check_all.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>

#include "base/work_together.hpp"
#include "verifier/check/check_all.hpp"
#include "verifier/closed_loop/check.hpp"

namespace rmpl::verifier {

namespace {

/// Whether two questions about a program leave the same things free.
bool alike(const Question& a, const Question& b) {
  const auto key = [](const Question& q) {
    return std::tie(q.options.period, q.options.faults, q.options.entailed, q.options.fewest_faults, q.options.cut_sets,
                    q.options.from);
  };
  return key(a) == key(b);
}

/// Those at some positions.
template <class Element>
std::vector<Element> at(const std::vector<Element>& all, const std::vector<std::size_t>& positions) {
  std::vector<Element> result;
  for (const std::size_t p : positions) result.push_back(all[p]);
  return result;
}

/// Questions of a plant that are explored together, or of a program that are decided together.
using Group = std::vector<std::size_t>;

std::vector<Group> groups_of(Slices& slices, const std::vector<Question>& questions) {
  std::vector<std::size_t> of_plant, of_program;
  for (std::size_t q = 0; q < questions.size(); ++q) {
    (std::holds_alternative<ProgramProperty>(questions[q].property) ? of_program : of_plant).push_back(q);
  }
  std::vector<Group> groups = explored_together(slices, at(questions, of_plant));
  for (Group& group : groups) {
    for (std::size_t& member : group) member = of_plant[member];
  }
  while (!of_program.empty()) {
    const Question& first = questions[of_program.front()];
    const auto others = std::stable_partition(of_program.begin(), of_program.end(),
                                              [&](std::size_t q) { return alike(questions[q], first); });
    groups.emplace_back(of_program.begin(), others);
    of_program.erase(of_program.begin(), others);
  }
  return groups;
}

class Turns {
 public:
  Turns(const Subject& subject, Slices& slices, const std::vector<Question>& questions, const Limits& limits,
        std::size_t threads)
      : subject_(subject),
        questions_(questions),
        limits_(limits),
        open_(groups_of(slices, questions)),
        answers_(questions.size()),
        slices_(std::clamp<std::size_t>(open_.size(), 1, threads)) {
    for (Answer& answer : answers_) answer.limit = Limit::time;  // until it is begun
    slices_.front() = &slices;
    others_.resize(slices_.size());
    if (limits.report && slices_.size() > 1) {
      limits_.report = [this, report = limits.report](const Progress& progress) {
        const std::lock_guard lock(report_);
        report(progress);
      };
    }
  }

  std::vector<Answer> run() {
    constexpr double first_turn = 0.05, growth = 10, longest_turn = 5;
    bool last = open_.size() < 2;
    for (double turn = first_turn; !open_.empty(); turn *= growth) {
      last = last || share_of_left(open_.size()) <= turn || (!limits_.time && turn > longest_turn);
      take_turns(last ? std::nullopt : std::optional(turn));
      if (last) break;
    }
    return std::move(answers_);
  }

 private:
  using Seconds = std::chrono::duration<double>;

  /// Of the time for all together; infinite where there is no limit.
  [[nodiscard]] double left() const {
    if (!limits_.time) return std::numeric_limits<double>::infinity();
    return std::max(0.0, (*limits_.time - Seconds(std::chrono::steady_clock::now() - begin_)).count());
  }
  /// What one of so many groups may have of that.
  [[nodiscard]] double share_of_left(std::size_t groups) const {
    const std::size_t rounds = (groups + slices_.size() - 1) / slices_.size();
    return left() / static_cast<double>(rounds);
  }

  /// A turn of so many seconds for each that is open; without a number of them the last, which shares what is left.
  void take_turns(std::optional<double> seconds) {
    std::vector<char> settled(open_.size());
    base::share_tasks(slices_.size(), open_.size(), [&](std::size_t g, std::size_t thread) {
      Limits limits = limits_;
      const double share = std::min(share_of_left(open_.size() - g), seconds.value_or(left()));
      if (seconds || limits_.time) limits.time = Seconds(share);
      settled[g] = take_turn(open_[g], slices_of(thread), limits);
    });
    std::vector<Group> still_open;
    for (std::size_t g = 0; g < open_.size(); ++g) {
      if (!settled[g]) still_open.push_back(std::move(open_[g]));
    }
    open_ = std::move(still_open);
  }

  /// Those of a thread, which makes them when it first has something to do.
  Slices& slices_of(std::size_t thread) {
    if (slices_[thread] == nullptr) {
      others_[thread] = std::make_unique<Slices>(subject_.plant);
      slices_[thread] = others_[thread].get();
    }
    return *slices_[thread];
  }

  /// Whether more time would make no difference. What an earlier turn decided, and this one does not, stays.
  bool take_turn(const Group& group, Slices& slices, const Limits& limits) {
    std::vector<Answer> found = ask(group, slices, limits);
    bool settled = true;
    for (std::size_t i = 0; i < group.size(); ++i) {
      Answer& known = answers_[group[i]];
      settled = settled && found[i].limit != Limit::time;
      const bool loses = found[i].verdict == Verdict::undecided &&
                         (known.verdict != Verdict::undecided || known.progress.states > found[i].progress.states);
      if (!loses) {
        known = std::move(found[i]);
      } else if (found[i].limit) {
        known.limit = found[i].limit;  // why the search is over in the end
      }
    }
    return settled;
  }

  std::vector<Answer> ask(const Group& group, Slices& slices, const Limits& limits) {
    const Question& first = questions_[group.front()];
    if (!std::holds_alternative<ProgramProperty>(first.property)) {
      return check_all(slices, at(questions_, group), limits);
    }
    std::vector<Property> asked;
    for (const std::size_t q : group) asked.push_back(questions_[q].property);
    std::vector<Answer> found = check(*subject_.program, slices.whole(), asked, first.options, limits);
    // Each stands for itself: a trace that two have in common is told by both.
    for (Answer& answer : found) answer.same_as.reset();
    return found;
  }

  const Subject& subject_;
  const std::vector<Question>& questions_;
  Limits limits_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::vector<Group> open_;
  std::vector<Answer> answers_;
  std::vector<Slices*> slices_;  ///< by thread
  std::vector<std::unique_ptr<Slices>> others_;
  std::mutex report_;
};

}  // namespace

std::vector<Answer> check_all(const Subject& subject, Slices& slices, const std::vector<Question>& questions,
                              const Limits& limits, std::size_t threads) {
  return Turns(subject, slices, questions, limits, threads).run();
}

}  // namespace rmpl::verifier
