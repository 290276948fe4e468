// The life of a session, and who answers what.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/server.hpp"

#include <algorithm>
#include <exception>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/uri.hpp"

namespace rmpl::tools {
namespace {

const std::map<std::string_view, Json (*)(Workspace&, const Json&)> requests = {
    {"callHierarchy/incomingCalls", incoming_calls},
    {"callHierarchy/outgoingCalls", outgoing_calls},
    {"textDocument/codeAction", code_actions},
    {"textDocument/codeLens", code_lenses},
    {"textDocument/completion", completion},
    {"textDocument/definition", definition},
    {"textDocument/documentHighlight", highlights},
    {"textDocument/documentLink", document_links},
    {"textDocument/documentSymbol", document_symbols},
    {"textDocument/foldingRange", folding_ranges},
    {"textDocument/formatting", formatting},
    {"textDocument/hover", hover},
    {"textDocument/inlayHint", inlay_hints},
    {"textDocument/prepareCallHierarchy", prepare_call_hierarchy},
    {"textDocument/prepareRename", prepare_rename},
    {"textDocument/references", references},
    {"textDocument/rename", rename},
    {"textDocument/semanticTokens/full", semantic_tokens},
    {"workspace/symbol", workspace_symbols},
};

constexpr int incremental = 2;  // TextDocumentSyncKind
constexpr int error_message = 1;

Json capabilities() {
  return {{"positionEncoding", "utf-16"},
          {"textDocumentSync", {{"openClose", true}, {"change", incremental}, {"save", true}}},
          {"hoverProvider", true},
          {"definitionProvider", true},
          {"referencesProvider", true},
          {"documentHighlightProvider", true},
          {"documentSymbolProvider", true},
          {"workspaceSymbolProvider", true},
          {"documentFormattingProvider", true},
          {"foldingRangeProvider", true},
          {"documentLinkProvider", {{"resolveProvider", false}}},
          {"inlayHintProvider", true},
          {"codeLensProvider", {{"resolveProvider", false}}},
          {"callHierarchyProvider", true},
          {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}},
          {"completionProvider", {{"triggerCharacters", {".", "="}}}},
          {"renameProvider", {{"prepareProvider", true}}},
          {"semanticTokensProvider", {{"legend", semantic_legend()}, {"full", true}}}};
}

/// The folders of the workspace; of what is no file URI, none.
std::vector<std::string> roots_in(const Json& params) {
  std::vector<std::string> roots;
  const auto add = [&](const Json& holder, const char* key) {
    const auto uri = holder.is_object() ? holder.find(key) : holder.end();
    if (uri == holder.end() || !uri->is_string()) return;
    if (auto path = path_of_uri(uri->get<std::string>())) roots.push_back(std::move(*path));
  };
  if (!params.is_object()) return roots;
  if (const auto folders = params.find("workspaceFolders"); folders != params.end() && folders->is_array()) {
    for (const Json& folder : *folders) add(folder, "uri");
  }
  if (roots.empty()) add(params, "rootUri");
  return roots;
}

}  // namespace

Server::Server(compiler::Provider& texts, Surroundings around, std::function<void(const std::string&)> send)
    : workspace_(texts, std::move(around.pages)),
      version_(std::move(around.version)),
      send_(std::move(send)),
      lints_(around.lints) {}

void Server::receive(const Frame& frame) {
  Json id;
  try {
    if (!frame.wrong.empty()) throw RpcError(RpcCode::parse_error, frame.wrong);
    Incoming message = read_message(frame.message, id);
    if (message.method != "$/cancelRequest") return waiting_.push_back(std::move(message));
    if (message.params.is_object()) cancelled_.insert(member(message.params, "id").dump());
  } catch (const RpcError& error) {
    send_(error_response(id, error.code(), error.what()));
  } catch (const std::exception& error) {
    send_(error_response(id, RpcCode::internal_error, error.what()));
  }
}

void Server::work() {
  const Incoming message = std::move(waiting_.front());
  waiting_.pop_front();
  if (message.is_request()) {
    request(message);
  } else if (!message.method.empty()) {
    notify(message);
  }
  if (waiting_.empty()) cancelled_.clear();  // what they name has been answered
}

