// Observation files of the diagnostic competition: a scan for the last sensor line.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/competition.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "base/error.hpp"
#include "base/input_file.hpp"

namespace rmpl::tools {
namespace {

using automata::Assignment;
using base::InputError;

class SensorLine {
 public:
  SensorLine(std::string_view text, const std::string& file) : text_(text), file_(file) {
    at_ = text.rfind("sensors");
    if (at_ == std::string_view::npos) {
      throw base::InputError(file + ":1:1: error: expected a line 'sensors @TIME { name = true, ... };'");
    }
    at_ = std::min(text_.find('{', at_), text_.size());
  }

  std::vector<Assignment> read(const automata::Plant& plant) {
    expect('{');
    std::vector<Assignment> readings;
    while (peek() != '}') {
      const std::string name = word();
      expect('=');
      const std::string value = word();
      readings.push_back(reading(plant, name, value));
      if (peek() != '}') expect(',');
    }
    std::sort(readings.begin(), readings.end());
    readings.erase(std::unique(readings.begin(), readings.end()), readings.end());
    for (std::size_t i = 1; i < readings.size(); ++i) {
      if (readings[i].variable == readings[i - 1].variable) {
        fail("'" + plant.variables.name(readings[i].variable) + "' has two readings");
      }
    }
    return readings;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    const auto before = text_.substr(0, at_);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t column = at_ - std::min(before.rfind('\n') + 1, at_) + 1;
    throw base::InputError(file_ + ":" + std::to_string(line) + ":" + std::to_string(column) + ": error: " + message);
  }

  char peek() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  void expect(char wanted) {
    if (peek() != wanted) fail(std::string("expected '") + wanted + "'");
    ++at_;
  }

  std::string word() {
    peek();
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_' ||
                                  text_[at_] == '.' || text_[at_] == '-')) {
      ++at_;
    }
    if (at_ == begin) fail("expected a name");
    return std::string(text_.substr(begin, at_ - begin));
  }

  Assignment reading(const automata::Plant& plant, const std::string& name, const std::string& value) const {
    auto variable = plant.variables.find(name);
    // A gate that drives an output has the output's name in some circuits; then the reading is of its pin.
    if (!variable || plant.component_of(*variable)) variable = plant.variables.find(name + ".o");
    if (!variable) fail("the plant '" + plant.name + "' has no variable '" + name + "'");
    const auto known = plant.variables[*variable].find(value);
    if (!known) fail("'" + value + "' is no value of '" + plant.variables.name(*variable) + "'");
    return {*variable, *known};
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<automata::Assignment> competition_observation(const std::string& path, const automata::Plant& plant) {
  const std::string text = base::read_file(path);
  return SensorLine(text, path == "-" ? "standard input" : path).read(plant);
}

}  // namespace rmpl::tools
