// Expanding top-level diagnoses by simulation, sixty-four witnesses at a time.
// SPDX-License-Identifier: MIT
#include "runtime/diagnose/expand.hpp"

#include <algorithm>
#include <array>
#include <utility>

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

void unite(std::vector<Word>& a, const std::vector<Word>& b) {
  for (std::size_t w = 0; w < a.size(); ++w) a[w] |= b[w];
}

/// The first `count` bits.
Word first(std::size_t count) { return count >= 64 ? ~Word{0} : (Word{1} << count) - 1; }

}  // namespace

Expansion::Expansion(const Circuit& circuit, const Sections& sections, const Known& known,
                     const std::vector<Word>& nominal, bool list)
    : circuit_(circuit),
      sections_(sections),
      known_(known),
      nominal_(nominal),
      list_(list),
      readers_(circuit.nets),
      words_(nominal) {
  std::vector<std::size_t> place(circuit.nets);
  for (std::size_t n = 0; n < circuit.nets; ++n) {
    if (!known[n] || !circuit.driver[n]) continue;
    place[n] = observed_.size();
    observed_.push_back(static_cast<NetId>(n));
  }
  reaches_.assign(circuit.gates.size(), Mask((observed_.size() + 63) / 64, 0));
  for (std::size_t g = circuit.gates.size(); g-- > 0;) {
    const NetId output = circuit.gates[g].output;
    if (known[output]) reaches_[g][place[output] / 64] |= Word{1} << place[output] % 64;
    for (const std::size_t reader : readers_[output]) unite(reaches_[g], reaches_[reader]);
    for (const NetId input : circuit.gates[g].inputs) {
      if (!known[input]) readers_[input].push_back(g);
    }
  }
}

boost::multiprecision::cpp_int Expansion::expand(std::span<const std::size_t> tops, const Ask& ask,
                                                 const std::function<void(const FaultSet&)>& report) {
  boost::multiprecision::cpp_int count = 1;
  std::vector<const Group*> parts;
  for (const Gates& part : groups(tops)) {
    parts.push_back(&group(part, ask));
    count *= parts.back()->count;
    if (count == 0) return 0;
  }
  if (!list_) return count;
  FaultSet faults;
  const auto combine = [&](const auto& self, std::size_t position) -> void {
    if (position == parts.size()) {
      FaultSet sorted = faults;
      std::sort(sorted.begin(), sorted.end());
      report(sorted);
      return;
    }
    for (const Gates& choice : parts[position]->choices) {
      for (const std::size_t gate : choice) faults.push_back(circuit_.gates[gate].component);
      self(self, position + 1);
      faults.resize(faults.size() - choice.size());
    }
  };
  combine(combine, 0);
  return count;
}

std::vector<Expansion::Gates> Expansion::groups(std::span<const std::size_t> tops) const {
  std::vector<std::pair<Mask, Gates>> parts;
  for (const std::size_t top : tops) {
    std::pair<Mask, Gates> joined{reaches_[top], {top}};
    std::erase_if(parts, [&](const std::pair<Mask, Gates>& part) {
      if (!meets(part.first, reaches_[top])) return false;
      unite(joined.first, part.first);
      joined.second.insert(joined.second.end(), part.second.begin(), part.second.end());
      return true;
    });
    parts.push_back(std::move(joined));
  }
  std::vector<Gates> all;
  for (auto& [mask, gates] : parts) {
    std::sort(gates.begin(), gates.end());
    all.push_back(std::move(gates));
  }
  return all;
}

std::vector<NetId> Expansion::observed(std::span<const std::size_t> gates) const {
  Mask all((observed_.size() + 63) / 64, 0);
  for (const std::size_t gate : gates) unite(all, reaches_[gate]);
  std::vector<NetId> nets;
  for (std::size_t i = 0; i < observed_.size(); ++i) {
    if (((all[i / 64] >> i % 64) & 1) != 0) nets.push_back(observed_[i]);
  }
  return nets;
}

const Expansion::Group& Expansion::group(const Gates& tops, const Ask& ask) {
  const auto [at, fresh] = groups_.try_emplace(tops);
  Group& group = at->second;
  if (!fresh) return group;
  find_cone(tops);
  const auto found = tops.size() <= exhaustive_limit ? witnesses(tops) : ask(tops);
  const auto all = choices(tops, found);
  for (const std::size_t gate : cone_) words_[circuit_.gates[gate].output] = nominal_[circuit_.gates[gate].output];
  const Mask everything((found.size() + 63) / 64, ~Word{0});
  // How many choices out of the sections so far share exactly these witnesses.
  std::map<Mask, boost::multiprecision::cpp_int> partial;
  if (!found.empty()) partial.emplace(everything, 1);
  for (const auto& section : all) {
    std::map<Mask, boost::multiprecision::cpp_int> next;
    for (const auto& [mask, count] : partial) {
      for (const Choice& choice : section) {
        if (meets(mask, choice.mask)) next[intersection(mask, choice.mask)] += count * choice.gates.size();
      }
    }
    partial = std::move(next);
  }
  for (const auto& [mask, count] : partial) group.count += count;
  if (list_ && group.count > 0) {
    Gates chosen;
    list(all, everything, chosen, group);
  }
  return group;
}

