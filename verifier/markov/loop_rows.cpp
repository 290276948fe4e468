// What states of the closed loop lead to, and which of them count as one.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "base/product.hpp"
#include "verifier/markov/loop_process.hpp"

namespace rmpl::verifier {

using automata::Modes;

namespace {

/// What is so likely to come next is looked at before components are joined.
constexpr Real looked_at = 1e-3L;
/// Parts of rows are worked out for outcomes that are so much less likely than is asked for.
constexpr Real finer_in_rows = 8;

}  // namespace

std::optional<LoopProcess::Cycles> LoopProcess::cycles_of(const std::vector<LoopStateId>& places,
                                                          const std::vector<Units>& ages) {
  Cycles result;
  for (const LoopStateId place : places) result.push_back(cycles_.at(place));
  const LoopCycles::Cycle* const first = result.front();
  for (const LoopCycles::Cycle* const cycle : result) {
    if ((cycle == nullptr) != (first == nullptr)) return std::nullopt;
    for (std::size_t c = 0; c < ages.size() && cycle != nullptr; ++c) {
      if (ages[c] == joined) {
        const auto faults = cycle->draws.faults(c);
        if (!faults || faults != first->draws.faults(c)) return std::nullopt;
      } else if (cycle != first && !cycle->draws.enables_as(first->draws, c)) {
        return std::nullopt;
      }
    }
  }
  return result;
}

Joins::Spot LoopProcess::spot(std::size_t component, const State& state) {
  const LoopState& here = loop_[state.places.front()];
  ListNumbers::List list{static_cast<std::uint32_t>(component)};
  for (std::size_t c = 0; c < here.modes.size(); ++c) {
    const bool told = c != component && state.ages[c] != joined;
    list.push_back(told ? here.modes[c].value : ~std::uint32_t{0});
  }
  for (const automata::LocationId location : here.marking) list.push_back(static_cast<std::uint32_t>(location.index()));
  return joins_.spot(list);
}

std::vector<std::size_t> LoopProcess::to_join(const State& state, const Cycles& cycles) {
  std::vector<std::size_t> result;
  if (!joins_wanted_) return result;
  for (std::size_t c = 0; c < state.ages.size(); ++c) {
    if (state.ages[c] == joined) continue;
    const StepDraws& draws = cycles.front()->draws;
    if (draws.decides(c, state.ages[c]) && draws.faults(c) && !joins_.is_barred(spot(c, state))) result.push_back(c);
  }
  return result;
}

std::vector<Modes> LoopProcess::alternatives(const Cycles& cycles, std::size_t place, const std::vector<Units>& ages,
                                             const Modes& drawn) const {
  std::vector<Modes> result{drawn};
  for (std::size_t c = 0; c < ages.size(); ++c) {
    if (ages[c] != joined || drawn[c] != cycles.front()->draws.nominal(c).front()) continue;
    std::vector<Modes> longer;
    for (const Modes& modes : result) {
      for (const automata::ModeId mode : cycles[place]->draws.nominal(c)) {
        longer.push_back(modes);
        longer.back()[c] = mode;
      }
    }
    result = std::move(longer);
  }
  return result;
}

std::optional<LoopProcess::Next> LoopProcess::next(const State& state, const Cycles& cycles,
                                                   const std::vector<Units>& ages, const Modes& drawn) {
  Next result;
  result.clocks_unknown.assign(ages.size(), false);
  std::vector<std::optional<automata::ModeId>> modes_then(ages.size());
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const Modes here = loop_[state.places[i]].modes;
    for (const Modes& modes : alternatives(cycles, i, ages, drawn)) {
      const Follower& follower = cycles[i]->followers.at(modes);
      if (!result.places.empty()) {
        const LoopState& one = loop_[result.places.front()];
        const LoopState& other = loop_[follower.loop];
        if (one.marking != other.marking || one.passed != other.passed || one.groups != other.groups ||
            *result.sources != follower.sources || walked_.wanted(one.modes) != walked_.wanted(other.modes)) {
          return std::nullopt;
        }
      }
      result.sources = &follower.sources;
      result.places.push_back(follower.loop);
      for (std::size_t c = 0; c < ages.size(); ++c) {
        if (ages[c] != joined) continue;
        const bool anew = modes[c] != here[c] || cycles[i]->restarted[c];
        const bool same = !modes_then[c] || *modes_then[c] == modes[c];
        modes_then[c] = modes[c];
        const bool known = anew || ages_.left(c, modes[c], 0) == 0;
        if (!same || !known) result.clocks_unknown[c] = true;
      }
    }
  }
  std::sort(result.places.begin(), result.places.end());
  result.places.erase(std::unique(result.places.begin(), result.places.end()), result.places.end());
  result.wanted = walked_.wanted(loop_[result.places.front()].modes);
  return result;
}

