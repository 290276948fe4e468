// Expanding top-level diagnoses by simulation, sixty-four witnesses at a time.
// SPDX-License-Identifier: MIT
#include "runtime/diagnose/expand.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace runtime {
namespace {

bool meets(const std::vector<Word>& a, const std::vector<Word>& b) {
  for (std::size_t w = 0; w < a.size(); ++w) {
    if ((a[w] & b[w]) != 0) return true;
  }
  return false;
}

std::vector<Word> intersection(const std::vector<Word>& a, const std::vector<Word>& b) {
  std::vector<Word> both(a.size());
  for (std::size_t w = 0; w < a.size(); ++w) both[w] = a[w] & b[w];
  return both;
}

}  // namespace

Expansion::Expansion(const Circuit& circuit, const Sections& sections, const Known& known)
    : circuit_(circuit), sections_(sections), known_(known), words_(circuit.nets, 0), flipped_(circuit.nets, 0) {
  for (std::size_t n = 0; n < circuit.nets; ++n) {
    if (!circuit.driver[n]) words_[n] = known[n].value_or(false) ? ~Word{0} : 0;
  }
}

void Expansion::simulate(std::span<const std::size_t> tops, const std::vector<Word>& forced) {
  for (std::size_t g = 0; g < circuit_.gates.size(); ++g) {
    if (!sections_.top[g]) continue;
    const CircuitGate& gate = circuit_.gates[g];
    const auto at = std::find(tops.begin(), tops.end(), g);
    words_[gate.output] = at != tops.end() ? forced[static_cast<std::size_t>(at - tops.begin())]
                                           : evaluate_(gate, [&](NetId net) { return words_[net]; });
  }
}

std::vector<std::vector<bool>> Expansion::witnesses(std::span<const std::size_t> tops) {
  // Bit i of the j-th pattern is bit j of i: all vectors of six values in one word.
  constexpr std::array<Word, 6> patterns{0xaaaaaaaaaaaaaaaaU, 0xccccccccccccccccU, 0xf0f0f0f0f0f0f0f0U,
                                         0xff00ff00ff00ff00U, 0xffff0000ffff0000U, 0xffffffff00000000U};
  std::vector<std::vector<bool>> found;
  const std::size_t vectors = std::size_t{1} << tops.size();
  std::vector<Word> forced(tops.size());
  for (std::size_t base = 0; base < vectors; base += 64) {
    for (std::size_t j = 0; j < tops.size(); ++j) {
      forced[j] = j < patterns.size() ? patterns[j] : ((base >> j) & 1) != 0 ? ~Word{0} : 0;
    }
    simulate(tops, forced);
    Word good = vectors >= 64 ? ~Word{0} : (Word{1} << vectors) - 1;
    for (std::size_t n = 0; n < circuit_.nets && good != 0; ++n) {
      const auto& driver = circuit_.driver[n];
      if (driver && known_[n] && sections_.top[*driver]) good &= *known_[n] ? words_[n] : ~words_[n];
    }
    for (std::size_t i = 0; i < 64 && base + i < vectors; ++i) {
      if (((good >> i) & 1) == 0) continue;
      auto& witness = found.emplace_back();
      for (std::size_t j = 0; j < tops.size(); ++j) witness.push_back((((base + i) >> j) & 1) != 0);
    }
  }
  return found;
}

std::vector<std::vector<Expansion::Choice>> Expansion::choices(std::span<const std::size_t> tops,
                                                               const std::vector<std::vector<bool>>& witnesses) {
  const std::size_t words = (witnesses.size() + 63) / 64;
  std::vector<std::map<std::size_t, Mask>> masks(tops.size());
  for (std::size_t w = 0; w < words; ++w) {
    const std::size_t used = std::min<std::size_t>(64, witnesses.size() - 64 * w);
    const Word valid = used == 64 ? ~Word{0} : (Word{1} << used) - 1;
    std::vector<Word> forced(tops.size(), 0);
    for (std::size_t i = 0; i < used; ++i) {
      for (std::size_t j = 0; j < tops.size(); ++j) {
        if (witnesses[64 * w + i][j]) forced[j] |= Word{1} << i;
      }
    }
    simulate(tops, forced);
    for (std::size_t j = 0; j < tops.size(); ++j) {
      const auto& members = sections_.members[tops[j]];
      for (std::size_t m = 0; m < members.size(); ++m) {
        Word serves = valid;
        if (members[m] != tops[j]) {
          // The section again, with this one gate flipped; what lies outside does not depend on it.
          flipped_ = words_;
          const auto word_of = [&](NetId net) { return flipped_[net]; };
          const CircuitGate& gate = circuit_.gates[members[m]];
          flipped_[gate.output] = ~evaluate_(gate, word_of);
          for (std::size_t later = m + 1; later < members.size(); ++later) {
            const CircuitGate& next = circuit_.gates[members[later]];
            flipped_[next.output] = evaluate_(next, word_of);
          }
          const NetId output = circuit_.gates[tops[j]].output;
          serves &= ~(flipped_[output] ^ forced[j]);
        }
        if (serves == 0) continue;
        auto& mask = masks[j].try_emplace(members[m], Mask(words, 0)).first->second;
        mask[w] = serves;
      }
    }
  }
  std::vector<std::vector<Choice>> all(tops.size());
  for (std::size_t j = 0; j < tops.size(); ++j) {
    std::map<Mask, std::vector<std::size_t>> groups;
    for (const auto& [gate, mask] : masks[j]) groups[mask].push_back(gate);
    for (auto& [mask, gates] : groups) all[j].push_back({mask, std::move(gates)});
  }
  return all;
}

boost::multiprecision::cpp_int Expansion::expand(std::span<const std::size_t> tops,
                                                 const std::vector<std::vector<bool>>& witnesses,
                                                 const std::function<void(const FaultSet&)>& report) {
  const auto all = choices(tops, witnesses);
  const Mask everything((witnesses.size() + 63) / 64, ~Word{0});
  // How many choices out of the sections so far share exactly these witnesses.
  std::map<Mask, boost::multiprecision::cpp_int> partial{{everything, 1}};
  for (const auto& section : all) {
    std::map<Mask, boost::multiprecision::cpp_int> next;
    for (const auto& [mask, count] : partial) {
      for (const Choice& choice : section) {
        if (meets(mask, choice.mask)) next[intersection(mask, choice.mask)] += count * choice.gates.size();
      }
    }
    partial = std::move(next);
  }
  boost::multiprecision::cpp_int total = 0;
  for (const auto& [mask, count] : partial) total += count;
  if (report) {
    FaultSet chosen;
    list(all, 0, everything, chosen, report);
  }
  return total;
}

void Expansion::list(const std::vector<std::vector<Choice>>& all, std::size_t position, const Mask& mask,
                     FaultSet& chosen, const std::function<void(const FaultSet&)>& report) const {
  if (position == all.size()) {
    FaultSet sorted = chosen;
    std::sort(sorted.begin(), sorted.end());
    report(sorted);
    return;
  }
  for (const Choice& choice : all[position]) {
    if (!meets(mask, choice.mask)) continue;
    const Mask both = intersection(mask, choice.mask);
    for (const std::size_t gate : choice.gates) {
      chosen.push_back(circuit_.gates[gate].component);
      list(all, position + 1, both, chosen, report);
      chosen.pop_back();
    }
  }
}

}  // namespace runtime
