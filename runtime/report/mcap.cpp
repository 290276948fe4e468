// MCAP (https://mcap.dev/spec, version 0): records, a chunk with an index for each megabyte, a summary.
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/report/exports.hpp"
#include "runtime/report/messages.hpp"

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
  metadata = 0x0c,
  metadata_index = 0x0d,
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

std::string schema_record(std::size_t channel, const std::string& schema) {
  const std::string name = "rmpl." + std::string(message_channels()[channel].topic.substr(1));
  return Fields().u16(channel + 1).text(name).text("jsonschema").text(schema).record(Opcode::schema);
}

std::string channel_record(std::size_t channel) {
  return Fields()
      .u16(channel)
      .u16(channel + 1)
      .text(message_channels()[channel].topic)
      .text("json")
      .u32(0)
      .record(Opcode::channel);
}

std::uint64_t nanoseconds(Ticks time) { return static_cast<std::uint64_t>(time.count); }

class Writer {
 public:
  explicit Writer(const Flight& flight) : flight_(flight), messages_(messages_of(flight)) {
    for (std::size_t c = 0; c < channels_; ++c)
      declarations_ += schema_record(c, message_schema(c, *flight.plant, flight.channels));
    for (std::size_t c = 0; c < channels_; ++c) declarations_ += channel_record(c);
  }

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
    const std::uint64_t about = out_.size();
    const std::string metadata = metadata_record();
    out_ += metadata + Fields().u32(0).record(Opcode::data_end);
    const std::uint64_t summary = out_.size();
    out_ += declarations_ + statistics() + chunk_indices_ +
            Fields().u64(about).u64(metadata.size()).text(metadata_name).record(Opcode::metadata_index);
    out_ += Fields().u64(summary).u64(0).u32(0).record(Opcode::footer);
    return out_.append(magic);
  }

 private:
  void write_chunk(std::size_t from, std::size_t to) {
    std::string records;
    if (from == 0) records += declarations_;
    std::vector<Fields> indices(channels_);
    std::vector<std::uint32_t> counts(channels_);
    for (std::size_t m = from; m < to; ++m) {
      const FlightMessage& message = messages_[m];
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
    for (std::size_t c = 0; c < channels_; ++c) {
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
    for (std::size_t c = 0; c < channels_; ++c) counts.u16(c).u64(sequences_[c]);
    const std::uint64_t first = messages_.empty() ? 0 : nanoseconds(messages_.front().time);
    const std::uint64_t last = messages_.empty() ? 0 : nanoseconds(messages_.back().time);
    return Fields()
        .u64(messages_.size())
        .u16(channels_)
        .u32(channels_)
        .u32(0)
        .u32(1)  // of metadata
        .u32(chunks_)
        .u64(first)
        .u64(last)
        .text(counts.bytes())
        .record(Opcode::statistics);
  }

  /// What flew, and what came of it.
  [[nodiscard]] std::string metadata_record() const {
    Fields pairs;
    const auto add = [&](std::string_view key, const std::string& value) { pairs.text(key).text(value); };
    add("name", flight_.name);
    add("plant", flight_.plant->name);
    if (flight_.program != nullptr) add("program", flight_.program->name);
    if (flight_.seed) add("seed", std::to_string(*flight_.seed));
    add("verdict", flight_.verdict);
    add("summary", flight_.summary);
    return Fields().text(metadata_name).text(pairs.bytes()).record(Opcode::metadata);
  }

  static constexpr std::string_view metadata_name = "rmpl.flight";

  const Flight& flight_;
  /// The last one is there where there was telemetry.
  const std::size_t channels_ = message_channels().size() - (flight_.channels.empty() ? 1 : 0);
  std::vector<FlightMessage> messages_;
  std::string declarations_;  ///< of schemas and channels
  std::string out_;
  std::string chunk_indices_;
  std::vector<std::uint32_t> sequences_ = std::vector<std::uint32_t>(message_channels().size());
  std::uint32_t chunks_ = 0;
};

}  // namespace

std::string to_mcap(const Flight& flight) { return Writer(flight).text(); }

}  // namespace rmpl::runtime
