// Names to addresses, addresses to sockets.
// SPDX-License-Identifier: MIT
#include "tools/shared/tcp_listener.hpp"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>

namespace rmpl::tools {
namespace {

bool is_loopback(const addrinfo& info) {
  if (info.ai_family == AF_INET6) {
    return IN6_IS_ADDR_LOOPBACK(&reinterpret_cast<const sockaddr_in6*>(info.ai_addr)->sin6_addr) != 0;
  }
  if (info.ai_family != AF_INET) return false;
  return ntohl(reinterpret_cast<const sockaddr_in*>(info.ai_addr)->sin_addr.s_addr) >> 24U == 127;
}

std::string port_of(int listener) {
  sockaddr_storage bound{};
  socklen_t size = sizeof bound;
  getsockname(listener, reinterpret_cast<sockaddr*>(&bound), &size);
  const bool six = bound.ss_family == AF_INET6;
  return std::to_string(ntohs(six ? reinterpret_cast<const sockaddr_in6&>(bound).sin6_port
                                  : reinterpret_cast<const sockaddr_in&>(bound).sin_port));
}

}  // namespace

TcpListener listen_tcp(const std::string& host, const std::string& port, bool remote, const std::string& remedy) {
  std::uint16_t number = 0;
  const auto [end, problem] = std::from_chars(port.data(), port.data() + port.size(), number);
  if (problem != std::errc{} || end != port.data() + port.size()) {
    throw CannotListen("'" + port + "' is no port; expected a number from 0 to 65535");
  }
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int error = getaddrinfo(host.c_str(), port.c_str(), &wanted, &found);
  if (error != 0) throw CannotListen(gai_strerror(error));
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(found, freeaddrinfo);
  if (!is_loopback(*found) && !remote) {
    throw CannotListen("other machines could connect; expected " + remedy);
  }
  Descriptor listener(::socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int again = 1;
  setsockopt(listener.number(), SOL_SOCKET, SO_REUSEADDR, &again, sizeof again);
  if (bind(listener.number(), found->ai_addr, found->ai_addrlen) != 0 || listen(listener.number(), SOMAXCONN) != 0) {
    throw CannotListen(std::strerror(errno));
  }
  TcpListener result{std::move(listener), {}, found->ai_family == AF_INET6};
  result.port = port_of(result.socket.number());
  return result;
}

}  // namespace rmpl::tools
