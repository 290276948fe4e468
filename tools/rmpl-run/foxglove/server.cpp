// Boost.Beast in one room: its headers are heavy, and nothing else of the house includes them.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/foxglove/server.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <csignal>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "tools/rmpl-run/foxglove/session.hpp"
#include "tools/shared/tcp_listener.hpp"

namespace rmpl::tools {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
using nlohmann::json;

constexpr std::size_t most_clients = 32;
constexpr auto patience_at_end = std::chrono::seconds(1);

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
    hall_.info = as_text({{"op", "serverInfo"},
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
    hall_.advertisement = as_text({{"op", "advertise"}, {"channels", std::move(channels)}});
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
      const std::vector<std::shared_ptr<FoxgloveSession>> all(hall_.sessions.begin(), hall_.sessions.end());
      for (const auto& session : all) {
        if (!session->looks_on()) {
          session->cut_off();
          continue;
        }
        session->tell(FoxgloveSession::Level::info, summary);
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
      const auto session = std::make_shared<FoxgloveSession>(std::move(client), hall_);
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
  FoxgloveHall hall_;
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
