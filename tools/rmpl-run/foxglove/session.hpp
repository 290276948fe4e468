// A client of the server, from its first byte on: the handshake, the subprotocol foxglove.websocket.v1, and the queue
// of what it is to get. SPDX-License-Identifier: MIT
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "automata/time/time.hpp"
#include "runtime/report/messages.hpp"

namespace rmpl::tools {

/// The text of a message; bytes that are no UTF-8 are replaced.
std::string as_text(const nlohmann::json& message);

class FoxgloveSession;

/// What all sessions share; touched by the thread of the server alone.
struct FoxgloveHall {
  std::string info, advertisement;  ///< what a client is told first
  std::size_t channels = 0;
  bool remote = false;
  std::map<std::size_t, runtime::FlightMessage> last = {};  ///< by channel: what holds
  std::set<std::shared_ptr<FoxgloveSession>> sessions = {};
  std::function<void()> changed = nullptr;                   ///< somebody came or went
  std::function<void(const std::string&)> remark = nullptr;  ///< something is to be told of a client
};

/// A client, from its first byte on. A handler that is under way holds it.
class FoxgloveSession : public std::enable_shared_from_this<FoxgloveSession> {
 public:
  /// How grave a status is; the numbers are the protocol's.
  enum class Level { info = 0, warning = 1, error = 2 };

  FoxgloveSession(boost::asio::ip::tcp::socket socket, FoxgloveHall& hall);

  void start();
  /// Whether it shook hands, and is not about to leave.
  [[nodiscard]] bool looks_on() const { return open_ && !leaving_; }
  void tell(Level level, const std::string& message);
  void send_time(automata::Ticks now);
  void send(const runtime::FlightMessage& message);
  /// It is closed once it has got what is under way.
  void leave();
  /// At once.
  void cut_off();

 private:
  struct Frame {
    std::string bytes;
    bool text;
  };

  void greet(boost::system::error_code error);
  void refuse(boost::beast::http::status status, const std::string& why);
  void welcome(boost::system::error_code error);
  void read();
  void complain(const std::string& what);
  void take(const std::string& text, bool is_text);
  void subscribe(const nlohmann::json& message);
  void unsubscribe(const nlohmann::json& message);
  /// Where too much waits already it is dropped: false.
  bool queue_data(std::string bytes);
  void queue(std::string bytes, bool text);
  void write();
  /// It reads again: it is told what it missed, and gets what holds.
  void make_up();
  void close(boost::beast::websocket::close_code code);
  void end();

  boost::beast::websocket::stream<boost::beast::tcp_stream> stream_;
  FoxgloveHall& hall_;
  boost::beast::flat_buffer buffer_;
  boost::beast::http::request_parser<boost::beast::http::string_body> parser_;
  boost::beast::http::response<boost::beast::http::string_body> refusal_;
  std::map<std::uint32_t, std::size_t> subscriptions_;  ///< to channels
  std::deque<Frame> queue_;
  std::size_t queued_ = 0;        ///< bytes
  std::size_t dropped_ = 0;       ///< messages, since it was told of some
  std::set<std::size_t> missed_;  ///< channels of these
  std::size_t bad_ = 0;           ///< messages that it sent
  bool open_ = false, writing_ = false, leaving_ = false, closing_ = false;
};

}  // namespace rmpl::tools
