// What Open-PSA writes for numbers: floats, parameters, arithmetic, exponentials, and the unit that time is counted in.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

#include "compiler/import/fault_tree.hpp"

namespace rmpl::compiler {

/// Elements that are nested deeper than this are refused.
inline constexpr int deepest_open_psa = 1000;

/// What an element is called by its attribute `name`, and what stands in it but for labels and attributes.
std::string open_psa_name(pugi::xml_node element);
std::vector<pugi::xml_node> open_psa_children(pugi::xml_node element);
pugi::xml_node open_psa_child(pugi::xml_node element);  ///< the first of these, or none

class OpenPsaExpressions {
 public:
  /// Keeps the reference. `file`: the number of the file, for places.
  OpenPsaExpressions(std::uint32_t file, NetlistErrors& errors) : file_(file), errors_(errors) {}

  [[nodiscard]] grammar::Span span(pugi::xml_node element) const;
  /// A definition of a parameter; an error where there is one of the name.
  void define(pugi::xml_node parameter);

  /// What a basic event is given.
  struct Chance {
    std::optional<double> probability;
    double rate = 0;  ///< per second
  };
  /// Where it is wrong an error is reported, and the answer means nothing.
  Chance chance_of(pugi::xml_node expression);
  /// The same of a number.
  double value(pugi::xml_node expression) { return value(expression, 0); }

 private:
  pugi::xml_node resolved(pugi::xml_node expression);
  double unit_of_time(pugi::xml_node expression);
  void collect_units(pugi::xml_node expression, int depth, std::set<double>& units, std::set<std::string>& seen);
  void collect_unit(pugi::xml_node element, std::set<double>& units);
  double value(pugi::xml_node expression, int depth);

  std::uint32_t file_;
  NetlistErrors& errors_;
  std::map<std::string, pugi::xml_node> parameters_;
  std::map<std::string, double> values_;  ///< of parameters
};

/// A number as messages tell it.
std::string open_psa_number(double number);

}  // namespace rmpl::compiler