void Expansion::find_cone(const Gates& tops) {
  cone_ = tops;
  std::vector<bool> reached(circuit_.gates.size(), false);
  for (const std::size_t top : tops) reached[top] = true;
  for (std::size_t next = 0; next < cone_.size(); ++next) {
    for (const std::size_t reader : readers_[circuit_.gates[cone_[next]].output]) {
      if (!reached[reader]) cone_.push_back(reader);
      reached[reader] = true;
    }
  }
  std::sort(cone_.begin(), cone_.end());
}

/// Which of the vectors in `forced`, a word a gate, give every observed net that the group reaches its value.
Word Expansion::simulate(const Gates& tops, const std::vector<Word>& forced) {
  Word good = ~Word{0};
  std::size_t next = 0;
  for (const std::size_t g : cone_) {
    const CircuitGate& gate = circuit_.gates[g];
    const bool is_top = next < tops.size() && tops[next] == g;
    const Word value = is_top ? forced[next++] : evaluate_(gate, [&](NetId net) { return words_[net]; });
    if (known_[gate.output]) {
      good &= ~(value ^ words_[gate.output]);
    } else {
      words_[gate.output] = value;
    }
  }
  return good;
}

std::vector<Expansion::Witness> Expansion::witnesses(const Gates& tops) {
  // Bit i of the j-th pattern is bit j of i: all vectors of six values in one word.
  constexpr std::array<Word, 6> patterns{0xaaaaaaaaaaaaaaaaU, 0xccccccccccccccccU, 0xf0f0f0f0f0f0f0f0U,
                                         0xff00ff00ff00ff00U, 0xffff0000ffff0000U, 0xffffffff00000000U};
  std::vector<Witness> found;
  const std::size_t vectors = std::size_t{1} << tops.size();
  std::vector<Word> forced(tops.size());
  for (std::size_t base = 0; base < vectors; base += 64) {
    for (std::size_t j = 0; j < tops.size(); ++j) {
      forced[j] = j < patterns.size() ? patterns[j] : ((base >> j) & 1) != 0 ? ~Word{0} : 0;
    }
    const Word good = simulate(tops, forced) & first(vectors);
    for (std::size_t i = 0; i < 64; ++i) {
      if (((good >> i) & 1) == 0) continue;
      auto& witness = found.emplace_back();
      for (std::size_t j = 0; j < tops.size(); ++j) witness.push_back((((base + i) >> j) & 1) != 0);
    }
  }
  return found;
}

std::vector<std::vector<Expansion::Choice>> Expansion::choices(const Gates& tops,
                                                               const std::vector<Witness>& witnesses) {
  const std::size_t words = (witnesses.size() + 63) / 64;
  std::vector<std::map<std::size_t, Mask>> masks(tops.size());
  for (std::size_t w = 0; w < words; ++w) {
    const std::size_t used = std::min<std::size_t>(64, witnesses.size() - 64 * w);
    std::vector<Word> forced(tops.size(), 0);
    for (std::size_t i = 0; i < used; ++i) {
      for (std::size_t j = 0; j < tops.size(); ++j) {
        if (witnesses[64 * w + i][j]) forced[j] |= Word{1} << i;
      }
    }
    simulate(tops, forced);
    for (std::size_t j = 0; j < tops.size(); ++j) {
      const Gates& section = sections_.members[tops[j]];
      for (std::size_t m = 0; m < section.size(); ++m) {
        const Word served = serves(section, m, forced[j]) & first(used);
        if (served != 0) masks[j].try_emplace(section[m], Mask(words, 0)).first->second[w] = served;
      }
    }
  }
  std::vector<std::vector<Choice>> all(tops.size());
  for (std::size_t j = 0; j < tops.size(); ++j) {
    std::map<Mask, Gates> alike;
    for (const auto& [gate, mask] : masks[j]) alike[mask].push_back(gate);
    for (auto& [mask, gates] : alike) all[j].push_back({mask, std::move(gates)});
  }
  return all;
}

/// In which vectors a section gives its top gate the `forced` value while this member alone is flipped. What lies
/// outside the section does not depend on it.
Word Expansion::serves(const Gates& section, std::size_t member, Word forced) {
  if (member + 1 == section.size()) return ~Word{0};
  const auto word_of = [&](NetId net) { return words_[net]; };
  saved_.clear();
  for (std::size_t m = member; m + 1 < section.size(); ++m) saved_.push_back(words_[circuit_.gates[section[m]].output]);
  words_[circuit_.gates[section[member]].output] = ~saved_.front();
  for (std::size_t m = member + 1; m + 1 < section.size(); ++m) {
    const CircuitGate& gate = circuit_.gates[section[m]];
    words_[gate.output] = evaluate_(gate, word_of);
  }
  const Word output = evaluate_(circuit_.gates[section.back()], word_of);
  for (std::size_t m = member; m + 1 < section.size(); ++m) {
    words_[circuit_.gates[section[m]].output] = saved_[m - member];
  }
  return ~(output ^ forced);
}

void Expansion::list(const std::vector<std::vector<Choice>>& all, const Mask& mask, Gates& chosen, Group& group) {
  if (chosen.size() == all.size()) {
    group.choices.push_back(chosen);
    return;
  }
  for (const Choice& choice : all[chosen.size()]) {
    if (!meets(mask, choice.mask)) continue;
    const Mask both = intersection(mask, choice.mask);
    for (const std::size_t gate : choice.gates) {
      chosen.push_back(gate);
      list(all, both, chosen, group);
      chosen.pop_back();
    }
  }
}

}  // namespace runtime
