// The language server: messages in, messages out, and what it knows between them (LSP 3.17).
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "compiler/session/provider.hpp"
#include "tools/rmplc/server/linting.hpp"
#include "tools/rmplc/server/message.hpp"
#include "tools/rmplc/server/workspace.hpp"
#include "tools/shared/framing.hpp"

namespace rmpl::tools {

/// One session with a client. Whatever comes in, it answers as JSON-RPC has it and goes on; it touches no stream.
class Server {
 public:
  /// What it is told of where it runs.
  struct Surroundings {
    std::string version;
    std::string pages;  ///< the folder with a page for each code of a diagnostic; empty where there is none
    bool lints = true;  ///< whether what compiles is linted, by child processes
  };
  /// `texts` gives what is not open, and must live as long. `send` takes each message that goes out.
  Server(compiler::Provider& texts, Surroundings around, std::function<void(const std::string&)> send);

  /// Takes a frame; what it asks for waits until `work`. A request that is cancelled while it waits is answered so.
  void receive(const Frame& frame);
  /// Whether something waits.
  [[nodiscard]] bool has_work() const { return !waiting_.empty(); }
  /// Does the first of what waits.
  void work();
  /// Nothing waits: tells the diagnostics of what has changed.
  void idle();
  /// After `idle`: what to wait for besides the client, before `rest`.
  Pause pause();
  /// The pause is over, and nothing has come: lints, and tells what lint found.
  void rest();

  /// Whether the client has said `exit`.
  [[nodiscard]] bool ended() const { return stage_ == Stage::ended; }
  /// Whether it said `shutdown` before, as it should.
  [[nodiscard]] bool shut_down() const { return shut_down_; }

 private:
  enum class Stage { fresh, running, shut_down, ended };
  using Request = Json (*)(Workspace&, const Json&);

  void request(const Incoming& message);
  void notify(const Incoming& message);
  Json answer(const Incoming& message);
  Json initialize(const Json& params);
  void tell(const std::string& what);
  void publish();

  Workspace workspace_;
  std::string version_;
  std::function<void(const std::string&)> send_;
  Stage stage_ = Stage::fresh;
  bool shut_down_ = false;
  bool lints_;
  bool changed_ = false;  ///< since diagnostics were told
  std::deque<Incoming> waiting_;
  Linting linting_;
  std::set<std::string> cancelled_;               ///< ids of waiting requests, as JSON
  std::map<std::string, std::string> published_;  ///< by URI, what was told last
};

}  // namespace rmpl::tools
