// A plant that does whatever a plant may do wrong, at random moments of a machine whose time costs nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <deque>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "runtime/executive/live/channel.hpp"
#include "runtime/executive/plant/random_source.hpp"

namespace rmpl::runtime {

/// Answers most commands, soon; else it is late, silent, mad, in a flood, slow to read or dead, each some hundred times
/// a day. Keeps account of what reached it whole, and of which answers went out while their cycle lasted.
class MadPlant final : public Channel {
 public:
  MadPlant(std::uint64_t seed, automata::Ticks cycle) : random_(seed), cycle_(cycle) {}

  [[nodiscard]] automata::Ticks now() const override { return now_; }
  [[nodiscard]] bool connected() const override { return connected_; }
  [[nodiscard]] std::string reason() const override { return "it has had enough"; }

  std::size_t send(std::string_view bytes) override {
    if (!connected_ || now_ < reads_again_) return 0;
    const std::size_t taken = random_.below(50) == 0 ? random_.below(bytes.size()) : bytes.size();
    if (taken < bytes.size()) reads_again_ = now_ + some_cycles(3);
    heard_ += bytes.substr(0, taken);
    while (connected_ && heard_.find('\n') != std::string::npos) {
      const std::string line = heard_.substr(0, heard_.find('\n'));
      heard_.erase(0, line.size() + 1);
      act(nlohmann::json::parse(line));  // throws where lines were garbled
    }
    return taken;
  }

  News wait(automata::Ticks until, bool to_send, std::string& bytes) override {
    if (!connected_) {
      const bool comes = comes_back_ <= until;
      now_ = std::max(now_, comes ? comes_back_ : until);
      if (comes) come();
      return comes ? News::connected : News::none;
    }
    const automata::Ticks next = outbound_.empty() ? automata::Ticks::infinite() : outbound_.front().at;
    if (to_send && reads_again_ <= std::min(until, next)) {
      now_ = std::max(now_, reads_again_);
      return News::sendable;
    }
    if (next > until) {
      now_ = std::max(now_, until);
      return News::none;
    }
    now_ = std::max(now_, next);
    const Outbound sent = std::move(outbound_.front());
    outbound_.pop_front();
    if (sent.last) {
      connected_ = false;
      outbound_.clear();
      heard_.clear();
      comes_back_ = now_ + some_cycles(20);
      return News::gone;
    }
    bytes = sent.bytes;
    if (sent.answers == asked_ && now_ <= end_of(asked_)) in_time.insert(sent.answers);
    return News::received;
  }

  void revive(std::uint64_t /*cycles*/, automata::Ticks until) override {
    const bool comes = comes_back_ <= until;
    now_ = std::max(now_, comes ? comes_back_ : until);
    if (comes) come();
  }

  std::set<std::uint64_t> heard;    ///< cycles whose command came whole
  std::set<std::uint64_t> in_time;  ///< cycles that were answered while they lasted
  std::uint64_t comings = 0;
  std::uint64_t asked_ = 0;  ///< the cycle that lasts, which the test says

 private:
  struct Outbound {
    automata::Ticks at;
    std::string bytes;
    std::uint64_t answers = 0;  ///< 0: no cycle
    bool last = false;          ///< the connection ends
  };

  [[nodiscard]] automata::Ticks end_of(std::uint64_t cycle) const {
    return {cycle_.count * static_cast<std::int64_t>(cycle)};
  }
  automata::Ticks some_cycles(std::size_t most) {
    return {
        static_cast<std::int64_t>(random_.uniform() * static_cast<double>(most) * static_cast<double>(cycle_.count))};
  }
  void come() {
    connected_ = true;
    ++comings;
    last_ = 0;
    reads_again_ = now_;
  }
  void say(std::string bytes, std::uint64_t answers = 0) {
    const automata::Ticks at{now_.count + cycle_.count / 10};
    outbound_.push_back({outbound_.empty() ? at : std::max(at, outbound_.back().at), std::move(bytes), answers, false});
  }
  static std::string answer(std::uint64_t cycle) {
    return R"({"cycle":)" + std::to_string(cycle) + R"(,"observations":{"heater.temp":")" +
           (cycle % 7 == 0 ? "low" : "high") + "\"}}\n";
  }
  std::string noise() {
    std::string text;
    for (std::size_t left = random_.below(200); left > 0; --left) text += static_cast<char>(random_.below(256));
    return text + "\n";
  }

  void act(const nlohmann::json& command) {
    const auto cycle = command.at("cycle").get<std::uint64_t>();
    heard.insert(cycle);
    if (cycle <= last_) throw std::logic_error("a command that came twice, or late, to one plant");
    last_ = cycle;
    const std::size_t mood = random_.below(400);
    switch (mood) {
      case 0:  // late, and with the next answer behind it
        say(answer(cycle), cycle);
        outbound_.back().at += some_cycles(6);
        return;
      case 1:  // silent
        return;
      case 2:
        say(noise());
        break;
      case 3:
        say(std::string(200'000, 'x') + "\n");
        break;
      case 4:
        say(R"({"cycle":)" + std::to_string(cycle + 1000) + "}\n");
        break;
      case 5:
        say(R"({"observations":{"heater.temp":"high"}})"
            "\n"
            R"({"cycle":1,"observations":{"heater":"on"}})"
            "\n");
        break;
      case 6: {
        std::string flood;
        for (int i = 0; i < 3000; ++i) flood += answer(cycle > 1 ? cycle - 1 : 0);
        say(flood);
        return;
      }
      case 7:  // dead, in the middle of a line
        say(R"({"cycle":)");
        outbound_.push_back({outbound_.back().at + some_cycles(2), "", 0, true});
        return;
      default:
        break;
    }
    say(answer(cycle), cycle);
  }

  RandomSource random_;
  automata::Ticks cycle_, now_, reads_again_, comes_back_;
  bool connected_ = false;
  std::uint64_t last_ = 0;  ///< cycle that this connection was told of
  std::string heard_;
  std::deque<Outbound> outbound_;
};

}  // namespace rmpl::runtime
