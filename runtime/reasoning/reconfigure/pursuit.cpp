// Candidate by candidate, as the goal interpreter has them.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/pursuit.hpp"

#include <algorithm>

#include "runtime/reasoning/reconfigure/lasting.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Modes;

std::variant<Modes, Impasse> Pursuit::run() {
  auto interpreted =
      interpreter_.interpret(modes_, goal_, prospects_, [this](const Modes& candidate) { return judge(candidate); });
  if (passing_ && (any_ || std::holds_alternative<Impasse>(interpreted))) {
    needed_ = std::move(passing_->needed);
    return std::move(passing_->state);
  }
  if (std::holds_alternative<Impasse>(interpreted)) {
    if (obstacle_) return std::move(*obstacle_);
  } else if (!rested_on_.empty()) {
    lay_ground();
  }
  return interpreted;
}

/// Nothing where the candidate will do; else what is to blame.
std::optional<Pursuit::Blamed> Pursuit::judge(const Modes& candidate) {
  need(candidate);
  if (auto failed = plan()) return blame(candidate, std::move(*failed));
  if (any_) return std::nullopt;
  auto undone = undone_at_end();
  if (undone && leaves_aside(candidate, *undone)) {
    Needed before = needed_;
    need(candidate);
    if (plan()) {
      needed_ = std::move(before);
    } else {
      undone = undone_at_end();
    }
  }
  return undone ? lost(candidate, std::move(*undone)) : std::nullopt;
}

std::optional<std::pair<Impasse, std::size_t>> Pursuit::plan() {
  return plans_.plan(modes_, {needed_.target, needed_.permitted, 0, needed_.wanted}, needed_.offers);
}

/// What is to blame for a goal that does not last where the plan ends; nothing where it does.
std::optional<Pursuit::Blamed> Pursuit::undone_at_end() {
  return undone_by_itself(plans_.end_of(modes_, needed_.offers), needed_.wanted, goal_, step_, interpreter_);
}

/// Whether the plan ends with something that the goal rests on elsewhere than the candidate has it. It is needed then.
bool Pursuit::leaves_aside(const Modes& candidate, const Blamed& undone) {
  const Modes end = plans_.end_of(modes_, needed_.offers);
  bool some = false;
  for (const ComponentId c : undone) {
    if (end[c.index()] != candidate[c.index()]) some = rested_on_.insert(c).second || some;
  }
  return some;
}

void Pursuit::need(const Modes& candidate) {
  needed_ = Needed{interpreter_.needed(modes_, candidate, goal_), modes_, {}, std::vector<bool>(modes_.size()), {}};
  const auto take = [&](ComponentId c) {
    needed_.target[c.index()] = candidate[c.index()];
    needed_.wanted[c.index()] = true;
  };
  for (const ComponentId c : needed_.components) take(c);
  // What the goal rests on, so that it lasts, is needed too.
  for (const ComponentId c : rested_on_) {
    if (candidate[c.index()] != needed_.target[c.index()]) needed_.components.push_back(c);
    take(c);
  }
  // What the goal asks for and has is to be there still, or again.
  for (std::size_t c = 0; c < modes_.size(); ++c) {
    needed_.wanted[c] = needed_.wanted[c] || goal_.restricts(ComponentId(c));
  }
  needed_.permitted = prospects_.permitted(needed_.target);
}

/// A goal state that does not last: the first is remembered; nothing where no others are looked for any more.
std::optional<Pursuit::Blamed> Pursuit::lost(const Modes& candidate, Blamed blamed) {
  const auto chosen = [&](ComponentId c) { return needed_.target[c.index()] == candidate[c.index()]; };
  if (!std::all_of(blamed.begin(), blamed.end(), chosen)) {
    blamed.clear();
    for (std::size_t c = 0; c < modes_.size(); ++c) blamed.emplace_back(c);
  }
  const auto effort = prospects_.effort(modes_, candidate);
  any_ = ++passed_ == passing_limit || (passing_ && effort > passing_->effort);
  if (!passing_) passing_ = Passing{candidate, needed_, effort};
  if (any_) return std::nullopt;
  rested_on_.insert(blamed.begin(), blamed.end());
  return blamed;
}

/// What is to blame for a plan that failed.
Pursuit::Blamed Pursuit::blame(const Modes& candidate, std::pair<Impasse, std::size_t> failed) {
  if (!obstacle_) {
    obstacle_ = std::move(failed.first);
    refused_ = candidate;
  }
  Blamed blamed;
  if (++failures_ >= failure_limit) return blamed;
  for (const ComponentId c : needed_.components) {
    if (parts_.of(c) == failed.second) blamed.push_back(c);
  }
  return blamed;
}

/// What the goal is to rest on, and does not ask for, comes first, where that can be.
void Pursuit::lay_ground() {
  Modes target = modes_;
  std::vector<bool> wanted(modes_.size());
  for (std::size_t c = 0; c < modes_.size(); ++c) {
    wanted[c] = goal_.restricts(ComponentId(c)) && modes_[c] == needed_.target[c];
  }
  bool some = false;
  for (const ComponentId c : rested_on_) {
    if (goal_.restricts(c)) continue;
    target[c.index()] = needed_.target[c.index()];
    wanted[c.index()] = true;
    some = some || modes_[c.index()] != needed_.target[c.index()];
  }
  std::vector<Offer> offers;
  if (!some || plans_.plan(modes_, {target, needed_.permitted, 0, wanted}, offers)) return;
  // A way that moves it again is no way from there: the outlet that is to be shut in the end is open while a tank runs
  // down.
  const Planner::Followed rest = plans_.followed(target, {needed_.target, needed_.permitted, 0, needed_.wanted});
  const bool stays = std::none_of(rested_on_.begin(), rested_on_.end(),
                                  [&](ComponentId c) { return !goal_.restricts(c) && rest.moved[c.index()]; });
  if (stays) needed_.offers = std::move(offers);
}

}  // namespace rmpl::runtime
