// Which expansion a call leads back to.
// SPDX-License-Identifier: MIT
#include "compiler/lower/expansions.hpp"

#include <algorithm>
#include <utility>

#include "base/check.hpp"

namespace rmpl::compiler {

void Expansions::open(std::size_t number, std::size_t definition, std::string arguments) {
  CHECK(number == expansions_.size() && "expansions are numbered as they are opened");
  expansions_.push_back({definition, std::move(arguments)});
  open_.push_back(number);
}

bool Expansions::is_open(std::size_t definition) const {
  return std::any_of(open_.begin(), open_.end(),
                     [&](std::size_t e) { return expansions_[e].definition == definition; });
}

std::optional<std::size_t> Expansions::open_one(std::size_t definition, const std::string& arguments) const {
  if (!is_recursive(definition)) return std::nullopt;
  const auto found =
      std::find_if(open_.begin(), open_.end(), [&](std::size_t e) { return expansions_[e].is(definition, arguments); });
  return found == open_.end() ? std::nullopt : std::optional(*found);
}

std::optional<std::size_t> Expansions::to_lead_to(const grammar::Call& call, std::size_t callee,
                                                  const std::string& arguments) const {
  const bool anew = definitions_.immediate.count(&call) != 0;
  if (!definitions_.model || !is_recursive(callee) || anew) return open_one(callee, arguments);
  const std::size_t group = recursion_.group[callee];
  const auto outermost = std::find_if(
      open_.begin(), open_.end(), [&](std::size_t e) { return recursion_.group[expansions_[e].definition] == group; });
  if (outermost == open_.end()) return std::nullopt;
  for (std::size_t e = *outermost; e < expansions_.size(); ++e) {
    if (expansions_[e].is(callee, arguments)) return e;
  }
  return std::nullopt;
}

}  // namespace rmpl::compiler
