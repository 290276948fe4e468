// Every start of a cycle, with every end of it.
// SPDX-License-Identifier: MIT
#include "tests/reference/markings.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <tuple>
#include <utility>

#include "tests/reference/sequencer.hpp"

namespace rmpl::reference {

using automata::Assignment;
using automata::ClockId;
using automata::LocationId;
using automata::Ticks;

namespace {

using Known = std::vector<Assignment>;
using Readings = std::map<ClockId, std::size_t>;
/// Marking, what is known, what the clocks read; the stage; the groups of clocks that were started together, in order.
using Start = std::tuple<std::set<LocationId>, std::size_t, Readings, std::size_t, std::vector<std::set<ClockId>>>;

class Explorer {
 public:
  Explorer(const automata::Program& program, const automata::Plant& plant, const std::vector<Ticks>& readings,
           const std::vector<ModesByComponent>& stages)
      : plant_(plant), models_(plant), sequencer_(program, models_), readings_(readings), stages_(stages) {
    for (const World* world : models_.matching({})) {
      Known known;
      for (std::size_t v = 0; v < world->size(); ++v) known.push_back({automata::VariableId(v), (*world)[v]});
      known_.push_back(std::move(known));
    }
  }

  std::optional<MarkingsFound> run(std::size_t limit) {
    for (std::size_t k = 0; k < known_.size(); ++k) {
      if (may_be(k, 0)) add({sequencer_.marking(), k, {}, 0, {}}, 1);
    }
    while (!pending_.empty()) {
      if (seen_.size() > limit) return std::nullopt;
      const auto [start, cycle] = pending_.front();
      pending_.pop_front();
      follow(start, cycle);
    }
    return found_;
  }

 private:
  bool may_be(std::size_t known, std::size_t stage) const {
    if (stages_.empty()) return true;
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      const auto mode = known_[known][plant_.components[c].mode.index()].value;
      if (!stages_[stage][c].count(automata::ModeId(mode.index()))) return false;
    }
    return true;
  }

  static constexpr Ticks now() { return Ticks::of_seconds(1000); }

  void add(Start start, std::size_t cycle) {
    found_.marked.insert(std::get<0>(start).begin(), std::get<0>(start).end());
    if (!std::get<0>(start).empty() && seen_.insert(start).second) pending_.emplace_back(std::move(start), cycle);
  }

  /// Whether the goals of the cycle contradict each other.
  bool begin(const Start& start) {
    std::map<ClockId, Ticks> started;
    for (const auto& [clock, reading] : std::get<2>(start)) started.emplace(clock, now() - readings_[reading]);
    sequencer_.resume(std::get<0>(start), std::move(started));
    const auto goals = sequencer_.begin(known_[std::get<1>(start)], now());
    return std::any_of(goals.begin(), goals.end(), [](const Sequencer::Goal& goal) { return goal.contradictory; });
  }

  void follow(const Start& start, std::size_t cycle) {
    if (begin(start) && !found_.contradiction) found_.contradiction = cycle;
    const std::size_t next = std::get<3>(start) + 1 < stages_.size() ? std::get<3>(start) + 1 : std::get<3>(start);
    for (std::size_t k = 0; k < known_.size(); ++k) {
      if (!may_be(k, next)) continue;
      begin(start);
      sequencer_.finish(known_[k]);
      Readings least;
      for (const auto& [clock, when] : sequencer_.started()) {
        const auto before = std::get<2>(start).find(clock);
        least[clock] = when == now() || before == std::get<2>(start).end() ? 0 : before->second;
      }
      add_readings({sequencer_.marking(), k, least, next, by_start(std::get<4>(start))}, least.begin(), least,
                   cycle + 1);
    }
  }

