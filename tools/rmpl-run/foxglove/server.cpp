// Boost.Beast in one room: its headers are heavy, and nothing else of the house includes them.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/foxglove/server.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <csignal>
#include <deque>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string_view>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "tools/shared/tcp_listener.hpp"

namespace rmpl::tools {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;
using nlohmann::json;

constexpr const char* protocol_name = "foxglove.websocket.v1";
constexpr std::size_t most_clients = 32;
constexpr std::size_t most_subscriptions = 1'000;   // of a client
constexpr std::size_t most_bad_messages = 100;      // of a client, before it is closed
constexpr std::size_t longest_message = 1U << 16U;  // from a client
constexpr std::size_t most_queued = 4U << 20U;      // bytes of messages that wait for a client
constexpr auto patience_of_handshake = std::chrono::seconds(10);
constexpr auto patience_at_end = std::chrono::seconds(1);

/// How grave a status is.
enum class Level { info = 0, warning = 1, error = 2 };

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

std::string text_of(const json& message) { return message.dump(-1, ' ', false, json::error_handler_t::replace); }

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

class Session;

/// What all sessions share; touched by the thread of the server alone.
struct Hall {
  std::string info, advertisement;  ///< what a client is told first
  std::size_t channels = 0;
  bool remote = false;
  std::map<std::size_t, runtime::FlightMessage> last = {};  ///< by channel: what holds
  std::set<std::shared_ptr<Session>> sessions = {};
  std::function<void()> changed = nullptr;                   ///< somebody came or went
  std::function<void(const std::string&)> remark = nullptr;  ///< something is to be told of a client
};

/// A client, from its first byte on.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(tcp::socket socket, Hall& hall) : stream_(beast::tcp_stream(std::move(socket))), hall_(hall) {}

  void start() {
    parser_.header_limit(8U << 10U);
    parser_.body_limit(longest_message);
    beast::get_lowest_layer(stream_).expires_after(patience_of_handshake);
    http::async_read(beast::get_lowest_layer(stream_), buffer_, parser_,
                     [self = shared_from_this()](error_code error, std::size_t) { self->greet(error); });
  }

  /// Whether it shook hands, and is not about to leave.
  [[nodiscard]] bool looks_on() const { return open_ && !leaving_; }

