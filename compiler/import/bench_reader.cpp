// The `.bench` format: INPUT(n), OUTPUT(n), n = FUNCTION(a, b, …), # comments; a statement a line. Words in any case.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "compiler/check/vocabulary.hpp"
#include "compiler/import/netlist.hpp"

namespace rmpl::compiler {
namespace {

using grammar::Code;
using grammar::Span;

constexpr std::array<std::pair<std::string_view, GateFunction>, 9> bench_functions{
    {{"AND", GateFunction::conjunction},
     {"NAND", GateFunction::negated_conjunction},
     {"OR", GateFunction::disjunction},
     {"NOR", GateFunction::negated_disjunction},
     {"XOR", GateFunction::exclusive},
     {"XNOR", GateFunction::negated_exclusive},
     {"NOT", GateFunction::negation},
     {"BUFF", GateFunction::buffer},
     {"BUF", GateFunction::buffer}}};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
  return text;
}

std::string upper_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

/// `NAME(inside)`.
struct Form {
  std::string_view name;
  std::string_view inside;
};

class BenchReader {
 public:
  BenchReader(const grammar::SourceFile& file, std::uint32_t index, grammar::Diagnostics& diagnostics)
      : text_(file.text()), index_(index), errors_(diagnostics) {}

  std::optional<Netlist> run() {
    std::string_view rest = text_;
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // a byte order mark
    while (!rest.empty() && !errors_.too_many()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      std::string_view statement = rest.substr(0, end);
      rest.remove_prefix(std::min(end + 1, rest.size()));
      statement = trimmed(statement.substr(0, statement.find('#')));
      if (!statement.empty()) read(statement);
    }
    for (Net n = 0; n < names_.size(); ++n) {
      if (driver_[n] || !reader_[n]) continue;
      errors_.report(Code::netlist_driver, *reader_[n], "nothing drives the net " + backquoted(names_[n]));
    }
    if (!errors_.any() && netlist_.gates.empty()) {
      errors_.report(Code::netlist_syntax, {index_, 0, 0}, "a circuit without gates");
    }
    netlist_.nets = names_.size();
    if (!errors_.any()) report_loops(netlist_, gate_places_, errors_);
    if (errors_.any()) return std::nullopt;
    return std::move(netlist_);
  }

 private:
  [[nodiscard]] Span span(std::string_view part) const {
    const auto begin = static_cast<std::uint32_t>(part.data() - text_.data());
    return {index_, begin, begin + static_cast<std::uint32_t>(part.size())};
  }

  std::optional<Net> net(std::string_view name) {
    name = trimmed(name);
    if (!identifier_of(name)) {
      errors_.report(Code::netlist_syntax, span(name),
                     name.empty()
                         ? "expected the name of a net"
                         : backquoted(name) + " cannot be the name of a net: " + std::string(names_that_can_be_said));
      return std::nullopt;
    }
    const auto [at, fresh] = by_name_.try_emplace(std::string(name), names_.size());
    if (fresh) {
      names_.push_back(at->first);
      driver_.emplace_back();
      reader_.emplace_back();
    }
    return at->second;
  }

  void drive(Net target, std::string_view place) {
    if (!driver_[target]) {
      driver_[target] = span(trimmed(place));
    } else if (auto* error = errors_.report(Code::netlist_driver, span(trimmed(place)),
                                            "the net " + backquoted(names_[target]) + " is driven twice")) {
      error->notes.push_back({*driver_[target], "it is first driven here"});
    }
  }

  std::optional<Net> reading(std::string_view name) {
    const auto found = net(name);
    if (found && !reader_[*found]) reader_[*found] = span(trimmed(name));
    return found;
  }

  /// A whole statement, or what follows its `=`.
  std::optional<Form> form(std::string_view text) {
    const std::size_t open = text.find('(');
    if (open != std::string_view::npos && text.back() == ')') {
      return Form{trimmed(text.substr(0, open)), text.substr(open + 1, text.size() - open - 2)};
    }
    errors_.report(Code::netlist_syntax, span(text), "expected INPUT(…), OUTPUT(…) or net = GATE(…)");
    return std::nullopt;
  }

