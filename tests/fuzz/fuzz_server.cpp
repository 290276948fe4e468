// Fuzzes the language server in process: the bytes as a stream of frames, and as the text of a document that is asked
// about.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "compiler/session/provider.hpp"
#include "tools/rmplc/server/server.hpp"

using namespace rmpl;

namespace {

/// A session that must answer with JSON in UTF-8, whatever comes.
class Session {
 public:
  Session()
      : server_(texts_, {"fuzz", {}, false}, [](const std::string& sent) {
          if (!tools::Json::accept(sent)) std::abort();
        }) {}

  void feed(const std::string& bytes) {
    frames_.feed(bytes);
    while (auto frame = frames_.next()) server_.receive(*frame);
    while (server_.has_work()) server_.work();
    server_.idle();
  }
  void say(const std::string& method, tools::Json params, bool request) {
    tools::Json message = {{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}};
    if (request) message["id"] = ++id_;
    feed(tools::framed(message.dump(-1, ' ', false, tools::Json::error_handler_t::replace)));
  }

 private:
  compiler::Memory texts_;
  tools::Server server_;
  tools::Frames frames_;
  int id_ = 0;
};

tools::Json place(std::uint32_t line, std::uint32_t character) { return {{"line", line}, {"character", character}}; }

/// Opens the text as a document, changes it at a place that the text says, and asks for everything there.
void edit(const std::string& text, const std::string& language) {
  Session session;
  session.say("initialize", tools::Json::object(), true);
  const tools::Json document = {{"uri", "file:///fuzz/a." + language}};
  tools::Json opened = document;
  opened["version"] = 1;
  opened["languageId"] = language;
  opened["text"] = text;
  session.say("textDocument/didOpen", {{"textDocument", opened}}, false);
  const std::uint32_t line = text.empty() ? 0 : static_cast<unsigned char>(text.front());
  const std::uint32_t character = text.empty() ? 0 : static_cast<unsigned char>(text.back()) / 4u;
  const tools::Json at = {{"textDocument", document}, {"position", place(line, character)}, {"newName", "renamed"}};
  const tools::Json range = {{"start", place(line / 2, character)}, {"end", place(line, character)}};
  tools::Json ranged = {{"textDocument", document}, {"range", range}};
  const auto ask = [&] {
    for (const char* method :
         {"hover", "definition", "references", "documentHighlight", "prepareRename", "rename", "completion",
          "documentSymbol", "foldingRange", "semanticTokens/full", "codeLens", "prepareCallHierarchy"})
      session.say(std::string("textDocument/") + method, at, true);
    session.say("textDocument/codeAction", ranged, true);
    tools::Json item = {{"uri", document["uri"]}, {"selectionRange", range}};
    for (const char* method : {"incomingCalls", "outgoingCalls"})
      session.say(std::string("callHierarchy/") + method, {{"item", item}}, true);
  };
  ask();
  const tools::Json change = {{"range", range}, {"text", text.substr(0, text.size() / 3)}};
  session.say("textDocument/didChange", {{"textDocument", document}, {"contentChanges", tools::Json::array({change})}},
              false);
  ask();
  session.say("textDocument/didClose", {{"textDocument", document}}, false);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  Session().feed(text);
  Session().feed(tools::framed(text));
  for (const char* language : {"rmpl", "tcca", "scn", "props"}) edit(text, language);
  return 0;
}
