// Calls that lead back: what was expanded before, and with which arguments.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "compiler/check/definitions.hpp"
#include "compiler/check/recursion.hpp"

namespace rmpl::compiler {

/// The expansions of definitions, the entry and the calls, in the order in which they were opened. Refers to both.
class Expansions {
 public:
  Expansions(const Definitions& definitions, const Recursion& recursion)
      : definitions_(definitions), recursion_(recursion) {}

  /// Goes into one, the `number`th; equal texts of `arguments` are equal arguments.
  void open(std::size_t number, std::size_t definition, std::string arguments);
  /// Leaves the one that was opened last.
  void close() { open_.pop_back(); }

  /// Whether some expansion of the definition is open.
  [[nodiscard]] bool is_open(std::size_t definition) const;
  /// The expansion of the same recursive definition with the same arguments that is open: a tail call leads back to its
  /// starts.
  [[nodiscard]] std::optional<std::size_t> open_one(std::size_t definition, const std::string& arguments) const;
  /// What a call leads to instead of an expansion of its own. In a model program a call among definitions that call
  /// each other leads to what they were expanded to before, open or not, so that each is there once; but for one that
  /// starts with its caller, which only an arc around it could be.
  [[nodiscard]] std::optional<std::size_t> to_lead_to(const grammar::Call& call, std::size_t callee,
                                                      const std::string& arguments) const;

 private:
  struct Expansion {
    std::size_t definition;
    std::string arguments;
    [[nodiscard]] bool is(std::size_t other, const std::string& with) const {
      return definition == other && arguments == with;
    }
  };
  /// Whether definitions call the definition again, through whatever others.
  [[nodiscard]] bool is_recursive(std::size_t definition) const {
    return recursion_.recursive[recursion_.group[definition]];
  }

  const Definitions& definitions_;
  const Recursion& recursion_;
  std::vector<Expansion> expansions_;
  std::vector<std::size_t> open_;  ///< outermost first
};

}  // namespace rmpl::compiler