  void read(std::string_view statement) {
    const std::size_t equals = statement.find('=');
    if (equals != std::string_view::npos) {
      return read_gate(statement.substr(0, equals), statement.substr(equals + 1));
    }
    const auto port = form(statement);
    if (!port) return;
    const std::string keyword = upper_case(port->name);
    if (keyword == "INPUT") {
      const auto target = net(port->inside);
      if (!target) return;
      drive(*target, port->inside);
      netlist_.inputs.push_back({names_[*target], *target});
    } else if (keyword == "OUTPUT") {
      const auto source = reading(port->inside);
      if (!source) return;
      if (!outputs_.insert(*source).second) {
        errors_.report(Code::netlist_driver, span(trimmed(port->inside)),
                       "the output " + backquoted(names_[*source]) + " is declared twice");
      }
      netlist_.outputs.push_back({names_[*source], *source});
    } else {
      errors_.report(Code::netlist_syntax, span(port->name),
                     "expected INPUT or OUTPUT, found " + backquoted(port->name));
    }
  }

  void read_gate(std::string_view target, std::string_view call) {
    Gate gate;
    const auto output = net(target);
    if (output) {
      gate.output = *output;
      gate.name = names_[*output];
      drive(*output, target);
    }
    if (trimmed(call).empty()) {
      errors_.report(Code::netlist_syntax, span(call), "expected a gate after `=`");
      return;
    }
    if (call.find('(') == std::string_view::npos && why_unsupported(trimmed(call))) {
      refuse(trimmed(call));
      return;
    }
    const auto parts = form(trimmed(call));
    if (!parts) return;
    bool complete = output.has_value();
    for (std::string_view inside = parts->inside;;) {
      const std::size_t comma = inside.find(',');
      const auto input = reading(inside.substr(0, comma));
      if (input) gate.inputs.push_back(*input);
      complete = complete && input;
      if (comma == std::string_view::npos) break;
      inside.remove_prefix(comma + 1);
    }
    const auto* known = std::find_if(bench_functions.begin(), bench_functions.end(),
                                     [name = upper_case(parts->name)](const auto& f) { return f.first == name; });
    if (known == bench_functions.end()) {
      refuse(parts->name);
      return;
    }
    gate.function = known->second;
    if (!complete) return;
    const bool unary = gate.function == GateFunction::negation || gate.function == GateFunction::buffer;
    if (unary ? gate.inputs.size() != 1 : gate.inputs.size() < 2) {
      errors_.report(Code::netlist_gate, span(trimmed(call)),
                     "the gate " + backquoted(gate.name) + " has " + std::to_string(gate.inputs.size()) +
                         (unary ? " inputs, expected one" : " input, expected two or more"));
    }
    netlist_.gates.push_back(std::move(gate));
    gate_places_.push_back(span(trimmed(target)));
  }

  /// A gate that there is not: what it lacks, or what was meant.
  void refuse(std::string_view name) {
    if (const auto reason = why_unsupported(name)) {
      errors_.report(Code::netlist_gate, span(name), *reason);
      return;
    }
    auto* error =
        errors_.report(Code::netlist_gate, span(name),
                       "unknown gate " + backquoted(name) + ", expected AND, NAND, OR, NOR, XOR, XNOR, NOT or BUFF");
    if (error == nullptr) return;
    std::vector<std::string> known;
    for (const auto& [word, function] : bench_functions) known.emplace_back(word);
    suggest(*error, 0, upper_case(name), known);
  }

  std::string_view text_;
  std::uint32_t index_;
  NetlistErrors errors_;
  Netlist netlist_;
  std::vector<Span> gate_places_;
  std::vector<std::string> names_;  ///< of the nets
  std::unordered_map<std::string, Net> by_name_;
  std::unordered_set<Net> outputs_;
  std::vector<std::optional<Span>> driver_;  ///< of each net, where it is driven first
  std::vector<std::optional<Span>> reader_;  ///< and read first
};

}  // namespace

std::optional<Netlist> read_bench(const grammar::Sources& sources, std::uint32_t file,
                                  grammar::Diagnostics& diagnostics) {
  return BenchReader(sources[file], file, diagnostics).run();
}

}  // namespace rmpl::compiler