Branch LoopProcess::branch_to(const State& state, const Cycles& cycles, const Next& next, const Enclosure& probability,
                              unsigned faults) {
  const auto apart_before = [&state](std::size_t group) {
    return static_cast<std::size_t>(
        std::count(state.readings.begin(), state.readings.begin() + static_cast<std::ptrdiff_t>(group), kept_apart));
  };
  // A long clock is taken to read what it may in its cell; `follow` sees to the bound.
  std::vector<Units> readings;
  std::vector<std::optional<std::size_t>> from(next.sources->size());
  for (std::size_t g = 0; g < next.sources->size(); ++g) {
    const std::size_t source = (*next.sources)[g];
    if (source == 0) {
      readings.push_back(1);
    } else if (state.readings[source - 1] != kept_apart) {
      readings.push_back(state.readings[source - 1] + 1);
    } else {
      readings.push_back(cycles_.cells(next.places.front())[g].lower);
      from[g] = apart_before(source - 1);
    }
  }
  std::size_t clock = apart_before(state.readings.size());
  std::vector<Units> ages;
  Passage of_components;
  const Modes& here = loop_[state.places.front()].modes;
  const Modes& then = loop_[next.places.front()].modes;
  for (std::size_t c = 0; c < state.ages.size(); ++c) {
    const bool apart = state.ages[c] == kept_apart;
    const bool restarted = cycles.front()->restarted[c];
    if (next.clocks_unknown[c]) {
      ages.push_back(joined);
    } else if (state.ages[c] == joined) {
      ages.push_back(ages_.entered(c, then[c]));
    } else {
      ages.push_back(ages_.after(c, here[c], state.ages[c], then[c], restarted));
    }
    if (ages.back() == kept_apart) {
      const bool goes_on = apart && !restarted && then[c] == here[c];
      of_components.push_back(goes_on ? Source{clock, 0} : Source{std::nullopt, 0});
    }
    if (apart) ++clock;
  }
  std::vector<std::size_t> apart;
  const StateNumber to = enter(next.places, readings, std::move(ages), state.faults + faults, apart);
  if (states_[to].places.empty()) return {to, probability, number({}, clock)};
  Passage passage;
  for (const std::size_t g : apart) passage.push_back({from[g], from[g] ? 0 : readings[g]});
  passage.insert(passage.end(), of_components.begin(), of_components.end());
  return {to, probability, number(passage, clock)};
}

LoopProcess::Part LoopProcess::work_out(const Cycles& cycles, const std::vector<Units>& ages, const Modes& timed,
                                        const LeftOut& left_out) {
  std::vector<bool> joined_ones;
  joined_ones.reserve(ages.size());
  for (const Units age : ages) joined_ones.push_back(age == joined);
  Draws drawn = cycles.front()->draws.part(timed, joined_ones, left_out, meter_);
  Part result;
  result.less_likely_than = left_out.less_likely_than;
  result.impossible = !drawn.impossible.empty();
  const auto differs = [&](const Modes& modes, bool possible, Prospect& prospect) {
    for (std::size_t i = 0; i < cycles.size(); ++i) {
      for (const Modes& own : alternatives(cycles, i, ages, modes)) {
        if (step_.possible(own) != possible) return true;
        prospect = prospect | prospect_of(walked_, own);
      }
    }
    return false;
  };
  for (const Modes& modes : drawn.impossible) {
    Prospect none;
    result.differs = result.differs || differs(modes, false, none);
  }
  for (Draw& draw : drawn.outcomes) {
    Prospect prospect{0, 0};
    result.differs = result.differs || differs(draw.modes, true, prospect);
    result.outcomes.push_back({std::move(draw), prospect, prospect.within(walked_.steps), false, std::nullopt});
  }
  result.rest.assign(result.outcomes.size() + 1, drawn.left_out);
  for (std::size_t i = result.outcomes.size(); i-- > 0;) {
    result.rest[i] = rounding::up(result.rest[i + 1] + result.outcomes[i].draw.probability.upper, 1);
  }
  return result;
}

