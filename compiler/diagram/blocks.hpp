// A plant, or one module of it, in blocks: its components, and modules that are folded into one block each.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "automata/plant.hpp"

namespace rmpl::compiler {

/// A picture of more blocks than this is hard to read: without a depth, modules are folded until there are no more.
inline constexpr std::size_t legible_blocks = 30;

struct Block {
  std::string path;
  const automata::Component* component = nullptr;  ///< null: a module, folded
  std::size_t components = 0;                      ///< how many are in it
  std::vector<automata::VariableId> variables;     ///< but for the mode variable of a component
};

/// The blocks inside an instance (empty: the plant), in order of their first components.
class Blocks {
 public:
  /// `depth` levels of modules are opened; without it as many as are legible.
  Blocks(const automata::Plant& plant, std::string_view inside, std::optional<std::size_t> depth);

  [[nodiscard]] const std::string& inside() const { return inside_; }
  [[nodiscard]] const std::vector<Block>& all() const { return blocks_; }
  /// The block that a variable belongs to: it is of a component in it, or a port of it. None for what is outside, and
  /// for ports of modules that are open.
  [[nodiscard]] std::optional<std::size_t> block_of(automata::VariableId variable) const {
    return homes_[variable.index()];
  }
  /// The innermost open module that all these are in; the instance itself where there is none.
  [[nodiscard]] std::string module_of(const std::vector<automata::VariableId>& variables) const;
  [[nodiscard]] bool is_inside(automata::VariableId variable) const;

 private:
  [[nodiscard]] std::size_t levels() const;
  void fold(std::size_t depth);
  void find_homes();

  const automata::Plant& plant_;
  std::string inside_;
  std::vector<Block> blocks_;
  std::map<std::string, std::size_t, std::less<>> by_path_;
  std::set<std::string, std::less<>> open_;        ///< modules around blocks
  std::vector<std::optional<std::size_t>> homes_;  ///< per variable
};

/// The module that a path lies in: `mes.fuel` of `mes.fuel.tank`, nothing of `engine`.
std::string_view parent_of(std::string_view path);

}  // namespace rmpl::compiler
