// Numbers become readings: the monitors of a plant over the samples of their channels.
//
// A monitor has a value or none. A sample leaves the value where it lies outside the limits of the value, moved
// outwards by the hysteresis; the value goes once so many samples in a row have left it, over so long a time. Then, and
// where there is no value, the sample itself says the next one, or none where it lies in a gap. PITEX derives the
// qualitative readings of Livingstone from telemetry in the same way (limits, persistence, staleness).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "automata/logic/variables.hpp"
#include "automata/monitor.hpp"
#include "automata/state.hpp"
#include "automata/time/time.hpp"
#include "runtime/telemetry/sample.hpp"

namespace rmpl::runtime {

/// The value that a sample of a plain channel, or of the signal of a difference or rate, says by itself; nothing in a
/// gap, and where the monitor does not know it.
std::optional<automata::ValueId> value_of(const automata::Monitor& monitor, const Sample& sample);

/// Monitors with their state. A sample costs the monitors of its channel; a rate keeps the samples of its time.
class Monitors {
 public:
  explicit Monitors(std::vector<automata::Monitor> monitors);

  /// The channels, each once, in the order in which the monitors name them.
  [[nodiscard]] const std::vector<std::string>& channels() const { return names_; }
  [[nodiscard]] std::optional<std::uint32_t> find(std::string_view channel) const;
  [[nodiscard]] const std::vector<automata::Monitor>& monitors() const { return monitors_; }

  /// Takes the samples of one time, no earlier than that of the call before. Of two of one channel the later one
  /// counts.
  void take(std::span<const Sample> samples, automata::Ticks time);

  /// What the sensors say at a time, no earlier than the last sample: sorted by attribute. An attribute whose value is
  /// stale, or that has none, is not observed.
  [[nodiscard]] automata::Observation readings(automata::Ticks now) const;

  /// Whether a channel of a monitor of the attribute was sampled.
  [[nodiscard]] bool speak_of(automata::VariableId attribute) const;

  /// For each channel the first sample that gave no reading, since this was asked last: `channel "P1": "n/a" at 3 s is
  /// no number`.
  std::vector<std::string> take_remarks();
  /// Channels that never had a sample.
  [[nodiscard]] std::vector<std::string> silent() const;

 private:
  struct Channel {
    Sample sample;
    automata::Ticks time;
    bool heard = false;      ///< it had a sample
    bool told = false;       ///< one that gave no reading was told
    std::uint64_t call = 0;  ///< of `take` that brought the sample
  };
  struct State {
    std::optional<automata::ValueId> value;
    std::uint64_t outside = 0;            ///< samples in a row that left the value
    automata::Ticks outside_since;        ///< the time of the first of them
    std::optional<automata::Ticks> last;  ///< sample; of a difference the older of the two; none: nothing, or no number
    std::deque<std::pair<automata::Ticks, double>> window;  ///< of a rate: the newest sample before its time, and later
    std::uint32_t channel = 0;
    std::uint32_t minus = 0;  ///< of a difference
  };

  std::uint32_t add_channel(const std::string& name);
  void step(const automata::Monitor& monitor, State& state, automata::Ticks time);
  void read(const automata::Monitor& monitor, State& state, const Sample& signal, automata::Ticks time);
  void refuse(State& state, std::uint32_t channel, automata::Ticks time);

  std::vector<automata::Monitor> monitors_;
  std::vector<std::string> names_;
  std::map<std::string, std::uint32_t, std::less<>> by_name_;
  std::vector<Channel> channels_;
  std::vector<State> states_;       ///< per monitor
  std::vector<std::size_t> order_;  ///< of the monitors, by attribute
  std::uint64_t call_ = 0;
  std::vector<std::string> remarks_;
};

}  // namespace rmpl::runtime
