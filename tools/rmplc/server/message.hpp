// Messages of JSON-RPC 2.0: what came in, told apart; and what goes out.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "automata/json/parse.hpp"

namespace rmpl::tools {

using automata::Json;

/// The error codes of JSON-RPC and of the protocol.
enum class RpcCode {
  parse_error = -32700,
  invalid_request = -32600,
  method_not_found = -32601,
  invalid_params = -32602,
  internal_error = -32603,
  not_initialized = -32002,
  content_modified = -32801,
  request_cancelled = -32800,
  request_failed = -32803,
};

/// Why a request has no result; becomes its answer.
class RpcError : public std::runtime_error {
 public:
  RpcError(RpcCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] RpcCode code() const { return code_; }

 private:
  RpcCode code_;
};

/// A message from the client. With an id it is a request, or without a method an answer to one of ours.
struct Incoming {
  Json id;             ///< null where there is none
  std::string method;  ///< empty in an answer
  Json params;         ///< an object, an array or null
  [[nodiscard]] bool is_request() const { return !id.is_null() && !method.empty(); }
};

/// Reads one message. Throws RpcError where it is no JSON, or no message; `id` is then what could be told of it.
Incoming read_message(std::string_view text, Json& id);

// The texts of messages that go out. Bytes that are no UTF-8 are replaced.
std::string response(const Json& id, Json result);
std::string error_response(const Json& id, RpcCode code, const std::string& message);
std::string notification(const std::string& method, Json params);

// What a request must have in its parameters. Throw RpcError (invalid params) that names the key.
const Json& member(const Json& params, const std::string& key);
std::string text_member(const Json& params, const std::string& key);
std::uint32_t number_member(const Json& params, const std::string& key);

}  // namespace rmpl::tools