  void tell(Level level, const std::string& message) {
    queue(text_of({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", message}}), true);
  }

  void send_time(automata::Ticks now) { queue_data(time_frame(now)); }

  void send(const runtime::FlightMessage& message) {
    for (const auto& [subscription, channel] : subscriptions_) {
      if (channel != message.channel) continue;
      if (!queue_data(message_frame(subscription, message))) missed_.insert(channel);
    }
  }

  /// It is closed once it has got what is under way.
  void leave() {
    leaving_ = true;
    if (!writing_) close(websocket::close_code::going_away);
  }

  /// At once.
  void cut_off() {
    error_code ignored;
    beast::get_lowest_layer(stream_).socket().close(ignored);
  }

 private:
  struct Frame {
    std::string bytes;
    bool text;
  };

  void greet(error_code error) {
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

  void refuse(http::status status, const std::string& why) {
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

  void welcome(error_code error) {
    if (error) return end();
    open_ = true;
    buffer_.consume(buffer_.size());
    queue(hall_.info, true);
    queue(hall_.advertisement, true);
    hall_.changed();
    read();
  }

  void read() {
    stream_.async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
      if (error) return self->end();
      self->take(beast::buffers_to_string(self->buffer_.data()), self->stream_.got_text());
      self->buffer_.consume(self->buffer_.size());
      if (self->bad_ > most_bad_messages) return self->close(websocket::close_code::policy_error);
      self->read();
    });
  }

  void complain(const std::string& what) {
    ++bad_;
    tell(Level::error, what);
  }

  void take(const std::string& text, bool is_text) {
    const json message = is_text ? json::parse(text, nullptr, false) : json();
    const auto op = message.is_object() ? message.find("op") : message.end();
    if (!message.is_object() || op == message.end() || !op->is_string()) {
      return complain("expected a JSON object with a text `op`");
    }
    if (*op == "subscribe") return subscribe(message);
    if (*op == "unsubscribe") return unsubscribe(message);
    complain("`" + op->get<std::string>().substr(0, 64) + "`: a flight can be looked at, and no more");
  }

  /// A whole number below 2^32.
  static std::optional<std::uint32_t> number_in(const json& value) {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > 0xffffffffU) return std::nullopt;
    return static_cast<std::uint32_t>(value.get<std::uint64_t>());
  }
  static std::optional<std::uint32_t> number_in(const json& object, const char* key) {
    const auto found = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && found != object.end() ? number_in(*found) : std::nullopt;
  }

  void subscribe(const json& message) {
    const auto wanted = message.find("subscriptions");
    if (wanted == message.end() || !wanted->is_array()) return complain("`subscribe`: expected `subscriptions`");
    for (const json& one : *wanted) {
      const auto id = number_in(one, "id"), channel = number_in(one, "channelId");
      if (!id || !channel || *channel == 0 || *channel > hall_.channels) {
        complain("`subscribe`: expected the `id` of a subscription and the `channelId` of a channel that there is");
      } else if (subscriptions_.size() >= most_subscriptions || !subscriptions_.emplace(*id, *channel - 1).second) {
        complain("`subscribe`: subscription " + std::to_string(*id) + " is one too many, or there already");
      } else if (const auto holds = hall_.last.find(*channel - 1); holds != hall_.last.end()) {
        queue_data(message_frame(*id, holds->second));
      }
    }
  }

  void unsubscribe(const json& message) {
    const auto ids = message.find("subscriptionIds");
    if (ids == message.end() || !ids->is_array()) return complain("`unsubscribe`: expected `subscriptionIds`");
    for (const json& one : *ids) {
      const auto id = number_in(one);
      if (!id || subscriptions_.erase(*id) == 0) complain("`unsubscribe`: there is no such subscription");
    }
  }

  /// Where too much waits already it is dropped: false.
  bool queue_data(std::string bytes) {
    if (!looks_on()) return true;
    if (queued_ + bytes.size() > most_queued) {
      if (dropped_++ == 0) hall_.remark("reads too slowly: messages are dropped");
      return false;
    }
    queue(std::move(bytes), false);
    return true;
  }

  void queue(std::string bytes, bool text) {
    if (!open_ || closing_) return;
    // What a client is told besides may not grow without bound either: one that does not read is not talked to.
    if (text && queue_.size() > 10'000) return;
    queued_ += bytes.size();
    queue_.push_back({std::move(bytes), text});
    if (!writing_) write();
  }

  void write() {
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

  /// It reads again: it is told what it missed, and gets what holds.
  void make_up() {
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

  void close(websocket::close_code code) {
    if (std::exchange(closing_, true)) return;
    stream_.async_close(code, [self = shared_from_this()](error_code) { self->end(); });
  }

  void end() {
    const auto self = shared_from_this();
    open_ = false;
    cut_off();
    if (hall_.sessions.erase(self) > 0) hall_.changed();
  }

  websocket::stream<beast::tcp_stream> stream_;
  Hall& hall_;
  beast::flat_buffer buffer_{longest_message + (8U << 10U)};
  http::request_parser<http::string_body> parser_;
  http::response<http::string_body> refusal_;
  std::map<std::uint32_t, std::size_t> subscriptions_;  ///< to channels
  std::deque<Frame> queue_;
  std::size_t queued_ = 0;        ///< bytes
  std::size_t dropped_ = 0;       ///< messages, since it was told of some
  std::set<std::size_t> missed_;  ///< channels of these
  std::size_t bad_ = 0;           ///< messages that it sent
  bool open_ = false, writing_ = false, leaving_ = false, closing_ = false;
};

}  // namespace

class FoxgloveServer::Impl {
 public:
  Impl(const std::string& address, bool remote, Offer offer) : acceptor_(context_), pause_(context_), end_(context_) {
    listen(address, remote);
    hall_.remote = remote;
    hall_.channels = offer.channels.size();
    hall_.changed = [this] { count(); };
    hall_.remark = [this](const std::string& what) { remark(what); };
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    hall_.info = text_of({{"op", "serverInfo"},
                          {"name", offer.name},
                          {"capabilities", {"time"}},
                          {"supportedEncodings", json::array()},
                          {"metadata", offer.metadata},
                          {"sessionId", std::to_string(std::chrono::nanoseconds(since).count())}});
    json channels = json::array();
    for (const AdvertisedChannel& channel : offer.channels) {
      channels.push_back({{"id", channels.size() + 1},
                          {"topic", channel.topic},
                          {"encoding", "json"},
                          {"schemaName", channel.schema_name},
                          {"schema", channel.schema},
                          {"schemaEncoding", "jsonschema"}});
    }
    hall_.advertisement = text_of({{"op", "advertise"}, {"channels", std::move(channels)}});
    accept();
    // Signals are those of the flight: it waits for the plant, and must wake.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    try {
      thread_ = std::thread([this] { run(); });
    } catch (...) {
      pthread_sigmask(SIG_SETMASK, &before, nullptr);
      throw;
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }

  ~Impl() {
    context_.stop();
    if (thread_.joinable()) thread_.join();
    // Sessions hold themselves in handlers that never run now.
    for (const auto& session : hall_.sessions) session->cut_off();
    hall_.sessions.clear();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  bool send(automata::Ticks now, std::vector<runtime::FlightMessage> messages) {
    // Where the thread is behind, as in a flight of thousands of cycles a second, memory must not grow.
    if (under_way_ >= most_under_way) {
      if (!std::exchange(behind_, true)) remark("cannot follow so fast: messages are left out");
      return false;
    }
    ++under_way_;
    asio::post(context_, [this, now, messages = std::move(messages)] {
      --under_way_;
      for (const runtime::FlightMessage& message : messages) {
        if (message.channel != runtime::event_channel) hall_.last[message.channel] = message;
      }
      for (const auto& session : hall_.sessions) {
        if (!session->looks_on()) continue;
        session->send_time(now);
        for (const runtime::FlightMessage& message : messages) session->send(message);
      }
    });
    return true;
  }

  void finish(const std::string& summary) {
    asio::post(context_, [this, summary] {
      error_code ignored;
      acceptor_.close(ignored);
      pause_.cancel();
      ended_ = true;
      end_.expires_after(patience_at_end);
      end_.async_wait([this](error_code error) {
        if (!error) context_.stop();
      });
      const std::vector<std::shared_ptr<Session>> all(hall_.sessions.begin(), hall_.sessions.end());
      for (const auto& session : all) {
        if (!session->looks_on()) {
          session->cut_off();
          continue;
        }
        session->tell(Level::info, summary);
        session->leave();
      }
      if (hall_.sessions.empty()) end_.cancel();
      guard_.reset();
    });
    thread_.join();
  }

  std::vector<std::string> remarks() {
    const std::lock_guard lock(mutex_);
    return std::exchange(remarks_, {});
  }

  [[nodiscard]] const std::string& url() const { return url_; }
  [[nodiscard]] std::uint64_t audience() const { return audience_; }

 private:
  static constexpr std::size_t most_under_way = 10'000;

  void listen(const std::string& address, bool remote) {
    const std::size_t colon = address.rfind(':');
    const std::string port = colon == std::string::npos ? address : address.substr(colon + 1);
    std::string host = colon == std::string::npos ? "127.0.0.1" : address.substr(0, colon);
    const std::string shown = host;
    if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
    try {
      TcpListener listener = listen_tcp(host, port, remote, "a loopback address, or --foxglove-remote");
      acceptor_.assign(listener.ipv6 ? tcp::v6() : tcp::v4(), listener.socket.release());
      ipv6_ = listener.ipv6;
      url_ = "ws://" + shown + ":" + listener.port;
    } catch (const CannotListen& error) {
      throw base::InputError("--foxglove: " + address + ": " + error.what());
    }
  }

  void run() {
    try {
      context_.run();
    } catch (const std::exception& error) {
      remark(std::string("cannot go on: ") + error.what());
      audience_ = 0;
    }
  }

  /// By hand, so that the plant, which is a child, does not inherit what was accepted.
  void accept() {
    acceptor_.async_wait(tcp::acceptor::wait_read, [this](error_code error) {
      if (error) return;
      Descriptor socket(::accept4(acceptor_.native_handle(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
      if (!socket.open()) return accept_later();
      if (hall_.sessions.size() >= most_clients) {
        remark("is one too many, and was closed: there are " + std::to_string(most_clients));
        return accept();
      }
      tcp::socket client(context_);
      error_code failure;
      client.assign(ipv6_ ? tcp::v6() : tcp::v4(), socket.number(), failure);
      if (failure) return accept_later();
      (void)socket.release();
      client.set_option(tcp::no_delay(true), failure);  // a message is small, and wanted now
      const auto session = std::make_shared<Session>(std::move(client), hall_);
      hall_.sessions.insert(session);
      session->start();
      accept();
    });
  }

  /// There are no more descriptors, say: what waits is asked for again in a moment.
  void accept_later() {
    pause_.expires_after(std::chrono::milliseconds(100));
    pause_.async_wait([this](error_code error) {
      if (!error) accept();
    });
  }

  void count() {
    const bool somebody = std::any_of(hall_.sessions.begin(), hall_.sessions.end(),
                                      [](const auto& session) { return session->looks_on(); });
    if (somebody && audience_ == 0) audience_ = ++audiences_;
    if (!somebody) audience_ = 0;
    if (!somebody) hall_.last.clear();
    if (ended_ && hall_.sessions.empty()) end_.cancel();
  }

  void remark(const std::string& what) {
    constexpr std::size_t most_remarks = 100;
    const std::lock_guard lock(mutex_);
    if (remarks_.size() < most_remarks) remarks_.push_back("--foxglove: a client " + what);
  }

  asio::io_context context_{1};
  asio::executor_work_guard<asio::io_context::executor_type> guard_ = asio::make_work_guard(context_);
  tcp::acceptor acceptor_;
  asio::steady_timer pause_, end_;
  Hall hall_;
  std::string url_;
  bool ipv6_ = false;
  bool ended_ = false;
  std::atomic<std::uint64_t> audience_ = 0;
  std::uint64_t audiences_ = 0;
  std::atomic<std::size_t> under_way_ = 0;
  bool behind_ = false;  ///< that was told
  std::mutex mutex_;
  std::vector<std::string> remarks_;
  std::thread thread_;
};

FoxgloveServer::FoxgloveServer(const std::string& address, bool remote, Offer offer)
    : impl_(std::make_unique<Impl>(address, remote, std::move(offer))) {}
FoxgloveServer::~FoxgloveServer() = default;
const std::string& FoxgloveServer::url() const { return impl_->url(); }
std::uint64_t FoxgloveServer::audience() const { return impl_->audience(); }
bool FoxgloveServer::send(automata::Ticks now, std::vector<runtime::FlightMessage> messages) {
  return impl_->send(now, std::move(messages));
}
std::vector<std::string> FoxgloveServer::remarks() { return impl_->remarks(); }
void FoxgloveServer::finish(const std::string& summary) { impl_->finish(summary); }

}  // namespace rmpl::tools
