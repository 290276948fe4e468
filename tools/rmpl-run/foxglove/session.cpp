// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/foxglove/session.hpp"

#include <chrono>
#include <optional>
#include <string_view>
#include <utility>

namespace rmpl::tools {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;
using nlohmann::json;

namespace {

constexpr const char* protocol_name = "foxglove.websocket.v1";
constexpr std::size_t most_subscriptions = 1'000;   // of a client
constexpr std::size_t most_bad_messages = 100;      // of a client, before it is closed
constexpr std::size_t longest_message = 1U << 16U;  // from a client
constexpr std::size_t most_queued = 4U << 20U;      // bytes of messages that wait for a client
constexpr auto patience_of_handshake = std::chrono::seconds(10);

/// What begins a binary message.
enum class Opcode : std::uint8_t { message_data = 1, time = 2 };

void put(std::string& bytes, std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xffU);
}

std::string time_frame(automata::Ticks now) {
  std::string bytes(1, static_cast<char>(Opcode::time));
  put(bytes, static_cast<std::uint64_t>(now.count), 8);
  return bytes;
}

std::string message_frame(std::uint32_t subscription, const runtime::FlightMessage& message) {
  std::string bytes(1, static_cast<char>(Opcode::message_data));
  put(bytes, subscription, 4);
  put(bytes, static_cast<std::uint64_t>(message.time.count), 8);
  return bytes + message.data;
}

/// Pages of other sites that a browser of this machine shows could connect to the loopback, too. Programs send no
/// origin, or one of their own scheme.
bool is_of_this_machine(std::string_view origin) {
  const std::size_t scheme = origin.find("://");
  if (origin.empty()) return true;
  if (scheme == std::string_view::npos) return false;  // `null`: of any page
  if (origin.substr(0, scheme) != "http" && origin.substr(0, scheme) != "https") return true;
  std::string_view host = origin.substr(scheme + 3);
  host = host.substr(0, host.starts_with('[') ? host.find(']') + 1 : host.find(':'));
  return host == "localhost" || host == "127.0.0.1" || host == "[::1]" || host == "foxglove.dev" ||
         host.ends_with(".foxglove.dev");
}

/// A whole number below 2^32.
std::optional<std::uint32_t> number_in(const json& value) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > 0xffffffffU) return std::nullopt;
  return static_cast<std::uint32_t>(value.get<std::uint64_t>());
}

std::optional<std::uint32_t> number_in(const json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() ? number_in(*found) : std::nullopt;
}

}  // namespace

std::string as_text(const json& message) { return message.dump(-1, ' ', false, json::error_handler_t::replace); }

FoxgloveSession::FoxgloveSession(tcp::socket socket, FoxgloveHall& hall)
    : stream_(beast::tcp_stream(std::move(socket))), hall_(hall), buffer_(longest_message + (8U << 10U)) {}

void FoxgloveSession::start() {
  parser_.header_limit(8U << 10U);
  parser_.body_limit(longest_message);
  beast::get_lowest_layer(stream_).expires_after(patience_of_handshake);
  http::async_read(beast::get_lowest_layer(stream_), buffer_, parser_,
                   [self = shared_from_this()](error_code error, std::size_t) { self->greet(error); });
}

void FoxgloveSession::tell(Level level, const std::string& message) {
  queue(as_text({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", message}}), true);
}

void FoxgloveSession::send_time(automata::Ticks now) { queue_data(time_frame(now)); }

void FoxgloveSession::send(const runtime::FlightMessage& message) {
  for (const auto& [subscription, channel] : subscriptions_) {
    if (channel != message.channel) continue;
    if (!queue_data(message_frame(subscription, message))) missed_.insert(channel);
  }
}

void FoxgloveSession::leave() {
  leaving_ = true;
  if (!writing_) close(websocket::close_code::going_away);
}

void FoxgloveSession::cut_off() {
  error_code ignored;
  beast::get_lowest_layer(stream_).socket().close(ignored);
}

void FoxgloveSession::greet(error_code error) {
  if (error) return end();
  const auto& request = parser_.get();
  const std::string origin(request[http::field::origin]);
  if (!websocket::is_upgrade(request)) {
    return refuse(http::status::upgrade_required,
                  std::string("this is a flight for Foxglove: it connects by WebSocket, ") + protocol_name + "\n");
  }
  if (!hall_.remote && !is_of_this_machine(origin)) {
    return refuse(http::status::forbidden, "pages of other sites may not look on\n");
  }
  const auto& offered = request[http::field::sec_websocket_protocol];
  if (!http::token_list(offered).exists(protocol_name)) {
    return refuse(http::status::bad_request, std::string("expected the subprotocol ") + protocol_name + "\n");
  }
  beast::get_lowest_layer(stream_).expires_never();
  websocket::stream_base::timeout timeout{};
  timeout.handshake_timeout = patience_of_handshake;
  timeout.idle_timeout = std::chrono::seconds(60);
  timeout.keep_alive_pings = true;
  stream_.set_option(timeout);
  stream_.auto_fragment(false);  // a message is a frame: simple clients read no others
  stream_.set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
    response.set(http::field::sec_websocket_protocol, protocol_name);
    response.set(http::field::server, "rmpl-run");
  }));
  stream_.read_message_max(longest_message);
  stream_.async_accept(request, [self = shared_from_this()](error_code failure) { self->welcome(failure); });
}

