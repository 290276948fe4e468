// Listening, and who is let in.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/listening_plant.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "tools/shared/tcp_listener.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {
namespace {

constexpr automata::Ticks patience_with_token = automata::Ticks::of_seconds(5);
constexpr std::size_t longest_token = 4096;
constexpr std::size_t most_candidates = 64;

[[noreturn]] void fail(const std::string& address, const std::string& what) {
  throw base::InputError("--listen: " + address + ": " + what);
}

/// Takes as long for a wrong token as for the right one of its length.
bool same(std::string_view given, std::string_view token) {
  unsigned char difference = given.size() == token.size() ? 0 : 1;
  for (std::size_t i = 0; i < token.size(); ++i) {
    const char other = i < given.size() ? given[i] : '\0';
    difference = static_cast<unsigned char>(difference |
                                            (static_cast<unsigned char>(other) ^ static_cast<unsigned char>(token[i])));
  }
  return difference == 0;
}

/// A socket that nobody listens on is left from a run that was killed.
void remove_if_dead(const sockaddr_un& name) {
  struct stat about {};
  if (lstat(name.sun_path, &about) != 0 || !S_ISSOCK(about.st_mode)) return;
  const Descriptor probe(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int answer = ::connect(probe.number(), reinterpret_cast<const sockaddr*>(&name), sizeof name);
  if (answer != 0 && errno == ECONNREFUSED) unlink(name.sun_path);
}

}  // namespace

ListeningPlant::ListeningPlant(const std::string& address, bool remote, std::string token,
                               std::function<bool()> interrupted)
    : LiveSocket(std::move(interrupted)), address_(address), token_(std::move(token)) {
  const std::size_t port = address.rfind(':');
  if (address.starts_with("unix:") && address.size() > 5) {
    listen_on_path(address.substr(5));
  } else if (address.starts_with("tcp:") && port > 4 && port + 1 < address.size()) {
    std::string host = address.substr(4, port - 4);
    if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
    listen_on_network(host, address.substr(port + 1), remote);
  } else {
    fail(address, "expected unix:PATH or tcp:HOST:PORT");
  }
}

ListeningPlant::~ListeningPlant() {
  if (!path_.empty()) unlink(path_.c_str());
}

/// The file is for its owner alone, from the first moment on.
void ListeningPlant::listen_on_path(const std::string& path) {
  sockaddr_un name{};
  name.sun_family = AF_UNIX;
  if (path.size() >= sizeof name.sun_path) fail(address_, "the path is too long for a socket");
  path.copy(name.sun_path, path.size());
  remove_if_dead(name);
  listener_ = Descriptor(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const mode_t before = umask(S_IRWXG | S_IRWXO);
  const int bound = bind(listener_.number(), reinterpret_cast<const sockaddr*>(&name), sizeof name);
  umask(before);
  if (bound != 0) fail(address_, std::strerror(errno));
  path_ = path;
  if (listen(listener_.number(), SOMAXCONN) != 0) fail(address_, std::strerror(errno));
}

void ListeningPlant::listen_on_network(const std::string& host, const std::string& port, bool remote) {
  try {
    TcpListener listener = listen_tcp(host, port, remote, "a loopback address, or --allow-remote and --token");
    listener_ = std::move(listener.socket);
    address_.resize(address_.rfind(':') + 1);
    address_ += listener.port;
  } catch (const CannotListen& error) {
    fail(address_, error.what());
  }
}

void ListeningPlant::await_first(automata::Ticks patience) {
  std::string nothing;
  restart_clock();
  while (!connected() && !interrupted() && now() < patience) {
    wait(std::min(patience, now() + automata::Ticks::of_seconds(1)), false, nothing);
  }
  restart_clock();
}

void ListeningPlant::revive(std::uint64_t /*cycles*/, automata::Ticks until) {
  std::string nothing;
  wait(until, false, nothing);
}

void ListeningPlant::await_also(std::vector<pollfd>& wanted) {
  std::erase_if(candidates_, [&](const Candidate& candidate) {
    const bool late = now() >= candidate.until;
    if (late) turn_away("sent no token in time");
    return late;
  });
  wanted.push_back({listener_.number(), POLLIN, 0});
  for (const Candidate& candidate : candidates_) wanted.push_back({candidate.socket.number(), POLLIN, 0});
}

bool ListeningPlant::look_for_another() {
  if (token_.empty()) {
    Descriptor socket(accept4(listener_.number(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    return socket.open() && take(std::move(socket));
  }
  accept_all();
  bool came = false;
  std::erase_if(candidates_, [&](Candidate& candidate) {
    const Impression impression = came ? Impression::none : look_at(candidate);
    if (impression == Impression::admitted) came = take(std::move(candidate.socket));
    return impression != Impression::none;
  });
  // A first line that has begun to come can be read at any time: its rest is not waited for in haste.
  if (!came && !candidates_.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return came;
}

void ListeningPlant::accept_all() {
  for (std::size_t i = 0; i < most_candidates; ++i) {
    Descriptor socket(accept4(listener_.number(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (!socket.open()) return;
    if (candidates_.size() == most_candidates) {
      turn_away("sent no token before others connected");
      candidates_.erase(candidates_.begin());
    }
    candidates_.push_back({std::move(socket), now() + patience_with_token});
  }
}

/// Looks at what the candidate sent, and takes no more of it than the first line.
ListeningPlant::Impression ListeningPlant::look_at(Candidate& candidate) {
  std::array<char, longest_token + 2> buffer;
  const int socket = candidate.socket.number();
  const ssize_t seen = recv(socket, buffer.data(), buffer.size(), MSG_PEEK | MSG_DONTWAIT);
  if (seen < 0 && (errno == EAGAIN || errno == EINTR)) return Impression::none;
  if (seen <= 0) {
    turn_away("sent no token");
    return Impression::rejected;
  }
  std::string_view text(buffer.data(), static_cast<std::size_t>(seen));
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos && text.size() < buffer.size()) return Impression::none;  // the rest is under way
  text = text.substr(0, end);
  if (text.ends_with('\r')) text.remove_suffix(1);
  if (!same(text, token_)) {
    turn_away("sent a wrong token");
    return Impression::rejected;
  }
  return recv(socket, buffer.data(), end + 1, MSG_DONTWAIT) < 0 ? Impression::none : Impression::admitted;
}

/// Told at the first, second, fourth, … time: who knocks on and on does not fill the log.
void ListeningPlant::turn_away(const char* why) {
  ++turned_away_;
  if ((turned_away_ & (turned_away_ - 1)) != 0) return;
  tell("a connection " + std::string(why) + " and was closed; " + std::to_string(turned_away_) + " so far");
}

bool ListeningPlant::take(Descriptor socket) {
  if (connected()) reason_ = "another plant has connected";
  connect(std::move(socket));
  return true;
}

}  // namespace rmpl::tools