  std::vector<std::set<ClockId>> by_start(const std::vector<std::set<ClockId>>& before) const {
    std::vector<std::set<ClockId>> after;
    std::set<ClockId> fresh;
    for (const auto& [clock, when] : sequencer_.started()) {
      if (when == now()) fresh.insert(clock);
    }
    for (const std::set<ClockId>& group : before) {
      std::set<ClockId> left;
      for (const ClockId clock : group) {
        if (sequencer_.started().count(clock) && !fresh.count(clock)) left.insert(clock);
      }
      if (!left.empty()) after.push_back(left);
    }
    if (!fresh.empty()) after.push_back(fresh);
    return after;
  }

  /// Clocks that were started together read the same, those that were started earlier more; a reading between two whole
  /// seconds stands for all of these.
  bool can_be_read(const Readings& read, const std::vector<std::set<ClockId>>& groups) const {
    const auto whole = [&](std::size_t r) { return readings_[r].count % Ticks::per_second == 0; };
    for (std::size_t early = 0; early < groups.size(); ++early) {
      for (std::size_t late = early; late < groups.size(); ++late) {
        for (const ClockId a : groups[early]) {
          for (const ClockId b : groups[late]) {
            const std::size_t x = read.at(a), y = read.at(b);
            if (early == late ? x != y : x < y || (x == y && whole(x))) return false;
          }
        }
      }
    }
    return true;
  }

  void add_readings(Start start, Readings::const_iterator next, const Readings& least, std::size_t cycle) {
    if (next == least.end()) {
      if (can_be_read(std::get<2>(start), std::get<4>(start))) add(std::move(start), cycle);
      return;
    }
    for (std::size_t r = next->second; r < readings_.size(); ++r) {
      std::get<2>(start)[next->first] = r;
      add_readings(start, std::next(next), least, cycle);
    }
  }

  const automata::Plant& plant_;
  Models models_;
  Sequencer sequencer_;
  const std::vector<Ticks>& readings_;
  const std::vector<ModesByComponent>& stages_;
  std::vector<Known> known_;
  std::set<Start> seen_;
  std::deque<std::pair<Start, std::size_t>> pending_;
  MarkingsFound found_;
};

}  // namespace

std::optional<MarkingsFound> all_markings(const automata::Program& program, const automata::Plant& plant,
                                          const std::vector<Ticks>& readings, std::size_t limit,
                                          const std::vector<ModesByComponent>& stages) {
  return Explorer(program, plant, readings, stages).run(limit);
}

namespace {

/// With what is reached in one step more.
ModesByComponent grown(const automata::Plant& plant, const Models& models, const ModesByComponent& before) {
  std::vector<automata::Formula> among;
  for (std::size_t c = 0; c < before.size(); ++c) {
    std::vector<automata::Formula> modes;
    for (const automata::ModeId m : before[c])
      modes.push_back(is(plant.components[c].mode, automata::ValueId(m.index())));
    among.push_back(automata::disjunction(std::move(modes)));
  }
  ModesByComponent after = before;
  for (std::size_t c = 0; c < before.size(); ++c) {
    for (const automata::Transition& transition : plant.components[c].transitions) {
      if (!before[c].count(transition.from)) continue;
      const Assignment from{plant.components[c].mode, automata::ValueId(transition.from.index())};
      std::vector<automata::Formula> parts = among;
      parts.push_back(transition.guard);
      if (models.allows({from}, automata::conjunction(std::move(parts)))) after[c].insert(transition.to);
    }
  }
  return after;
}

}  // namespace

std::vector<ModesByComponent> modes_by_cycle(const automata::Plant& plant) {
  const Models models(plant);
  ModesByComponent modes(plant.components.size());
  for (std::size_t c = 0; c < modes.size(); ++c) {
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
      if (plant.components[c].initial[m] > 0) modes[c].insert(automata::ModeId(m));
    }
  }
  std::vector<ModesByComponent> result{modes, grown(plant, models, modes)};
  for (ModesByComponent more = result.back(); more != modes; more = grown(plant, models, modes)) modes = more;
  result.push_back(modes);
  return result;
}

}  // namespace rmpl::reference
