// Following what is done for reward, depth first.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/settle.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace rmpl::runtime {

using automata::Modes;

namespace {

constexpr std::size_t most_steps = 1u << 8;

class Settling {
 public:
  using Answer = base::FunctionRef<Reconfiguration(const Modes&, For)>;

  Settling(Course& course, Answers& answers, Answer answer) : course_(course), answers_(answers), answer_(answer) {}

  void from(const Modes& start) {
    path_.push_back(visited(start, false));
    for (std::size_t steps = 0; !path_.empty() && steps < most_steps;) {
      Visit& here = path_.back();
      if (here.next.empty()) {
        settled_.emplace(std::move(here.modes), here.rewarded);
        path_.pop_back();
        continue;
      }
      ++steps;
      Modes next = std::move(here.next.back());
      here.next.pop_back();
      const auto again =
          std::find_if(path_.begin(), path_.end(), [&](const Visit& visit) { return visit.modes == next; });
      if (again != path_.end()) {
        come_round(again);
      } else if (!settled_.contains({next, here.rewarded})) {
        path_.push_back(visited(std::move(next), here.rewarded));
      }
    }
  }

 private:
  /// A state on the way from the first one.
  struct Visit {
    Modes modes;
    bool before;              ///< something on the way there is done for reward
    bool rewarded;            ///< the same, with what is done there
    std::vector<Modes> next;  ///< where things may go from there and were not followed yet, in reverse order
  };
  using Position = std::vector<Visit>::iterator;

  Visit visited(Modes modes, bool before) {
    const auto [at, fresh] = answers_.try_emplace(modes);
    if (fresh) at->second.answer = answer_(modes, For::rewards);
    const Reconfiguration& answer = at->second.answer;
    const bool rewarded = before || answer.why.purpose == Reason::Purpose::reward;
    std::vector<Modes> next = nexts(modes, answer, rewarded);
    std::reverse(next.begin(), next.end());
    return {std::move(modes), before, rewarded, std::move(next)};
  }

  std::vector<Modes> nexts(const Modes& modes, const Reconfiguration& answer, bool rewarded) {
    const bool waits = answer.outcome == Reconfiguration::Outcome::wait;
    if (answer.why.purpose != Reason::Purpose::goal) {
      return course_.next(modes, waits ? std::nullopt : answer.expected);
    }
    if (waits) return course_.meanwhile(modes, *answer.expected);
    // What a goal needs is never given up; but what was done for reward may be what it has to undo.
    return rewarded && answer.expected ? std::vector<Modes>{*answer.expected} : std::vector<Modes>{};
  }

  /// In states that follow each other in a circle less is done for reward than in the one of them where most is.
  void come_round(Position first) {
    For most = For::nothing;
    for (auto visit = first; visit != path_.end(); ++visit) {
      const Answered& answered = answers_.at(visit->modes);
      if (answered.answer.why.purpose != Reason::Purpose::goal) most = std::min(most, answered.reward);
    }
    if (most == For::nothing) return;
    const For less = most == For::rewards ? For::lasting_rewards : For::nothing;
    for (auto visit = first; visit != path_.end(); ++visit) {
      Answered& answered = answers_.at(visit->modes);
      if (answered.reward < less) answered = {less, answer_(visit->modes, less)};
    }
    path_.erase(std::next(first), path_.end());
    *first = visited(std::move(first->modes), first->before);
  }

  Course& course_;
  Answers& answers_;
  Answer answer_;
  std::vector<Visit> path_;
  std::set<std::pair<Modes, bool>> settled_;  ///< from which nothing goes round
};

}  // namespace

void settle(const Modes& modes, Course& course, Answers& answers, Settling::Answer answer) {
  Settling(course, answers, answer).from(modes);
}

}  // namespace rmpl::runtime
