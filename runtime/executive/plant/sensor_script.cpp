// When each dictated reading begins and ends.
// SPDX-License-Identifier: MIT
#include "runtime/executive/plant/sensor_script.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "automata/controls.hpp"
#include "automata/time/checked_ticks.hpp"
#include "base/error.hpp"

namespace rmpl::runtime {
namespace {

using automata::Ticks;

/// Saturates: a reading "for ever" ends at infinity.
Ticks later(Ticks time, Ticks by) { return automata::checked_sum(time, by).value_or(Ticks::infinite()); }

/// From the trigger of a rule, at the start of a cycle, to its reading, at the end of that cycle or of a later one:
/// nothing is read before. Saturates.
Ticks delay_of(const automata::Rule& rule, Ticks cycle) {
  if (rule.delay) return *rule.delay;
  const std::uint64_t cycles = std::max<std::uint64_t>(rule.delay_cycles, 1);
  return automata::checked_product(cycle, cycles).value_or(Ticks::infinite());
}

}  // namespace

SensorScript::SensorScript(const automata::Plant& plant, const automata::Scenario& scenario)
    : plant_(plant), cycle_(scenario.cycle), monitors_(scenario.monitors) {
  std::size_t order = 0;
  for (const automata::SensorOverride& dictated : scenario.overrides) {
    schedule({dictated.at, later(dictated.at, dictated.duration), order++, dictated.reading});
  }
  for (const automata::Rule& rule : scenario.rules) triggers_.push_back({&rule, order++});
  for (const automata::ChannelSample& given : scenario.samples) {
    const auto channel = monitors_.find(given.channel);
    if (!channel) {
      throw base::InputError(to_text(given.origin) + ": no monitor reads channel \"" + given.channel + "\"");
    }
    samples_.push_back({given.at, given.number ? Sample::of_number(*channel, *given.number, given.text)
                                               : Sample::of_text(*channel, given.text)});
  }
  std::stable_sort(samples_.begin(), samples_.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
}

void SensorScript::schedule(Reading reading) {
  const auto begins_later = [](const Reading& a, const Reading& b) {
    return std::tie(a.from, a.order) > std::tie(b.from, b.order);
  };
  pending_.insert(std::upper_bound(pending_.begin(), pending_.end(), reading, begins_later), reading);
}

template <class ValueOf>
void SensorScript::fire(automata::Rule::Stream stream, const ValueOf& value_of, Ticks now) {
  for (Trigger& trigger : triggers_) {
    const automata::Rule& rule = *trigger.rule;
    if (rule.stream != stream) continue;
    const bool holds = automata::evaluate(rule.trigger, value_of);
    if (holds && !trigger.held) {
      const Ticks from = later(now, delay_of(rule, cycle_));
      schedule({from, later(from, rule.duration), trigger.order, rule.reading});
    }
    trigger.held = holds;
  }
}

void SensorScript::hear_command(const automata::ControlAction& action, Ticks now) {
  if (action == last_action_) return;
  last_action_ = action;
  fire(
      automata::Rule::Stream::command,
      [&](automata::VariableId variable) { return action[*automata::control_of(plant_, variable)]; }, now);
}

void SensorScript::hear_estimate(const automata::Modes& modes, Ticks now) {
  if (modes == last_modes_) return;
  last_modes_ = modes;
  fire(
      automata::Rule::Stream::estimate,
      [&](automata::VariableId variable) {
        return automata::ValueId(modes[plant_.component_of(variable)->index()].index());
      },
      now);
}

void SensorScript::begin(const Reading& reading) {
  // What ends no later is never heard again.
  std::erase_if(active_, [&](const Reading& known) {
    return known.reading.variable == reading.reading.variable && known.until <= reading.until;
  });
  active_.push_back(reading);
}

/// Each sample counts at its own time, those of one time together.
void SensorScript::take_samples(Ticks now) {
  heard_.clear();
  while (next_sample_ < samples_.size() && samples_[next_sample_].at <= now) {
    const Ticks time = samples_[next_sample_].at;
    const std::size_t first = heard_.size();
    for (; next_sample_ < samples_.size() && samples_[next_sample_].at == time; ++next_sample_)
      heard_.push_back(samples_[next_sample_].sample);
    monitors_.take(std::span(heard_).subspan(first), time);
  }
}

void SensorScript::apply_monitors(automata::Observation& observation, Ticks now) const {
  if (next_sample_ == 0) return;
  std::erase_if(observation, [&](const automata::Assignment& read) { return monitors_.speak_of(read.variable); });
  const automata::Observation readings = monitors_.readings(now);
  observation.insert(observation.end(), readings.begin(), readings.end());
  std::sort(observation.begin(), observation.end());
}

void SensorScript::add_remarks(std::vector<Event>& happenings) {
  for (std::string& remark : monitors_.take_remarks())
    happenings.push_back({Event::Kind::refused, std::move(remark), std::nullopt, std::nullopt});
}

void SensorScript::apply(automata::Observation& observation, Ticks now) {
  take_samples(now);
  apply_monitors(observation, now);
  for (; !pending_.empty() && pending_.back().from <= now; pending_.pop_back()) begin(pending_.back());
  std::erase_if(active_, [now](const Reading& known) { return known.until <= now; });
  for (const Reading& known : active_) {
    const auto at =
        std::lower_bound(observation.begin(), observation.end(), known.reading.variable,
                         [](const automata::Assignment& a, automata::VariableId id) { return a.variable < id; });
    if (at != observation.end() && at->variable == known.reading.variable) {
      at->value = known.reading.value;
    } else {
      observation.insert(at, known.reading);
    }
  }
}

}  // namespace rmpl::runtime
