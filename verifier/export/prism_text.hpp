// Words of PRISM's language: names, numbers and conditions.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "automata/plant.hpp"

namespace rmpl::verifier::prism {

/// What the components and commands that a module speaks of are called in it, by number.
struct Naming {
  std::vector<std::size_t> components;  ///< by component
  std::vector<std::size_t> labels;      ///< by class of control actions

  [[nodiscard]] std::string mode(automata::ComponentId component) const {
    return "m" + std::to_string(components[component.index()]);
  }
  [[nodiscard]] std::string clock(automata::ComponentId component) const {
    return "x" + std::to_string(components[component.index()]);
  }
  [[nodiscard]] std::string label(std::size_t action) const { return "a" + std::to_string(labels[action]); }
};

/// In the language of PRISM; whether it falls apart in a conjunction.
struct Text {
  std::string text;
  bool either = false;

  [[nodiscard]] std::string operand() const { return either ? "(" + text + ")" : text; }
};

/// The shortest decimal that reads back the same.
std::string number(double value);
/// The values of a variable, of so many, ascending. With `listed` each is named: it may have others.
Text member_text(const std::string& name, const std::vector<std::size_t>& values, std::size_t all, bool listed);
/// A formula over modes, of constants, members, conjunctions and disjunctions.
Text text_of(const automata::Formula& formula, const automata::Plant& plant, const Naming& naming);
/// A conjunction that grows; empty where nothing is demanded.
void conjoin(std::string& all, const std::string& part);

}  // namespace rmpl::verifier::prism
