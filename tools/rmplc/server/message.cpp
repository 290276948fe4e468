// Reading and writing messages.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/message.hpp"

#include <cstdint>
#include <limits>

namespace rmpl::tools {
namespace {

std::string text_of(const Json& message) { return message.dump(-1, ' ', false, Json::error_handler_t::replace); }

[[noreturn]] void refuse(const std::string& what) { throw RpcError(RpcCode::invalid_request, what); }

}  // namespace

Incoming read_message(std::string_view text, Json& id) {
  id = nullptr;
  Json message = Json::parse(text, nullptr, false);
  if (message.is_discarded()) throw RpcError(RpcCode::parse_error, "the message is no JSON in UTF-8");
  if (message.is_array()) refuse("a batch of messages, expected one: the protocol has no batches");
  if (!message.is_object()) refuse("the message is no object");
  Incoming incoming;
  if (message.contains("id")) {
    const Json& own = message["id"];
    if (!own.is_string() && !own.is_number_integer() && !own.is_null()) refuse("`id`: expected a number or a string");
    incoming.id = id = own;
  }
  const auto version = message.find("jsonrpc");
  if (version == message.end() || *version != "2.0") refuse("`jsonrpc`: expected \"2.0\"");
  if (message.contains("params")) incoming.params = std::move(message["params"]);
  if (!incoming.params.is_structured() && !incoming.params.is_null())
    refuse("`params`: expected an object or an array");
  const auto method = message.find("method");
  if (method != message.end()) {
    if (!method->is_string() || method->get_ref<const std::string&>().empty()) refuse("`method`: expected a name");
    incoming.method = method->get<std::string>();
  } else if (!message.contains("result") && !message.contains("error")) {
    refuse("expected a `method`");
  }
  return incoming;
}

std::string response(const Json& id, Json result) {
  return text_of({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
}

std::string error_response(const Json& id, RpcCode code, const std::string& message) {
  return text_of({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", static_cast<int>(code)}, {"message", message}}}});
}

std::string notification(const std::string& method, Json params) {
  return text_of({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
}

const Json& member(const Json& params, const std::string& key) {
  if (params.is_object()) {
    const auto found = params.find(key);
    if (found != params.end()) return *found;
  }
  throw RpcError(RpcCode::invalid_params, "expected `" + key + "`");
}

std::string text_member(const Json& params, const std::string& key) {
  const Json& value = member(params, key);
  if (!value.is_string()) throw RpcError(RpcCode::invalid_params, "`" + key + "`: expected a string");
  return value.get<std::string>();
}

std::uint32_t number_member(const Json& params, const std::string& key) {
  const Json& value = member(params, key);
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > std::numeric_limits<std::int32_t>::max())
    throw RpcError(RpcCode::invalid_params, "`" + key + "`: expected a whole number from 0 to 2147483647");
  return value.get<std::uint32_t>();
}

}  // namespace rmpl::tools
