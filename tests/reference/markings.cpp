// Every start of a cycle, with every end of it.
// SPDX-License-Identifier: MIT
#include "tests/reference/markings.hpp"

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
/// Marking, what is known, what the clocks read.
using Start = std::tuple<std::set<LocationId>, std::size_t, Readings>;

class Explorer {
 public:
  Explorer(const automata::Program& program, const automata::Plant& plant, const std::vector<Ticks>& readings)
      : models_(plant), sequencer_(program, models_), readings_(readings) {
    for (const World* world : models_.matching({})) {
      Known known;
      for (std::size_t v = 0; v < world->size(); ++v) known.push_back({automata::VariableId(v), (*world)[v]});
      known_.push_back(std::move(known));
    }
  }

  std::optional<MarkingsFound> run(std::size_t limit) {
    for (std::size_t k = 0; k < known_.size(); ++k) add({sequencer_.marking(), k, {}}, 1);
    while (!pending_.empty()) {
      if (seen_.size() > limit) return std::nullopt;
      const auto [start, cycle] = pending_.front();
      pending_.pop_front();
      follow(start, cycle);
    }
    return found_;
  }

 private:
  static constexpr Ticks now() { return Ticks::of_seconds(1000); }

  void add(Start start, std::size_t cycle) {
    found_.marked.insert(std::get<0>(start).begin(), std::get<0>(start).end());
    if (!std::get<0>(start).empty() && seen_.insert(start).second) pending_.emplace_back(std::move(start), cycle);
  }

  Sequencer::Goal begin(const Start& start) {
    std::map<ClockId, Ticks> started;
    for (const auto& [clock, reading] : std::get<2>(start)) started.emplace(clock, now() - readings_[reading]);
    sequencer_.resume(std::get<0>(start), std::move(started));
    return sequencer_.begin(known_[std::get<1>(start)], now());
  }

  void follow(const Start& start, std::size_t cycle) {
    if (begin(start).contradictory && !found_.contradiction) found_.contradiction = cycle;
    for (std::size_t k = 0; k < known_.size(); ++k) {
      begin(start);
      sequencer_.finish(known_[k]);
      Readings least;
      for (const auto& [clock, when] : sequencer_.started()) {
        const auto before = std::get<2>(start).find(clock);
        least[clock] = when == now() || before == std::get<2>(start).end() ? 0 : before->second;
      }
      add_readings({sequencer_.marking(), k, least}, least.begin(), least, cycle + 1);
    }
  }

  void add_readings(Start start, Readings::const_iterator next, const Readings& least, std::size_t cycle) {
    if (next == least.end()) return add(std::move(start), cycle);
    for (std::size_t r = next->second; r < readings_.size(); ++r) {
      std::get<2>(start)[next->first] = r;
      add_readings(start, std::next(next), least, cycle);
    }
  }

  Models models_;
  Sequencer sequencer_;
  const std::vector<Ticks>& readings_;
  std::vector<Known> known_;
  std::set<Start> seen_;
  std::deque<std::pair<Start, std::size_t>> pending_;
  MarkingsFound found_;
};

}  // namespace

std::optional<MarkingsFound> all_markings(const automata::Program& program, const automata::Plant& plant,
                                          const std::vector<Ticks>& readings, std::size_t limit) {
  return Explorer(program, plant, readings).run(limit);
}

}  // namespace rmpl::reference
