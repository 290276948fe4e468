// Expanding top-level diagnoses by simulation, sixty-four gates of a section at a time.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/expand.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rmpl::runtime {

Expansion::Expansion(const Circuit& circuit, const Sections& sections, const Known& known,
                     const std::vector<Word>& nominal, std::vector<std::size_t> cone)
    : circuit_(circuit), sections_(sections), known_(known), cone_(std::move(cone)), words_(nominal) {}

const std::vector<std::vector<std::size_t>>& Expansion::choices(std::span<const std::size_t> tops) {
  simulate(tops);
  choices_.resize(tops.size());
  for (std::size_t j = 0; j < tops.size(); ++j) choose(tops[j], choices_[j]);
  return choices_;
}

void Expansion::simulate(std::span<const std::size_t> tops) {
  const auto word_of = [&](NetId net) { return words_[net]; };
  for (const std::size_t g : cone_) {
    const CircuitGate& gate = circuit_.gates[g];
    Word value = evaluate_(gate, word_of);
    if (!tops.empty() && tops.front() == g) {
      value = ~value;
      tops = tops.subspan(1);
    }
    if (!known_[gate.output]) {
      words_[gate.output] = value;
    } else if (value != words_[gate.output]) {
      throw std::logic_error("a diagnosis that does not explain the observation");
    }
  }
}

void Expansion::choose(std::size_t top, std::vector<std::size_t>& chosen) {
  const std::vector<std::size_t>& section = sections_.members[top];
  const auto word_of = [&](NetId net) { return words_[net]; };
  const std::size_t others = section.size() - 1;
  chosen.clear();
  saved_.resize(others);
  for (std::size_t m = 0; m < others; ++m) saved_[m] = words_[circuit_.gates[section[m]].output];
  for (std::size_t base = 0; base < others; base += 64) {
    for (std::size_t m = 0; m < others; ++m) {
      const CircuitGate& gate = circuit_.gates[section[m]];
      words_[gate.output] = evaluate_(gate, word_of);
      if (m >= base && m < base + 64) words_[gate.output] ^= Word{1} << (m - base);
    }
    const CircuitGate& gate = circuit_.gates[top];
    const Word serves = ~(evaluate_(gate, word_of) ^ words_[gate.output]);
    for (std::size_t m = base; m < std::min(others, base + 64); ++m) {
      if (((serves >> (m - base)) & 1) != 0) chosen.push_back(section[m]);
    }
  }
  for (std::size_t m = 0; m < others; ++m) words_[circuit_.gates[section[m]].output] = saved_[m];
  chosen.push_back(top);
}

}  // namespace rmpl::runtime
