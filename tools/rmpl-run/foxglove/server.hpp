// Those who look on at a flight, over Foxglove's WebSocket protocol (foxglove.websocket.v1).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "automata/time/time.hpp"
#include "runtime/report/messages.hpp"

namespace rmpl::tools {

/// What is on offer.
struct AdvertisedChannel {
  std::string topic;
  std::string schema_name;
  std::string schema;  ///< JSON Schema
};

/// A thread of its own speaks with the clients: nothing here waits for one of them. A client that reads too slowly
/// loses messages, is told how many, and then gets what holds; one that breaks the protocol is told or closed.
class FoxgloveServer {
 public:
  struct Offer {
    std::string name;
    std::map<std::string, std::string> metadata;
    std::vector<AdvertisedChannel> channels;
  };
  /// `address` is PORT, HOST:PORT or [HOST]:PORT, without a host the loopback. Throws base::InputError where one cannot
  /// listen there, or other machines could connect and are not to (`remote`). To be made after the last fork.
  FoxgloveServer(const std::string& address, bool remote, Offer offer);
  /// Who is connected is cut off, unless `finish` was called.
  ~FoxgloveServer();
  FoxgloveServer(const FoxgloveServer&) = delete;
  FoxgloveServer& operator=(const FoxgloveServer&) = delete;

  /// `ws://127.0.0.1:8765`
  [[nodiscard]] const std::string& url() const;
  /// 0 where nobody looks on; else another number each time that somebody comes and nobody was there.
  [[nodiscard]] std::uint64_t audience() const;
  /// To all who look on, at a time of the flight. `channel` of a message is a position in the offer. False where the
  /// thread is far behind: then all of it is left out.
  bool send(automata::Ticks now, std::vector<runtime::FlightMessage> messages);
  /// What there is to be told of clients since this was asked last: lines for people.
  [[nodiscard]] std::vector<std::string> remarks();
  /// The flight is over: who looks on is told how, gets what is under way within a second, and is closed.
  void finish(const std::string& summary);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rmpl::tools
