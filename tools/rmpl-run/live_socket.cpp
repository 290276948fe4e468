// Sockets, without a signal where the other side is gone, and without a wait that nobody asked for.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/live_socket.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace rmpl::tools {
namespace {

constexpr automata::Ticks slice{automata::Ticks::per_second / 20};  // between two looks for an interruption
constexpr std::size_t at_once = std::size_t{1} << 16U;              // bytes received

timespec time_of(automata::Ticks ticks) {
  return {static_cast<time_t>(ticks.count / automata::Ticks::per_second),
          static_cast<long>(ticks.count % automata::Ticks::per_second)};
}

}  // namespace

short wait_for(int descriptor, bool writable, automata::Ticks patience) {
  pollfd wanted{descriptor, static_cast<short>(writable ? POLLIN | POLLOUT : POLLIN), 0};
  const timespec time = time_of(std::max(patience, automata::Ticks{}));
  return ppoll(&wanted, 1, &time, nullptr) > 0 ? wanted.revents : short{0};
}

automata::Ticks LiveSocket::now() const {
  return {std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - start_).count()};
}

std::size_t LiveSocket::send(std::string_view bytes) {
  if (!socket_.open()) return 0;
  // Where this fails for good, the next wait finds the connection at its end.
  const ssize_t sent = ::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  return sent > 0 ? static_cast<std::size_t>(sent) : 0;
}

LiveSocket::News LiveSocket::receive(std::string& bytes) {
  std::array<char, at_once> buffer;
  const ssize_t got = recv(socket_.number(), buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (got > 0) {
    bytes.assign(buffer.data(), static_cast<std::size_t>(got));
    return News::received;
  }
  if (got < 0 && (errno == EAGAIN || errno == EINTR)) return News::none;
  on_gone();
  socket_.close();
  return News::gone;
}

void LiveSocket::gather(bool to_send) {
  awaited_.assign(1, {socket_.number(), static_cast<short>(to_send ? POLLIN | POLLOUT : POLLIN), 0});
  await_also(awaited_);
}

/// The plant that is there comes first: what it sent, and its end, are news before another's arrival.
LiveSocket::News LiveSocket::wait(automata::Ticks until, bool to_send, std::string& bytes) {
  do {
    const automata::Ticks patience = std::min(slice, until - now());
    gather(to_send);
    const timespec time = time_of(std::max(patience, automata::Ticks{}));
    if (ppoll(awaited_.data(), awaited_.size(), &time, nullptr) <= 0) continue;
    if ((awaited_[0].revents & (POLLIN | POLLHUP | POLLERR)) != 0) {
      const News news = receive(bytes);
      if (news != News::none) return news;
    }
    if ((awaited_[0].revents & POLLOUT) != 0) return News::sendable;
    const bool another =
        std::any_of(awaited_.begin() + 1, awaited_.end(), [](const pollfd& other) { return other.revents != 0; });
    if (another && look_for_another()) return News::connected;
  } while (now() < until && !interrupted());
  return News::none;
}

}  // namespace rmpl::tools