LoopProcess::Part& LoopProcess::part(const State& state, const Cycles& cycles, const std::vector<Units>& ages,
                                     const Modes& timed, const LeftOut& left_out) {
  ListNumbers::List list{static_cast<std::uint32_t>(state.places.size()), state.faults};
  for (const LoopStateId place : state.places) list.push_back(static_cast<std::uint32_t>(place.index()));
  for (std::size_t c = 0; c < ages.size(); ++c) {
    if (ages[c] == joined) {
      list.push_back(static_cast<std::uint32_t>(c));
    } else if (cycles.front()->draws.is_timed(c)) {
      list.push_back(static_cast<std::uint32_t>(ages.size() + c));
      list.push_back(timed[c].value);
    }
  }
  const std::uint32_t number = part_numbers_.number(list);
  if (number == parts_.size()) parts_.emplace_back();
  std::unique_ptr<Part>& known = parts_[number];
  if (known == nullptr || known->less_likely_than > left_out.less_likely_than) {
    LeftOut finer = left_out;
    finer.less_likely_than /= finer_in_rows;
    known = std::make_unique<Part>(work_out(cycles, ages, timed, finer));
  }
  return *known;
}

void LoopProcess::find_next(const State& state, const Cycles& cycles, const std::vector<Units>& ages,
                            const std::vector<Outcome*>& outcomes) {
  if (outcomes.empty()) return;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    std::vector<Modes> modes;
    for (const Outcome* const outcome : outcomes) {
      for (Modes& own : alternatives(cycles, i, ages, outcome->draw.modes)) modes.push_back(std::move(own));
    }
    cycles_.follow(state.places[i], *cycles[i], modes);
  }
  for (Outcome* const outcome : outcomes) {
    outcome->followed = true;
    outcome->next = next(state, cycles, ages, outcome->draw.modes);
  }
}

