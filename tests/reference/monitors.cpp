// Every question goes back to the start of the log.
// SPDX-License-Identifier: MIT
#include "tests/reference/monitors.hpp"

#include <algorithm>
#include <cmath>

namespace rmpl::reference {
namespace {

using automata::Band;
using automata::Monitor;
using automata::Ticks;
using automata::ValueId;

/// What a monitor gets to see at one time.
struct Signal {
  Ticks time;   ///< at which it came
  Ticks since;  ///< from which it grows old
  bool understood = false;
  bool reset = false;  ///< it is stale as it comes
  std::optional<double> number;
  std::string text;
};

bool is_number(const ChannelSaid& said) { return said.number && !std::isnan(*said.number); }

std::vector<Signal> signals_of(const Monitor& monitor, const std::vector<ChannelSaid>& samples) {
  std::vector<Signal> signals;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const ChannelSaid& said = samples[s];
    const bool own = said.channel == monitor.channel;
    const bool minus = monitor.minus == said.channel;
    if (!own && !minus) continue;
    const auto last_of = [&](const std::string& channel) {
      const ChannelSaid* found = nullptr;
      for (std::size_t i = 0; i <= s; ++i) {
        if (samples[i].channel == channel) found = &samples[i];
      }
      return found;
    };
    Signal signal{said.time, said.time, false, false, std::nullopt, {}};
    if (monitor.minus) {
      const ChannelSaid* one = last_of(monitor.channel);
      const ChannelSaid* other = last_of(*monitor.minus);
      if (one == nullptr || other == nullptr) continue;
      signal.understood = is_number(*one) && is_number(*other) && !std::isnan(*one->number - *other->number);
      if (signal.understood) signal.number = *one->number - *other->number;
      signal.since = std::min(one->time, other->time);
      signal.reset = signal.understood && monitor.stale && said.time - signal.since > *monitor.stale;
    } else if (monitor.over) {
      signal.understood = is_number(said) && !std::isinf(*said.number);
      if (signal.understood) {
        // The newest sample of the channel that is so old; nothing counts from before one that was no number.
        const ChannelSaid* base = nullptr;
        for (std::size_t i = 0; i <= s; ++i) {
          if (samples[i].channel != monitor.channel) continue;
          if (!is_number(samples[i]) || std::isinf(*samples[i].number)) {
            base = nullptr;
          } else if (said.time - samples[i].time >= *monitor.over) {
            base = &samples[i];
          }
        }
        if (base != nullptr) signal.number = (*said.number - *base->number) / (said.time - base->time).seconds();
      }
    } else {
      signal.number = is_number(said) ? said.number : std::nullopt;
      signal.text = said.text;
      signal.understood =
          is_number(said) || std::any_of(monitor.literals.begin(), monitor.literals.end(),
                                         [&](const auto& l) { return !l.number && l.text == said.text; });
    }
    signals.push_back(signal);
  }
  return signals;
}

std::optional<ValueId> literal(const Monitor& monitor, const Signal& signal) {
  for (const auto& one : monitor.literals) {
    if (one.number ? signal.number && *signal.number == *one.number : signal.text == one.text) return one.value;
  }
  return std::nullopt;
}

bool within(const Band& band, double number, double margin) {
  const bool above = band.open_from ? number > band.from - margin : number >= band.from - margin;
  const bool below = band.open_to ? number < band.to + margin : number <= band.to + margin;
  return above && below;
}

std::optional<ValueId> said_by(const Monitor& monitor, const Signal& signal) {
  if (const auto value = literal(monitor, signal)) return value;
  for (const Band& band : monitor.bands) {
    if (within(band, *signal.number, 0)) return band.value;
  }
  return std::nullopt;
}

bool leaves(const Monitor& monitor, const Signal& signal, ValueId value) {
  if (const auto exact = literal(monitor, signal)) return *exact != value;
  return std::none_of(monitor.bands.begin(), monitor.bands.end(), [&](const Band& band) {
    return band.value == value && within(band, *signal.number, monitor.hysteresis);
  });
}

/// The value after signal i.
std::optional<ValueId> value_after(const Monitor& monitor, const std::vector<Signal>& signals, std::size_t i) {
  std::vector<std::optional<ValueId>> after(i + 1);
  std::vector<bool> fresh(i + 1, false);  // whether the value was said by this very signal
  for (std::size_t n = 0; n <= i; ++n) {
    const Signal& signal = signals[n];
    std::optional<ValueId> before = n == 0 ? std::nullopt : after[n - 1];
    if (n > 0 && monitor.stale && signals[n - 1].understood && signal.time - signals[n - 1].since > *monitor.stale)
      before.reset();
    if (!signal.understood || signal.reset) continue;
    if (monitor.over && !signal.number) {
      after[n] = before;
      continue;
    }
    if (!before) {
      after[n] = said_by(monitor, signal);
      fresh[n] = true;
      continue;
    }
    // The samples in a row, up to this one, that leave the value.
    std::size_t run = 0;
    Ticks from = signal.time;
    for (std::size_t m = n + 1; m-- > 0;) {
      if (!signals[m].understood || !leaves(monitor, signals[m], *before)) break;
      if (m < n && fresh[m]) break;
      ++run;
      from = signals[m].time;
    }
    const bool goes = run >= monitor.persist_samples && run > 0 && signal.time - from >= monitor.persist_time;
    after[n] = goes ? said_by(monitor, signal) : before;
    fresh[n] = goes;
  }
  return after[i];
}

}  // namespace

automata::Observation readings(const std::vector<Monitor>& monitors, const std::vector<ChannelSaid>& samples,
                               Ticks now) {
  automata::Observation observation;
  for (const Monitor& monitor : monitors) {
    const std::vector<Signal> signals = signals_of(monitor, samples);
    if (signals.empty()) continue;
    const auto value = value_after(monitor, signals, signals.size() - 1);
    const bool stale = monitor.stale && now - signals.back().since > *monitor.stale;
    if (value && !stale) observation.push_back({monitor.attribute, *value});
  }
  std::sort(observation.begin(), observation.end());
  return observation;
}

}  // namespace rmpl::reference