void Server::idle() {
  if (!std::exchange(changed_, false) || stage_ != Stage::running) return;
  try {
    publish();
  } catch (const std::exception& error) {
    tell(error.what());
  }
}

Pause Server::pause() { return lints_ && stage_ == Stage::running ? linting_.pause(workspace_) : Pause{}; }

void Server::rest() {
  if (!lints_ || stage_ != Stage::running) return;
  try {
    if (!linting_.rest(workspace_)) return;
    if (!linting_.complaint().empty()) tell("not linted: " + linting_.complaint());
    publish();
  } catch (const std::exception& error) {
    tell(error.what());
  }
}

void Server::request(const Incoming& message) {
  try {
    if (cancelled_.erase(message.id.dump()) > 0)
      throw RpcError(RpcCode::request_cancelled, "the request was cancelled before it was begun");
    send_(response(message.id, answer(message)));
  } catch (const RpcError& error) {
    send_(error_response(message.id, error.code(), error.what()));
  } catch (const base::InputError& error) {
    send_(error_response(message.id, RpcCode::request_failed, error.what()));
  } catch (const std::exception& error) {
    send_(error_response(message.id, RpcCode::internal_error, error.what()));
  }
}

Json Server::answer(const Incoming& message) {
  if (message.method == "initialize") return initialize(message.params);
  if (stage_ == Stage::fresh) throw RpcError(RpcCode::not_initialized, "expected `initialize` first");
  if (stage_ == Stage::shut_down) throw RpcError(RpcCode::invalid_request, "after `shutdown` only `exit` is expected");
  if (message.method == "shutdown") {
    stage_ = Stage::shut_down;
    shut_down_ = true;
    return nullptr;
  }
  const auto handler = requests.find(message.method);
  if (handler == requests.end()) throw RpcError(RpcCode::method_not_found, "no method `" + message.method + "`");
  return handler->second(workspace_, message.params);
}

Json Server::initialize(const Json& params) {
  if (stage_ != Stage::fresh) throw RpcError(RpcCode::invalid_request, "`initialize` was already received");
  workspace_.set_roots(roots_in(params));
  stage_ = Stage::running;
  return {{"capabilities", capabilities()}, {"serverInfo", {{"name", "rmplc"}, {"version", version_}}}};
}

void Server::notify(const Incoming& message) {
  if (message.method == "exit") {
    stage_ = Stage::ended;
    return;
  }
  if (stage_ != Stage::running) return;
  try {
    const std::string& method = message.method;
    if (method == "textDocument/didOpen") {
      workspace_.open(message.params);
    } else if (method == "textDocument/didChange") {
      workspace_.change(message.params);
    } else if (method == "textDocument/didClose") {
      workspace_.close(message.params);
    } else if (method == "textDocument/didSave" || method == "workspace/didChangeWatchedFiles") {
      workspace_.disk_changed();
    } else {
      return;
    }
    changed_ = true;
  } catch (const std::exception& error) {
    tell(message.method + ": " + error.what());
  }
}

/// A notification has no answer: what is wrong with it is told beside.
void Server::tell(const std::string& what) {
  send_(notification("window/logMessage", {{"type", error_message}, {"message", what}}));
}

void Server::publish() {
  std::map<std::string, Json> found = diagnostics_by_uri(workspace_);
  for (const auto& [uri, told] : published_) found.try_emplace(uri, Json::array());
  const auto& open = workspace_.documents().all();
  for (auto& [uri, diagnostics] : found) {
    const bool none = diagnostics.empty();
    Json params = {{"uri", uri}};
    const auto document = open.find(uri);
    if (document != open.end()) params["version"] = document->second.version;
    params["diagnostics"] = std::move(diagnostics);
    std::string text = notification("textDocument/publishDiagnostics", std::move(params));
    const auto told = published_.find(uri);
    if (told != published_.end() ? told->second == text : none && document == open.end()) continue;
    send_(text);
    if (none && document == open.end()) {
      published_.erase(uri);
    } else {
      published_[uri] = std::move(text);
    }
  }
}

}  // namespace rmpl::tools
