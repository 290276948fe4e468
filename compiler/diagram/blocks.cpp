// Paths cut off at a depth.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/blocks.hpp"

#include <algorithm>

#include "compiler/diagram/own_names.hpp"

namespace rmpl::compiler {

std::string_view parent_of(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(0, dot);
}

Blocks::Blocks(const automata::Plant& plant, std::string_view inside, std::optional<std::size_t> depth)
    : plant_(plant), inside_(inside) {
  std::size_t opened = depth.value_or(levels());
  fold(opened);
  while (!depth && blocks_.size() > legible_blocks && opened > 0) fold(--opened);
  find_homes();
}

/// How many modules lie in each other.
std::size_t Blocks::levels() const {
  std::size_t most = 0;
  for (const automata::Component& component : plant_.components) {
    if (!is_of(component.name, inside_)) continue;
    const std::string_view own = std::string_view(component.name).substr(inside_.size());
    most = std::max(most, static_cast<std::size_t>(std::count(own.begin() + 1, own.end(), '.')));
  }
  return most;
}

void Blocks::fold(std::size_t depth) {
  blocks_.clear();
  by_path_.clear();
  for (const automata::Component& component : plant_.components) {
    const std::string& name = component.name;
    if (!is_of(name, inside_)) continue;
    std::size_t end = name.find('.', inside_.empty() ? 0 : inside_.size() + 1);
    for (std::size_t level = 0; level < depth && end != std::string::npos; ++level) end = name.find('.', end + 1);
    const std::string path = name.substr(0, end);
    const auto [at, fresh] = by_path_.emplace(path, blocks_.size());
    if (fresh) blocks_.push_back({path, path == name ? &component : nullptr, 0, {}});
    ++blocks_[at->second].components;
  }
}

bool Blocks::is_inside(automata::VariableId variable) const { return is_of(plant_.variables.name(variable), inside_); }

void Blocks::find_homes() {
  for (const Block& block : blocks_) {
    for (std::string_view path = parent_of(block.path); path.size() > inside_.size(); path = parent_of(path)) {
      open_.emplace(path);
    }
  }
  homes_.resize(plant_.variables.size());
  for (std::size_t v = 0; v < homes_.size(); ++v) {
    const std::string& name = plant_.variables.name(automata::VariableId(v));
    if (!is_of(name, inside_)) continue;
    for (std::string_view path = name; path.size() > inside_.size(); path = parent_of(path)) {
      const auto found = by_path_.find(path);
      if (found == by_path_.end()) continue;
      homes_[v] = found->second;
      if (path.size() < name.size()) blocks_[found->second].variables.emplace_back(v);
      break;
    }
  }
}

std::string Blocks::module_of(const std::vector<automata::VariableId>& variables) const {
  if (variables.empty()) return inside_;
  for (std::string_view path = parent_of(plant_.variables.name(variables.front())); path.size() > inside_.size();
       path = parent_of(path)) {
    if (!open_.contains(path)) continue;
    const auto within = [&](automata::VariableId v) { return is_of(plant_.variables.name(v), path); };
    if (std::all_of(variables.begin(), variables.end(), within)) return std::string(path);
  }
  return inside_;
}

}  // namespace rmpl::compiler
