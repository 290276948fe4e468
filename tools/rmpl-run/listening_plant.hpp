// A plant that connects to this process, over a socket of the machine or of the network.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tools/rmpl-run/live_socket.hpp"

namespace rmpl::tools {

/// One plant at a time; the newest takes the place of the one before. With a token, a connection is a plant once its
/// first line is the token, which has five seconds to come. Of those that have not shown one yet sixty-four may wait;
/// one more takes the place of the first.
class ListeningPlant final : public LiveSocket {
 public:
  /// `address` is `unix:PATH` or `tcp:HOST:PORT`; `token` is empty where none is wanted. Throws base::InputError where
  /// one cannot listen there, or where the address is no loopback and not `remote`.
  ListeningPlant(const std::string& address, bool remote, std::string token, std::function<bool()> interrupted);
  ~ListeningPlant() override;
  ListeningPlant(const ListeningPlant&) = delete;
  ListeningPlant& operator=(const ListeningPlant&) = delete;

  /// Waits for the first plant, with which time begins, for `patience` at most or until an interruption.
  void await_first(automata::Ticks patience);
  void revive(std::uint64_t cycles, automata::Ticks until) override;
  [[nodiscard]] std::string reason() const override { return reason_; }
  /// Where it listens: with the port that the system chose, if 0 was asked for.
  [[nodiscard]] const std::string& address() const { return address_; }

 private:
  void listen_on_path(const std::string& path);
  void listen_on_network(const std::string& host, const std::string& port, bool remote);
  void on_gone() override { reason_ = "it closed the connection"; }
  bool look_for_another() override;
  void await_also(std::vector<pollfd>& wanted) override;
  /// Who has connected, and has not shown its token yet.
  struct Candidate {
    Descriptor socket;
    automata::Ticks until;
  };
  enum class Impression { none, admitted, rejected };
  void accept_all();
  Impression look_at(Candidate& candidate);
  void turn_away(const char* why);
  bool take(Descriptor socket);

  std::string address_;
  std::string path_;  ///< of a socket of the machine, to be removed
  std::string token_;
  std::string reason_;
  Descriptor listener_;
  std::vector<Candidate> candidates_;  ///< in the order in which they came
  std::uint64_t turned_away_ = 0;
};

}  // namespace rmpl::tools