void FoxgloveSession::refuse(http::status status, const std::string& why) {
  refusal_ = {status, 11, why};
  refusal_.set(http::field::content_type, "text/plain");
  refusal_.set(http::field::server, "rmpl-run");
  if (status == http::status::upgrade_required) refusal_.set(http::field::upgrade, "websocket");
  refusal_.keep_alive(false);
  refusal_.prepare_payload();
  http::async_write(beast::get_lowest_layer(stream_), refusal_, [self = shared_from_this()](error_code, std::size_t) {
    error_code ignored;
    beast::get_lowest_layer(self->stream_).socket().shutdown(tcp::socket::shutdown_send, ignored);
    self->end();
  });
}

void FoxgloveSession::welcome(error_code error) {
  if (error) return end();
  open_ = true;
  buffer_.consume(buffer_.size());
  queue(hall_.info, true);
  queue(hall_.advertisement, true);
  hall_.changed();
  read();
}

void FoxgloveSession::read() {
  stream_.async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
    if (error) return self->end();
    self->take(beast::buffers_to_string(self->buffer_.data()), self->stream_.got_text());
    self->buffer_.consume(self->buffer_.size());
    if (self->bad_ > most_bad_messages) return self->close(websocket::close_code::policy_error);
    self->read();
  });
}

void FoxgloveSession::complain(const std::string& what) {
  ++bad_;
  tell(Level::error, what);
}

void FoxgloveSession::take(const std::string& text, bool is_text) {
  const json message = is_text ? json::parse(text, nullptr, false) : json();
  const auto op = message.is_object() ? message.find("op") : message.end();
  if (!message.is_object() || op == message.end() || !op->is_string()) {
    return complain("expected a JSON object with a text `op`");
  }
  if (*op == "subscribe") return subscribe(message);
  if (*op == "unsubscribe") return unsubscribe(message);
  complain("`" + op->get<std::string>().substr(0, 64) + "`: clients can only watch a flight");
}

void FoxgloveSession::subscribe(const json& message) {
  const auto wanted = message.find("subscriptions");
  if (wanted == message.end() || !wanted->is_array()) return complain("`subscribe`: expected `subscriptions`");
  for (const json& one : *wanted) {
    const auto id = number_in(one, "id"), channel = number_in(one, "channelId");
    if (!id || !channel || *channel == 0 || *channel > hall_.channels) {
      complain("`subscribe`: expected the `id` of a subscription and the `channelId` of a channel that there is");
    } else if (subscriptions_.size() >= most_subscriptions || !subscriptions_.emplace(*id, *channel - 1).second) {
      complain("`subscribe`: subscription " + std::to_string(*id) + " exceeds the limit, or exists already");
    } else if (const auto holds = hall_.last.find(*channel - 1); holds != hall_.last.end()) {
      queue_data(message_frame(*id, holds->second));
    }
  }
}

void FoxgloveSession::unsubscribe(const json& message) {
  const auto ids = message.find("subscriptionIds");
  if (ids == message.end() || !ids->is_array()) return complain("`unsubscribe`: expected `subscriptionIds`");
  for (const json& one : *ids) {
    const auto id = number_in(one);
    if (!id || subscriptions_.erase(*id) == 0) complain("`unsubscribe`: there is no such subscription");
  }
}

bool FoxgloveSession::queue_data(std::string bytes) {
  if (!looks_on()) return true;
  if (queued_ + bytes.size() > most_queued) {
    if (dropped_++ == 0) hall_.remark("reads too slowly: messages are dropped");
    return false;
  }
  queue(std::move(bytes), false);
  return true;
}

void FoxgloveSession::queue(std::string bytes, bool text) {
  if (!open_ || closing_) return;
  // What a client is told besides may not grow without bound either: one that does not read is not talked to.
  if (text && queue_.size() > 10'000) return;
  queued_ += bytes.size();
  queue_.push_back({std::move(bytes), text});
  if (!writing_) write();
}

void FoxgloveSession::write() {
  writing_ = true;
  stream_.text(queue_.front().text);
  stream_.async_write(asio::buffer(queue_.front().bytes), [self = shared_from_this()](error_code error, std::size_t) {
    self->writing_ = false;
    if (error) return self->end();
    self->queued_ -= self->queue_.front().bytes.size();
    self->queue_.pop_front();
    if (self->queue_.empty() && self->dropped_ > 0) self->make_up();
    if (self->writing_) return;
    if (!self->queue_.empty()) {
      self->write();
    } else if (self->leaving_) {
      self->close(websocket::close_code::going_away);
    }
  });
}

void FoxgloveSession::make_up() {
  const std::size_t dropped = std::exchange(dropped_, 0);
  tell(Level::warning, std::to_string(dropped) + (dropped == 1 ? " message was" : " messages were") +
                           " dropped: this client reads too slowly");
  const std::set<std::size_t> missed = std::exchange(missed_, {});
  for (const auto& [subscription, channel] : subscriptions_) {
    const auto holds = hall_.last.find(channel);
    if (missed.count(channel) > 0 && holds != hall_.last.end()) {
      queue_data(message_frame(subscription, holds->second));
    }
  }
}

void FoxgloveSession::close(websocket::close_code code) {
  if (std::exchange(closing_, true)) return;
  stream_.async_close(code, [self = shared_from_this()](error_code) { self->end(); });
}

void FoxgloveSession::end() {
  const auto self = shared_from_this();
  open_ = false;
  cut_off();
  if (hall_.sessions.erase(self) > 0) hall_.changed();
}

}  // namespace rmpl::tools
