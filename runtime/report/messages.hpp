// What happened in a flight as messages on channels, JSON with schemas: what MCAP holds, and a live stream tells.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "automata/scenario.hpp"
#include "runtime/executive/trace/cycle_record.hpp"
#include "runtime/report/flight.hpp"
#include "runtime/report/recorder.hpp"

namespace rmpl::runtime {

struct MessageChannel {
  std::string_view topic;
  std::string_view about;
};

/// Of `/event` each message is one event; of the others, all that holds from its time on.
std::span<const MessageChannel> message_channels();
constexpr std::size_t event_channel = 7;
constexpr std::size_t sample_channel = 8;

/// What the messages of a channel hold, as JSON Schema: the fields, and the values that they have. `telemetry`: the
/// channels of telemetry, as far as they are known.
std::string message_schema(std::size_t channel, const automata::Plant& plant,
                           const std::vector<FlownChannel>& telemetry = {});

struct FlightMessage {
  automata::Ticks time;
  std::size_t channel = 0;
  std::string data;  ///< a JSON object
  bool operator==(const FlightMessage&) const = default;
};

/// All messages of a flight, by time.
std::vector<FlightMessage> messages_of(const Flight& flight);

/// The messages of a flight that goes on, cycle by cycle. Memory does not grow with the flight.
class MessageStream {
 public:
  /// Keeps references.
  MessageStream(const automata::Document& document, const automata::Scenario& scenario);

  void observe(const CycleRecord& record);
  /// What is new since it was asked last, by time: of each channel but that of events at most one; of that the events
  /// of the last cycle, which have no `until` yet.
  std::vector<FlightMessage> take();
  /// All that holds is new again.
  void begin_anew();

 private:
  Recorder recorder_;
  std::size_t told_events_ = 0;      ///< from the front of the flight's: those that go on
  std::vector<FlightMessage> sent_;  ///< the last one of each channel
};

}  // namespace rmpl::runtime
