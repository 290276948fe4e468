// The keys and the words of evidence.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/evidence_line.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "automata/assignment_text.hpp"
#include "automata/place.hpp"
#include "runtime/executive/trace/place.hpp"

namespace rmpl::runtime {
namespace {

using automata::Plant;

std::string_view name_of(Evidence::Kind kind) {
  switch (kind) {
    case Evidence::Kind::refuted:
      return "refuted";
    case Evidence::Kind::outweighed:
      return "outweighed";
    case Evidence::Kind::unavoidable:
      return "unavoidable";
  }
  return {};
}

const automata::Mode& mode_in(const Plant& plant, const automata::Modes& modes, automata::ComponentId component) {
  return plant[component].modes[modes[component.index()].index()];
}

/// Where the story differs from the estimate.
std::vector<automata::ComponentId> differences(const Evidence& evidence, const automata::Modes& estimate) {
  std::vector<automata::ComponentId> result;
  for (std::size_t c = 0; c < evidence.story.size(); ++c) {
    if (evidence.story[c] != estimate[c]) result.emplace_back(c);
  }
  return result;
}

std::string listed(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

std::string readings_of(const Evidence& evidence, const Plant& plant) {
  std::vector<std::string> texts;
  for (const automata::Assignment& reading : evidence.readings) {
    texts.push_back(to_text(plant.variables, reading));
  }
  return listed(texts);
}

std::string modes_of(const Evidence& evidence, const std::vector<automata::ComponentId>& components,
                     const Plant& plant) {
  std::vector<std::string> texts;
  for (const automata::ComponentId c : components) {
    const automata::Mode& mode = mode_in(plant, evidence.story, c);
    texts.push_back(plant[c].name + " = " + mode.name + in_parentheses(mode.origin));
  }
  return listed(texts);
}

/// `plumbing.tcca:12,15, tanks.tcca:3`; how many, where there is no source.
std::string interconnections_of(const Evidence& evidence, const Plant& plant) {
  std::string text;
  std::string_view file;
  for (const std::size_t i : evidence.interconnections) {
    const automata::Origin& origin = plant.interconnections[i].origin;
    if (origin.line == 0) {
      const std::size_t count = evidence.interconnections.size();
      return std::to_string(count) + (count == 1 ? " interconnection" : " interconnections");
    }
    if (origin.file == file) {
      text += ",";
    } else {
      text += (text.empty() ? "" : ", ") + origin.file + ":";
    }
    file = origin.file;
    text += std::to_string(origin.line);
  }
  return text;
}

/// A number above 0, rounded: from 1 to a million as whole numbers and fractions are written, beyond with an exponent.
std::string two_digits(double number) {
  if (number >= 99.5 && number < 999'999.5) {
    const double unit = std::pow(10, std::floor(std::log10(number)) - 1);
    return std::to_string(std::llround(std::round(number / unit) * unit));
  }
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::general, 2);
  return {digits.data(), end.ptr};
}

std::string text_of_refuted(const Evidence& evidence, const Plant& plant) {
  const std::string modes = modes_of(evidence, evidence.modes, plant);
  const std::string joints = interconnections_of(evidence, plant);
  return readings_of(evidence, plant) + (evidence.readings.size() == 1 ? " contradicts " : " contradict ") + modes +
         (modes.empty() || joints.empty() ? "" : " by ") + joints;
}

std::string text_of_outweighed(const Evidence& evidence, const automata::Modes& estimate, const Plant& plant) {
  std::string text = evidence.ratio > 0 ? two_digits(evidence.ratio) + " times as likely as " : "likelier than ";
  text += modes_of(evidence, differences(evidence, estimate), plant);
  if (!evidence.readings.empty()) text += ", which does not determine " + readings_of(evidence, plant);
  return text;
}

}  // namespace

Evidence::Kind evidence_named(std::string_view name) {
  for (const auto one : {Evidence::Kind::refuted, Evidence::Kind::unavoidable}) {
    if (name_of(one) == name) return one;
  }
  return Evidence::Kind::outweighed;
}

void write_evidence(JsonLine& line, const std::vector<Evidence>& evidence, const automata::Modes& estimate,
                    const Plant& plant) {
  if (evidence.empty()) return;
  line.key("evidence").open('[');
  for (const Evidence& one : evidence) {
    const automata::Component& component = plant[one.component];
    line.open('{').key("component").string(component.name).key("fault").string(component.modes[one.fault.index()].name);
    line.key("kind").string(name_of(one.kind));
    if (one.ratio > 0) line.key("ratio").number(one.ratio);
    line.key("story").open('{');
    for (const automata::ComponentId c : differences(one, estimate)) {
      line.key(plant[c].name).string(mode_in(plant, one.story, c).name);
    }
    line.close('}').key("readings").assignments(one.readings, plant.variables);
    line.key("modes").open('[');
    for (const automata::ComponentId c : one.modes) {
      const automata::Mode& mode = mode_in(plant, one.story, c);
      line.open('{').key("component").string(plant[c].name).key("mode").string(mode.name);
      write_place(line, mode.origin);
      line.close('}');
    }
    line.close(']').key("interconnections").open('[');
    for (const std::size_t i : one.interconnections) {
      line.open('{').key("number").number(i + 1);
      write_place(line, plant.interconnections[i].origin);
      line.close('}');
    }
    line.close(']').close('}');
  }
  line.close(']');
}

std::string to_text(const Evidence& evidence, const automata::Modes& estimate, const Plant& plant) {
  switch (evidence.kind) {
    case Evidence::Kind::refuted:
      return text_of_refuted(evidence, plant);
    case Evidence::Kind::outweighed:
      return text_of_outweighed(evidence, estimate, plant);
    case Evidence::Kind::unavoidable:
      return "no step from the previous belief avoids it";
  }
  return {};
}

}  // namespace rmpl::runtime
