// Listening on the network: of this machine alone, unless others are to be let in.
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include "tools/shared/descriptor.hpp"

namespace rmpl::tools {

/// Why one cannot listen somewhere, in words that go behind the address.
class CannotListen : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct TcpListener {
  Descriptor socket;  ///< does not block, and no child has it
  std::string port;   ///< the one that the system chose, if 0 was asked for
  bool ipv6 = false;
};

/// `port`: a number. `remedy`: what is expected where other machines could connect and are not `remote`ly let in.
/// Throws CannotListen.
TcpListener listen_tcp(const std::string& host, const std::string& port, bool remote, const std::string& remedy);

}  // namespace rmpl::tools