std::optional<Row> LoopProcess::row(const State& state, const Cycles& cycles, const std::vector<Units>& ages,
                                    const LeftOut& left_out, Real less_likely_than) {
  const StepDraws& draws = cycles.front()->draws;
  std::vector<std::vector<DrawOption>> options;
  std::vector<std::size_t> timed;
  for (std::size_t c = 0; c < ages.size(); ++c) {
    if (ages[c] == joined || !draws.is_timed(c)) continue;
    timed.push_back(c);
    options.push_back(draws.options(c, ages[c]));
  }
  Row result;
  Enclosure listed;
  bool impossible = false;
  bool differs = false;
  struct Followed {
    Outcome* outcome;
    Enclosure probability;
  };
  std::vector<Followed> followed;
  std::vector<Outcome*> unknown;
  Modes modes = loop_[state.places.front()].modes;
  base::for_each_combination(options, [&](const std::vector<DrawOption>& chosen) {
    Enclosure share = certain();
    for (std::size_t i = 0; i < timed.size(); ++i) {
      share = share * chosen[i].probability;
      modes[timed[i]] = chosen[i].mode;
    }
    if (share.upper < left_out.less_likely_than) {
      result.left_out = rounding::up(result.left_out + share.upper, 1);
      return;
    }
    LeftOut own = left_out;
    own.less_likely_than = left_out.less_likely_than / share.upper;
    Part& part = this->part(state, cycles, ages, modes, own);
    impossible = impossible || part.impossible;
    differs = differs || part.differs;
    std::size_t at = 0;
    for (; at < part.outcomes.size(); ++at) {
      Outcome& outcome = part.outcomes[at];
      const Enclosure probability = share * outcome.draw.probability;
      if (probability.upper < left_out.less_likely_than) break;
      listed = listed + probability;
      if (probability.upper * outcome.worth < less_likely_than) {
        result.foreseen.add(probability.upper, outcome.prospect);
        continue;
      }
      followed.push_back({&outcome, probability});
      if (!outcome.followed) unknown.push_back(&outcome);
    }
    result.left_out = rounding::up(result.left_out + share.upper * part.rest[at], 2);
  });
  if (differs) return std::nullopt;
  find_next(state, cycles, ages, unknown);
  Enclosure all = certain();
  if (impossible || result.left_out > 0) {
    // Each outcome is a part of what is possible.
    all = {listed.lower, std::min<Real>(rounding::up(listed.upper + result.left_out, 1), 1)};
    if (all.lower == 0) {
      // Nothing is known of how likely what is listed is.
      const bool nothing = listed.upper == 0 && result.left_out == 0;
      return Row{{}, nothing ? Real{0} : Real{1}};
    }
    result.left_out = std::min<Real>(rounding::up(result.left_out / all.lower, 1), 1);
    Prospect scaled{0, 0};
    scaled.add(rounding::up(1 / all.lower, 1), result.foreseen);
    result.foreseen = scaled;
  }
  const bool fresh = ages != state.ages;
  Enclosure end;
  result.edges.reserve(followed.size());
  for (const Followed& one : followed) {
    if (!one.outcome->next) return std::nullopt;
    const Enclosure probability = as_probability(one.probability / all);
    if (one.outcome->next->wanted) {
      end = end + probability;
      continue;
    }
    const Branch branch = branch_to(state, cycles, *one.outcome->next, probability, one.outcome->draw.faults);
    const bool look = fresh && one.probability.upper >= looked_at && !states_[branch.to].places.empty();
    if (look && !cycles_of(states_[branch.to].places, states_[branch.to].ages)) return std::nullopt;
    result.edges.push_back(branch);
  }
  if (end.upper > 0) result.edges.push_back({enter_end(), as_probability(end), number({}, state.longest.size())});
  std::stable_sort(result.edges.begin(), result.edges.end(),
                   [](const Branch& a, const Branch& b) { return a.probability.upper > b.probability.upper; });
  note_joined(state, ages, result);
  return result;
}

void LoopProcess::note_joined(const State& state, const std::vector<Units>& ages, const Row& row) {
  for (std::size_t c = 0; c < ages.size(); ++c) {
    if (ages[c] != joined) continue;
    const Joins::Spot here = spot(c, state);
    for (const Branch& branch : row.edges) {
      if (states_[branch.to].places.empty()) continue;
      if (states_[branch.to].ages[c] == joined) joins_.leads(here, spot(c, states_[branch.to]));
    }
  }
}

const std::vector<Row>& LoopProcess::rows(StateNumber number_of_state, Real less_likely_than) {
  rows_.clear();
  if (states_[number_of_state].places.empty()) {
    leave_steady(number_of_state);
    return rows_;
  }
  const State state = states_[number_of_state];
  LeftOut left_out = walked_.left_out;
  left_out.less_likely_than = std::max(left_out.less_likely_than, less_likely_than / many_steps);
  if (left_out.faults_beyond) *left_out.faults_beyond -= state.faults;
  const std::optional<Cycles> cycles = cycles_of(state.places, state.ages);
  if (cycles) {
    if (cycles->front() == nullptr) return rows_;
    std::vector<std::size_t> fresh = to_join(state, *cycles);
    std::vector<Units> ages = state.ages;
    for (const std::size_t c : fresh) ages[c] = joined;
    for (;;) {
      if (std::optional<Row> found = row(state, *cycles, ages, left_out, less_likely_than)) {
        rows_.push_back(std::move(*found));
        return rows_;
      }
      if (fresh.empty()) break;
      joins_.bar(spot(fresh.back(), state));
      ages[fresh.back()] = state.ages[fresh.back()];
      fresh.pop_back();
    }
  }
  for (std::size_t c = 0; c < state.ages.size(); ++c) {
    if (state.ages[c] == joined) joins_.fails(spot(c, state));
  }
  rows_.push_back({{}, 0, state.prospect});
  rows_.back().foreseen.once = rounding::up(state.prospect.once + state.prospect.each_step, 1);
  return rows_;
}

}  // namespace rmpl::verifier
