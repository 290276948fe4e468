// MCAP (https://mcap.dev/spec, version 0): records, a chunk with an index for each megabyte, a summary.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

#include "runtime/executive/trace/json_line.hpp"
#include "runtime/report/exports.hpp"

namespace rmpl::runtime {
namespace {

using automata::Ticks;

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics = 0x0b,
  data_end = 0x0f
};

/// Fields of records: little-endian numbers, texts with their lengths before them.
class Fields {
 public:
  Fields& u16(std::uint64_t value) { return number(value, 2); }
  Fields& u32(std::uint64_t value) { return number(value, 4); }
  Fields& u64(std::uint64_t value) { return number(value, 8); }
  Fields& text(std::string_view value) { return u32(value.size()).raw(value); }
  Fields& raw(std::string_view value) {
    bytes_ += value;
    return *this;
  }
  /// A record of these fields.
  [[nodiscard]] std::string record(Opcode opcode) const {
    Fields head;
    head.bytes_ += static_cast<char>(opcode);
    return head.u64(bytes_.size()).bytes_ + bytes_;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  Fields& number(std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xffu);
    return *this;
  }
  std::string bytes_;
};

struct Message {
  Ticks time;
  std::size_t channel;
  std::string data;
};

struct Channel {
  std::string_view topic;
  std::string_view about;
};

/// Of the last, each message is one event; of the others, all that holds.
constexpr std::array<Channel, 8> channels{
    {{"/estimate", "the mode of each component, as estimated"},
     {"/truth", "the mode of each component, in the simulated plant"},
     {"/belief", "per component, the share of each mode that has any, in percent"},
     {"/goal", "the goals that the program asserts"},
     {"/command", "the controls that are not idle, and why"},
     {"/reading", "what the sensors read; those that are silent are not named"},
     {"/marking", "the locations of the program that are marked, from 1"},
     {"/event", "what happened beside the regular flow"}}};

class Messages {
 public:
  explicit Messages(const Flight& flight) : flight_(flight), plant_(*flight.plant) {}

  std::vector<Message> all() {
    add_modes(0, flight_.estimate);
    add_modes(1, flight_.truth);
    add_belief();
    add_goals();
    add_commands();
    add_readings();
    add_marking();
    add_events();
    std::stable_sort(messages_.begin(), messages_.end(),
                     [](const Message& a, const Message& b) { return a.time < b.time; });
    return std::move(messages_);
  }

 private:
  template <class Write>
  void add(std::size_t channel, Ticks time, const Write& write) {
    json_.clear();
    json_.open('{');
    write();
    json_.close('}');
    messages_.push_back({time, channel, json_.text()});
  }

  void add_modes(std::size_t channel, const std::vector<Track<automata::ModeId>>& tracks) {
    for (const Ticks time : times_of(tracks)) {
      add(channel, time, [&] {
        for (std::size_t c = 0; c < tracks.size(); ++c) {
          const automata::ModeId* mode = tracks[c].at(time);
          if (mode == nullptr) continue;
          json_.key(plant_.components[c].name).string(plant_.components[c].modes[mode->index()].name);
        }
      });
    }
  }

  void add_belief() {
    for (const Ticks time : times_of(flight_.belief)) {
      add(2, time, [&] {
        for (std::size_t c = 0; c < flight_.belief.size(); ++c) {
          const automata::Component& component = plant_.components[c];
          const Shares* shares = flight_.belief[c].at(time);
          const automata::ModeId* mode = flight_.estimate[c].at(time);
          json_.key(component.name).open('{');
          if (shares != nullptr && !shares->empty()) {
            for (const auto& [m, percent] : *shares) json_.key(component.modes[m.index()].name).number(percent);
          } else if (mode != nullptr) {
            json_.key(component.modes[mode->index()].name).number(100);
          }
          json_.close('}');
        }
      });
    }
  }

  void add_goals() {
    for (const auto& change : flight_.goals.changes()) {
      add(3, change.time, [&] {
        for (const AssertedGoal& goal : change.value) {
          json_.key(plant_.variables.name(goal.goal.variable)).string(plant_.variables.value(goal.goal));
        }
      });
    }
  }

  void add_commands() {
    for (const Ticks time : times_of(flight_.commands)) {
      add(4, time, [&] {
        json_.key("command").open('{');
        bool some = false;
        for (std::size_t i = 0; i < flight_.commands.size(); ++i) {
          const automata::Control& control = plant_.controls[i];
          const automata::ValueId* value = flight_.commands[i].at(time);
          if (value == nullptr || *value == control.idle) continue;
          some = true;
          json_.key(plant_.variables.name(control.variable));
          json_.string(plant_.variables.value({control.variable, *value}));
        }
        json_.close('}');
        const Explanation* why = flight_.explanations.at(time);
        if (some && why != nullptr) json_.key("why").string(why->why);
      });
    }
  }

  void add_readings() {
    for (const Ticks time : times_of(flight_.readings)) {
      add(5, time, [&] {
        for (std::size_t i = 0; i < flight_.readings.size(); ++i) {
          const auto* value = flight_.readings[i].at(time);
          if (value == nullptr || !*value) continue;
          const automata::Variable& variable = plant_.variables[plant_.observables[i]];
          json_.key(variable.name).string(variable.values[(*value)->index()]);
        }
      });
    }
  }

