// The state of a monitor from sample to sample.
// SPDX-License-Identifier: MIT
#include "runtime/telemetry/monitors.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rmpl::runtime {

using automata::Monitor;
using automata::Ticks;
using automata::ValueId;

namespace {

bool is_number(const Sample& sample) { return sample.number && !std::isnan(*sample.number); }

/// Whether the channel says this, to the letter or to the last bit.
bool says(const Sample& sample, const automata::ChannelLiteral& literal) {
  return literal.number ? sample.number == literal.number : sample.text == literal.text;
}

const automata::ChannelLiteral* literal_of(const Monitor& monitor, const Sample& sample) {
  const auto found = std::find_if(monitor.literals.begin(), monitor.literals.end(),
                                  [&](const automata::ChannelLiteral& literal) { return says(sample, literal); });
  return found == monitor.literals.end() ? nullptr : &*found;
}

/// Whether a sample leaves the value as it is.
bool stays(const Monitor& monitor, const Sample& sample, ValueId value) {
  if (const automata::ChannelLiteral* literal = literal_of(monitor, sample)) return literal->value == value;
  return std::any_of(monitor.bands.begin(), monitor.bands.end(), [&](const automata::Band& band) {
    return band.value == value && band.contains(*sample.number, monitor.hysteresis);
  });
}

}  // namespace

std::optional<ValueId> value_of(const Monitor& monitor, const Sample& sample) {
  if (const automata::ChannelLiteral* literal = literal_of(monitor, sample)) return literal->value;
  for (const automata::Band& band : monitor.bands) {
    if (sample.number && band.contains(*sample.number)) return band.value;
  }
  return std::nullopt;
}

Monitors::Monitors(std::vector<Monitor> monitors) : monitors_(std::move(monitors)), states_(monitors_.size()) {
  for (std::size_t m = 0; m < monitors_.size(); ++m) {
    states_[m].channel = add_channel(monitors_[m].channel);
    if (monitors_[m].minus) states_[m].minus = add_channel(*monitors_[m].minus);
  }
  order_.resize(monitors_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::sort(order_.begin(), order_.end(),
            [&](std::size_t a, std::size_t b) { return monitors_[a].attribute < monitors_[b].attribute; });
}

std::uint32_t Monitors::add_channel(const std::string& name) {
  const auto [at, fresh] = by_name_.emplace(name, static_cast<std::uint32_t>(names_.size()));
  if (fresh) {
    names_.push_back(name);
    channels_.emplace_back();
  }
  return at->second;
}

std::optional<std::uint32_t> Monitors::find(std::string_view channel) const {
  const auto found = by_name_.find(channel);
  return found == by_name_.end() ? std::nullopt : std::optional(found->second);
}

void Monitors::take(std::span<const Sample> samples, Ticks time) {
  ++call_;
  for (const Sample& sample : samples) {
    Channel& channel = channels_[sample.channel];
    channel.sample = sample;
    channel.time = time;
    channel.heard = true;
    channel.call = call_;
  }
  for (std::size_t m = 0; m < monitors_.size(); ++m) {
    State& state = states_[m];
    const bool minus = monitors_[m].minus && channels_[state.minus].call == call_;
    if (channels_[state.channel].call == call_ || minus) step(monitors_[m], state, time);
  }
}

/// What a new sample of the monitor's channels does.
void Monitors::step(const Monitor& monitor, State& state, Ticks time) {
  if (monitor.stale && state.last && time - *state.last > *monitor.stale) {
    state.value.reset();  // it was stale before this sample came
    state.outside = 0;
  }
  const Channel& channel = channels_[state.channel];
  if (monitor.minus) {
    const Channel& minus = channels_[state.minus];
    if (!channel.heard || !minus.heard) return;
    if (!is_number(channel.sample)) return refuse(state, state.channel, time);
    if (!is_number(minus.sample)) return refuse(state, state.minus, time);
    const Ticks older = std::min(channel.time, minus.time);
    if (monitor.stale && time - older > *monitor.stale) {
      state.value.reset();
      state.outside = 0;
      state.last = older;
      return;
    }
    const double difference = *channel.sample.number - *minus.sample.number;
    if (std::isnan(difference)) return refuse(state, state.channel, time);
    read(monitor, state, {state.channel, difference, {}}, time);
    state.last = older;
    return;
  }
  if (!monitor.over) {
    const bool understood = is_number(channel.sample) || literal_of(monitor, channel.sample) != nullptr;
    return understood ? read(monitor, state, channel.sample, time) : refuse(state, state.channel, time);
  }
  if (!is_number(channel.sample) || std::isinf(*channel.sample.number)) {
    state.window.clear();
    return refuse(state, state.channel, time);
  }
  state.last = time;
  if (!state.window.empty() && state.window.back().first == time) state.window.pop_back();
  state.window.emplace_back(time, *channel.sample.number);
  while (state.window.size() > 1 && time - state.window[1].first >= *monitor.over) state.window.pop_front();
  const auto& [begin, number] = state.window.front();
  if (time - begin < *monitor.over) return;  // it is not known for so long
  const double rate = (*channel.sample.number - number) / (time - begin).seconds();
  read(monitor, state, {state.channel, rate, {}}, time);
}

void Monitors::read(const Monitor& monitor, State& state, const Sample& signal, Ticks time) {
  state.last = time;
  if (state.value) {
    if (stays(monitor, signal, *state.value)) {
      state.outside = 0;
      return;
    }
    if (state.outside++ == 0) state.outside_since = time;
    if (state.outside < monitor.persist_samples || time - state.outside_since < monitor.persist_time) return;
  }
  state.outside = 0;
  state.value = value_of(monitor, signal);
}

/// What is no number, and none of the texts, counts as stale.
void Monitors::refuse(State& state, std::uint32_t channel, Ticks time) {
  state.value.reset();
  state.outside = 0;
  state.last.reset();
  Channel& of = channels_[channel];
  if (of.told) return;
  of.told = true;
  remarks_.push_back("channel \"" + names_[channel] + "\": \"" + of.sample.text + "\" at " +
                     automata::format_seconds(time) + " s is no number" +
                     (of.sample.number ? "" : ", and none of the texts") + " that the monitors know");
}

automata::Observation Monitors::readings(Ticks now) const {
  automata::Observation observation;
  for (const std::size_t m : order_) {
    const Monitor& monitor = monitors_[m];
    const State& state = states_[m];
    const bool stale = monitor.stale && state.last && now - *state.last > *monitor.stale;
    if (state.value && !stale) observation.push_back({monitor.attribute, *state.value});
  }
  return observation;
}

bool Monitors::speak_of(automata::VariableId attribute) const {
  for (std::size_t m = 0; m < monitors_.size(); ++m) {
    if (monitors_[m].attribute != attribute) continue;
    if (channels_[states_[m].channel].heard || (monitors_[m].minus && channels_[states_[m].minus].heard)) return true;
  }
  return false;
}

std::vector<std::string> Monitors::take_remarks() { return std::exchange(remarks_, {}); }

std::vector<std::string> Monitors::silent() const {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    if (!channels_[c].heard) names.push_back(names_[c]);
  }
  return names;
}

}  // namespace rmpl::runtime
