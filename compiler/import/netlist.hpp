// A combinational circuit as its file gives it: ports, gates, and which net each pin is on.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

enum class GateFunction {
  conjunction,
  negated_conjunction,
  disjunction,
  negated_disjunction,
  exclusive,
  negated_exclusive,
  negation,
  buffer
};

/// A position in `Netlist::nets`.
using Net = std::size_t;

struct Gate {
  std::string name;
  GateFunction function = GateFunction::buffer;
  std::vector<Net> inputs;
  Net output = 0;
};

/// A named port: the outside drives an input, and sees an output.
struct Port {
  std::string name;
  Net net = 0;
};

struct Netlist {
  std::string name;
  std::size_t nets = 0;
  std::vector<Port> inputs, outputs;
  std::vector<Gate> gates;
};

/// Collects what is wrong with a netlist, a hundred errors at most.
class NetlistErrors {
 public:
  explicit NetlistErrors(grammar::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// The diagnostic, for notes, until the next one is added; null beyond the limit.
  grammar::Diagnostic* report(grammar::Code code, grammar::Span span, std::string message);
  [[nodiscard]] bool any() const { return count_ > 0; }
  [[nodiscard]] bool too_many() const { return count_ > limit; }

 private:
  static constexpr std::size_t limit = 100;
  grammar::Diagnostics& diagnostics_;
  std::size_t count_ = 0;
};

/// Reports each loop of gates, whose outputs would be what they make of themselves. `places`: of the gates. Nets have
/// one driver each.
void report_loops(const Netlist& netlist, const std::vector<grammar::Span>& places, NetlistErrors& errors);

/// Why a gate of other kinds is refused, by what it is called in any case of letters: memory, a table, a constant.
/// Nothing where the word is none that is known.
std::optional<std::string> why_unsupported(std::string_view gate);

/// What `identifier_of` can say, for messages.
constexpr std::string_view names_that_can_be_said = "letters, digits, `_`, `-`, `.` and bits of a bus, `a[0]`, can";

/// A name of a file as an identifier: the bit `a[0]` of a bus, or `a<0>`, is `a.0`; a name that begins with a digit
/// gets an N before it, and a word that the language reserves an underscore behind it. Nothing for what cannot be said.
std::optional<std::string> identifier_of(std::string_view name);

/// The netlist with identifiers for names. Throws base::InputError where a name cannot be one, or where two names, or a
/// name and a pin, become one.
Netlist with_identifiers(Netlist netlist);

/// Reads a netlist in the `.bench` format of the ISCAS benchmarks. A gate is named by the net that it drives; so is an
/// output. Nothing where it has errors; then they have been reported, all of them.
std::optional<Netlist> read_bench(const grammar::Sources& sources, std::uint32_t file,
                                  grammar::Diagnostics& diagnostics);

/// Reads a system catalogue of the diagnostic competition (DXC, `systemCatalog`): gates with pins `o`, `i1`, `i2` …,
/// ports, and connections. As above.
std::optional<Netlist> read_catalogue(const grammar::Sources& sources, std::uint32_t file,
                                      grammar::Diagnostics& diagnostics);

enum class FaultModel {
  weak,   ///< ok or faulty, a faulty gate being unconstrained
  strong  ///< ok, stuck-at-0, stuck-at-1, unknown, with 0.099, 0.099, 0.002 (livingstone's protocol)
};

/// The circuit as a plant in the surface language: gates are instances, ports are observed, named by
/// `with_identifiers`.
std::string to_tcca(const Netlist& netlist, FaultModel faults);

}  // namespace rmpl::compiler
