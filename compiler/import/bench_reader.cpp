// The `.bench` format: INPUT(n), OUTPUT(n), n = FUNCTION(a, b, …), # comments.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "automata/error.hpp"
#include "compiler/import/netlist.hpp"

namespace compiler {
namespace {

constexpr std::array<std::pair<std::string_view, GateFunction>, 8> functions{
    {{"AND", GateFunction::conjunction},
     {"NAND", GateFunction::negated_conjunction},
     {"OR", GateFunction::disjunction},
     {"NOR", GateFunction::negated_disjunction},
     {"XOR", GateFunction::exclusive},
     {"NOT", GateFunction::negation},
     {"BUFF", GateFunction::buffer},
     {"BUF", GateFunction::buffer}}};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
  return text;
}

class BenchReader {
 public:
  BenchReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  Netlist run() {
    for (; !text_.empty(); ++line_) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      std::string_view statement = text_.substr(0, end);
      text_.remove_prefix(std::min(end + 1, text_.size()));
      statement = trimmed(statement.substr(0, statement.find('#')));
      if (!statement.empty()) read(statement);
    }
    for (const auto& [net, line] : used_) {
      if (!driven_.contains(net)) fail(line, "nothing drives the net '" + names_[net] + "'");
    }
    if (netlist_.gates.empty()) fail(line_, "a circuit without gates");
    netlist_.nets = names_.size();
    return std::move(netlist_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& message) const {
    throw automata::InputError(file_ + ":" + std::to_string(line) + ":1: error: " + message);
  }

  Net net(std::string_view name) {
    name = trimmed(name);
    if (name.empty()) fail(line_, "expected the name of a net");
    const bool plain =
        std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
    if (!plain) fail(line_, "'" + std::string(name) + "' is no name of a net: letters, digits and '_' are");
    const auto [at, fresh] = by_name_.try_emplace(std::string(name), names_.size());
    if (fresh) names_.push_back(at->first);
    return at->second;
  }

  void drive(Net target) {
    if (!driven_.insert(target).second) fail(line_, "the net '" + names_[target] + "' is driven twice");
  }

  /// What stands between the parentheses of `NAME(…)`, which must close the statement.
  std::string_view arguments(std::string_view call) const {
    const std::size_t open = call.find('(');
    if (open == std::string_view::npos || call.back() != ')')
      fail(line_, "expected INPUT(…), OUTPUT(…) or net = GATE(…)");
    return call.substr(open + 1, call.size() - open - 2);
  }

  void read(std::string_view statement) {
    const std::size_t equals = statement.find('=');
    if (equals != std::string_view::npos)
      return read_gate(statement.substr(0, equals), trimmed(statement.substr(equals + 1)));
    const std::string_view inside = arguments(statement);
    const std::string_view keyword = trimmed(statement.substr(0, statement.find('(')));
    const Net port = net(inside);
    if (keyword == "INPUT") {
      drive(port);
      netlist_.inputs.push_back({names_[port], port});
    } else if (keyword == "OUTPUT") {
      used_.emplace_back(port, line_);
      netlist_.outputs.push_back({names_[port], port});
    } else {
      fail(line_, "expected INPUT or OUTPUT, found '" + std::string(keyword) + "'");
    }
  }

  void read_gate(std::string_view target, std::string_view call) {
    if (call.empty()) fail(line_, "expected a gate after '='");
    std::string_view inside = arguments(call);
    std::string name(trimmed(call.substr(0, call.find('('))));
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const auto* known =
        std::find_if(functions.begin(), functions.end(), [&](const auto& f) { return f.first == name; });
    if (known == functions.end()) fail(line_, "unknown gate '" + name + "'");
    Gate gate;
    gate.function = known->second;
    gate.output = net(target);
    gate.name = names_[gate.output];
    drive(gate.output);
    for (;;) {
      const std::size_t comma = inside.find(',');
      gate.inputs.push_back(net(inside.substr(0, comma)));
      used_.emplace_back(gate.inputs.back(), line_);
      if (comma == std::string_view::npos) break;
      inside.remove_prefix(comma + 1);
    }
    const bool unary = gate.function == GateFunction::negation || gate.function == GateFunction::buffer;
    if (unary ? gate.inputs.size() != 1 : gate.inputs.size() < 2) {
      fail(line_, "the gate '" + gate.name + "' has the wrong number of inputs");
    }
    netlist_.gates.push_back(std::move(gate));
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t line_ = 1;
  Netlist netlist_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, Net> by_name_;
  std::unordered_set<Net> driven_;
  std::vector<std::pair<Net, std::size_t>> used_;
};

}  // namespace

Netlist read_bench(std::string_view text, const std::string& file) { return BenchReader(text, file).run(); }

}  // namespace compiler
