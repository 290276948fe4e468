// An input set that was compiled.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/plant.hpp"
#include "automata/scenario.hpp"
#include "compiler/session/compiler.hpp"

namespace rmpl::python {

/// Shared by all that is made of it, and never changed.
class Model {
 public:
  /// `texts` lie over the disk, by path. Throws Rejected, base::InputError.
  Model(const std::vector<std::string>& files, const std::map<std::string, std::string>& texts,
        const std::string& main);

  [[nodiscard]] const automata::Document& document() const { return compilation_.document(); }
  [[nodiscard]] const std::string& paths() const { return paths_; }  ///< for messages
  /// The one plant. Throws base::InputError where there is not exactly one.
  [[nodiscard]] const automata::Plant& plant() const;
  /// The one model program. Throws base::InputError likewise.
  [[nodiscard]] const automata::ModelProgram& model_program() const;
  /// The scenario of a name, or the only one. Throws base::InputError.
  [[nodiscard]] const automata::Scenario& scenario(const std::optional<std::string>& name) const;

  [[nodiscard]] std::string diagnostics() const;  ///< JSON; of what compiles, what there is to say besides
  [[nodiscard]] std::string names() const;        ///< JSON: plants, programs, model programs, scenarios
  [[nodiscard]] std::string text() const;         ///< what `rmplc compile` writes
  /// A picture in DOT, of the name or of all that there is. Throws base::InputError where there are several.
  [[nodiscard]] std::string dot(const std::string& of, std::optional<std::size_t> depth) const;

  /// Of the plant; `where` names the argument. Throw Rejected, base::InputError.
  [[nodiscard]] automata::Formula goal(const std::string& text, const std::string& where) const;
  [[nodiscard]] std::vector<automata::Assignment> assignments(const std::string& text, const std::string& where) const;

 private:
  std::string paths_;
  compiler::Compilation compilation_;
};

/// Throws base::InputError where the text is no duration; `where` names the argument.
automata::Ticks duration(const std::string& text, const std::string& where);

using ModelPointer = std::shared_ptr<const Model>;

}  // namespace rmpl::python
