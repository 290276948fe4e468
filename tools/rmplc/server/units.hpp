// Which files belong together: what is compiled at once for the documents that are open.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compiler/session/provider.hpp"
#include "tools/rmplc/server/documents.hpp"

namespace rmpl::tools {

/// Files that are compiled at once. With `lone`, nothing says how the file is used: whether it has an entry or a plant
/// is no question then.
struct Unit {
  std::vector<std::string> paths;
  bool lone = false;
  bool operator==(const Unit&) const = default;
};

/// Remembers who names whom, text by text.
class References {
 public:
  explicit References(compiler::Provider& texts) : texts_(texts) {}

  /// The paths of the files that a text names: imports, a scenario's program and plant. What cannot be read names none.
  const std::vector<std::string>& of(const std::string& path);
  /// Reads the text of a file anew; whether it names others than before.
  bool update(const std::string& path);
  void forget() { known_.clear(); }

 private:
  compiler::Provider& texts_;
  std::map<std::string, std::vector<std::string>> known_;  ///< by identity
};

/// The units for the documents that are open. Looked at are these, the files beside them, and those that the rmpl.toml
/// of their project names. In this order:
/// - the scenarios that lead to an open document, those of one plant together; they bring program, plant and imports;
///   with them the monitors of their set of the project, or else the only ones beside the plant;
/// - a program and a plant that the project names together, where no scenario leads to the program;
/// - properties, and monitors that are with no scenario, with the plant that the project has for them, or beside them
///   the one of their name, or the only one;
/// - for a document that no scenario leads to either, the file of its language beside it that imports it and that no
///   other imports; where there is none, the document by itself.
std::vector<Unit> units_of(const Documents& documents, References& references, compiler::Provider& texts);

}  // namespace rmpl::tools
