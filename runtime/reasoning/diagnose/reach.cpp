// Reachability, from the outputs back in one pass.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/reach.hpp"

#include <algorithm>
#include <utility>

namespace rmpl::runtime {
namespace {

bool meets(const std::vector<Word>& a, const std::vector<Word>& b) {
  for (std::size_t w = 0; w < a.size(); ++w) {
    if ((a[w] & b[w]) != 0) return true;
  }
  return false;
}

void unite(std::vector<Word>& a, const std::vector<Word>& b) {
  for (std::size_t w = 0; w < a.size(); ++w) a[w] |= b[w];
}

}  // namespace

Reach::Reach(const Circuit& circuit, const Known& known) : circuit_(circuit), readers_(circuit.nets) {
  std::vector<std::size_t> place(circuit.nets);
  for (std::size_t n = 0; n < circuit.nets; ++n) {
    if (!known[n] || !circuit.driver[n]) continue;
    place[n] = observed_.size();
    observed_.push_back(static_cast<NetId>(n));
  }
  masks_.assign(circuit.gates.size(), Mask((observed_.size() + 63) / 64, 0));
  for (std::size_t g = circuit.gates.size(); g-- > 0;) {
    const NetId output = circuit.gates[g].output;
    if (known[output]) masks_[g][place[output] / 64] |= Word{1} << place[output] % 64;
    for (const std::size_t reader : readers_[output]) unite(masks_[g], masks_[reader]);
    for (const NetId input : circuit.gates[g].inputs) {
      if (!known[input]) readers_[input].push_back(g);
    }
  }
}

std::vector<std::vector<std::size_t>> Reach::groups(std::span<const std::size_t> gates) const {
  std::vector<std::pair<Mask, std::vector<std::size_t>>> parts;
  for (const std::size_t gate : gates) {
    std::pair<Mask, std::vector<std::size_t>> joined{masks_[gate], {gate}};
    std::erase_if(parts, [&](const auto& part) {
      if (!meets(part.first, masks_[gate])) return false;
      unite(joined.first, part.first);
      joined.second.insert(joined.second.end(), part.second.begin(), part.second.end());
      return true;
    });
    parts.push_back(std::move(joined));
  }
  std::vector<std::vector<std::size_t>> all;
  for (auto& [mask, members] : parts) {
    std::sort(members.begin(), members.end());
    all.push_back(std::move(members));
  }
  return all;
}

std::vector<NetId> Reach::observed(std::span<const std::size_t> gates) const {
  Mask all((observed_.size() + 63) / 64, 0);
  for (const std::size_t gate : gates) unite(all, masks_[gate]);
  std::vector<NetId> nets;
  for (std::size_t i = 0; i < observed_.size(); ++i) {
    if (((all[i / 64] >> i % 64) & 1) != 0) nets.push_back(observed_[i]);
  }
  return nets;
}

std::vector<std::size_t> Reach::cone(std::span<const std::size_t> gates) const {
  std::vector<std::size_t> cone(gates.begin(), gates.end());
  std::vector<bool> reached(circuit_.gates.size(), false);
  for (const std::size_t gate : gates) reached[gate] = true;
  for (std::size_t next = 0; next < cone.size(); ++next) {
    for (const std::size_t reader : readers_[circuit_.gates[cone[next]].output]) {
      if (!reached[reader]) cone.push_back(reader);
      reached[reader] = true;
    }
  }
  std::sort(cone.begin(), cone.end());
  return cone;
}

}  // namespace rmpl::runtime
