// A combinational circuit as its file gives it: ports, gates, and which net each pin is on.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
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

/// The circuit as a plant in the surface language: gates are instances named as in the file (with an N before a name
/// that begins with a digit), ports are observed. Throws base::InputError where two names cannot be told apart then.
std::string to_tcca(const Netlist& netlist, FaultModel faults);

}  // namespace rmpl::compiler