  void add_marking() {
    for (const auto& change : flight_.marking.changes()) {
      add(6, change.time, [&] {
        json_.key("locations").open('[');
        for (const automata::LocationId location : change.value) json_.number(location.index() + 1);
        json_.close(']');
      });
    }
  }

  void add_events() {
    for (const Happening& happening : flight_.happenings) {
      add(7, happening.from, [&] {
        json_.key("kind").string(happening.kind);
        if (happening.component) json_.key("component").string(plant_[*happening.component].name);
        if (happening.to) json_.key("until").seconds(*happening.to);
        json_.key("text").string(happening.text);
      });
    }
  }

  const Flight& flight_;
  const automata::Plant& plant_;
  JsonLine json_;
  std::vector<Message> messages_;
};

std::string schema_record(std::size_t channel) {
  JsonLine json;
  json.open('{').key("type").string("object").key("description").string(channels[channel].about).close('}');
  const std::string name = "rmpl." + std::string(channels[channel].topic.substr(1));
  return Fields().u16(channel + 1).text(name).text("jsonschema").text(json.text()).record(Opcode::schema);
}

std::string channel_record(std::size_t channel) {
  return Fields()
      .u16(channel)
      .u16(channel + 1)
      .text(channels[channel].topic)
      .text("json")
      .u32(0)
      .record(Opcode::channel);
}

std::uint64_t nanoseconds(Ticks time) { return static_cast<std::uint64_t>(time.count); }

class Writer {
 public:
  explicit Writer(std::vector<Message> messages) : messages_(std::move(messages)) {}

  std::string text() {
    constexpr std::string_view magic{"\x89MCAP0\r\n", 8};
    constexpr std::size_t chunk_size = 1u << 20;
    out_ = std::string(magic) + Fields().text("").text("rmpl").record(Opcode::header);
    for (std::size_t from = 0; from < messages_.size();) {
      std::size_t to = from;
      for (std::size_t size = 0; to < messages_.size() && size < chunk_size; ++to) size += messages_[to].data.size();
      write_chunk(from, to);
      from = to;
    }
    out_ += Fields().u32(0).record(Opcode::data_end);
    const std::uint64_t summary = out_.size();
    for (std::size_t c = 0; c < channels.size(); ++c) out_ += schema_record(c) + channel_record(c);
    out_ += statistics() + chunk_indices_;
    out_ += Fields().u64(summary).u64(0).u32(0).record(Opcode::footer);
    return out_.append(magic);
  }

 private:
  void write_chunk(std::size_t from, std::size_t to) {
    std::string records;
    if (from == 0) {
      for (std::size_t c = 0; c < channels.size(); ++c) records += schema_record(c) + channel_record(c);
    }
    std::array<Fields, channels.size()> indices;
    std::array<std::uint32_t, channels.size()> counts{};
    for (std::size_t m = from; m < to; ++m) {
      const Message& message = messages_[m];
      indices[message.channel].u64(nanoseconds(message.time)).u64(records.size());
      ++counts[message.channel];
      records += Fields()
                     .u16(message.channel)
                     .u32(sequences_[message.channel]++)
                     .u64(nanoseconds(message.time))
                     .u64(nanoseconds(message.time))
                     .raw(message.data)
                     .record(Opcode::message);
    }
    const std::uint64_t first = nanoseconds(messages_[from].time), last = nanoseconds(messages_[to - 1].time);
    const std::uint64_t start = out_.size();
    // The sum 0 says that there is none, as elsewhere.
    out_ += Fields()
                .u64(first)
                .u64(last)
                .u64(records.size())
                .u32(0)
                .text("")
                .u64(records.size())
                .raw(records)
                .record(Opcode::chunk);
    const std::uint64_t length = out_.size() - start;
    Fields offsets;
    const std::uint64_t indices_start = out_.size();
    for (std::size_t c = 0; c < channels.size(); ++c) {
      if (counts[c] == 0) continue;
      offsets.u16(c).u64(out_.size());
      out_ += Fields().u16(c).text(indices[c].bytes()).record(Opcode::message_index);
    }
    chunk_indices_ += Fields()
                          .u64(first)
                          .u64(last)
                          .u64(start)
                          .u64(length)
                          .text(offsets.bytes())
                          .u64(out_.size() - indices_start)
                          .text("")
                          .u64(records.size())
                          .u64(records.size())
                          .record(Opcode::chunk_index);
    ++chunks_;
  }

  [[nodiscard]] std::string statistics() const {
    Fields counts;
    for (std::size_t c = 0; c < channels.size(); ++c) counts.u16(c).u64(sequences_[c]);
    const std::uint64_t first = messages_.empty() ? 0 : nanoseconds(messages_.front().time);
    const std::uint64_t last = messages_.empty() ? 0 : nanoseconds(messages_.back().time);
    return Fields()
        .u64(messages_.size())
        .u16(channels.size())
        .u32(channels.size())
        .u32(0)
        .u32(0)
        .u32(chunks_)
        .u64(first)
        .u64(last)
        .text(counts.bytes())
        .record(Opcode::statistics);
  }

  std::vector<Message> messages_;
  std::string out_;
  std::string chunk_indices_;
  std::array<std::uint32_t, channels.size()> sequences_{};
  std::uint32_t chunks_ = 0;
};

}  // namespace

std::string to_mcap(const Flight& flight) { return Writer(Messages(flight).all()).text(); }

}  // namespace rmpl::runtime
