// Names of netlists in the surface language.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <map>

#include "base/error.hpp"
#include "compiler/import/netlist.hpp"
#include "grammar/parse/scan.hpp"

namespace rmpl::compiler {
namespace {

bool is_word(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

/// `a[3][0]` and `a<3><0>` as `a.3.0`. Nothing where a bracket is left open or holds no index.
std::optional<std::string> with_points(std::string_view name) {
  std::string made;
  while (!name.empty()) {
    const std::size_t open = std::min(name.find_first_of("[]<>"), name.size());
    made += name.substr(0, open);
    name.remove_prefix(open);
    if (name.empty()) break;
    const char close = name.front() == '[' ? ']' : '>';
    const std::size_t end = name.find(close);
    if (end == std::string_view::npos || !is_word(name.substr(1, end - 1))) return std::nullopt;
    made += "." + std::string(name.substr(1, end - 1));
    name.remove_prefix(end + 1);
  }
  return made;
}

}  // namespace

std::optional<std::string> identifier_of(std::string_view name) {
  std::optional<std::string> made = with_points(name);
  if (!made || made->empty()) return std::nullopt;
  if (std::isdigit(static_cast<unsigned char>(made->front())) != 0) *made = "N" + *made;
  if (grammar::is_reserved(*made)) *made += "_";
  if (grammar::identifier_at(made->data(), made->data() + made->size()) != *made) return std::nullopt;
  return made;
}

Netlist with_identifiers(Netlist netlist) {
  // What the plant will name, and what of the file it comes from. Pins count: `a.o` is one of the gate `a`.
  std::map<std::string, std::string> origin;
  const auto take = [&](const std::string& made, const std::string& from) {
    if (const auto [at, fresh] = origin.emplace(made, from); !fresh && at->second != from) {
      throw base::InputError(at->second + " and " + from + " would both be named '" + made + "'");
    }
  };
  const auto rename = [&](std::string& name) {
    const std::optional<std::string> made = identifier_of(name);
    if (!made) throw base::InputError("'" + name + "' cannot be made a name: " + std::string(names_that_can_be_said));
    take(*made, "'" + name + "'");
    name = *made;
  };
  for (Gate& gate : netlist.gates) {
    const std::string before = gate.name;
    rename(gate.name);
    for (std::size_t i = 1; i <= gate.inputs.size(); ++i) {
      take(gate.name + ".i" + std::to_string(i), "input " + std::to_string(i) + " of the gate '" + before + "'");
    }
    take(gate.name + ".o", "the output of the gate '" + before + "'");
  }
  for (Port& port : netlist.inputs) rename(port.name);
  for (Port& port : netlist.outputs) rename(port.name);
  return netlist;
}

}  // namespace rmpl::compiler
