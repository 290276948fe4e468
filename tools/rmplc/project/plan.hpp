// What there is to do to test a project: its sets, compiled, and the calls of the other programs.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "automata/time/time.hpp"
#include "compiler/session/compiler.hpp"
#include "tools/rmplc/project/requirements.hpp"
#include "tools/shared/manifest.hpp"

namespace rmpl::tools {

/// Which tests of a project are meant.
struct TestChoice {
  std::vector<std::string> sets;  ///< by name; empty: all
  std::vector<std::string> only;  ///< patterns of which a name, a file or `file: name` matches one; empty: all
  std::string below;              ///< a folder or a file that their files are in; empty: anywhere
  std::string since;              ///< a revision of git: sets that depend on what has changed; empty: all
  std::optional<automata::Ticks> patience;  ///< how long a scenario, or a file of properties, may take

  /// Whether single tests were chosen, and not whole sets.
  [[nodiscard]] bool is_narrow() const { return !only.empty() || !below.empty(); }
  /// Whether all of the project is meant.
  [[nodiscard]] bool is_whole() const { return !is_narrow() && sets.empty() && since.empty(); }
};

/// A set with its files, compiled as one input set.
struct PlannedSet {
  std::string name;
  SetFiles files;
  compiler::Compilation compilation;
};

/// A call of another program that answers in JUnit XML.
struct PlannedCall {
  enum class Kind { scenario, properties };
  std::size_t set;
  Kind kind;
  std::string file;
  std::vector<std::string> names;      ///< of the scenario, of the properties; empty: all of the file
  std::vector<std::string> arguments;  ///< the program first, by its name
  std::vector<RequirementTag> tags;    ///< of what it flies or checks; of a set that does not compile none are known
};

struct TestPlan {
  std::vector<PlannedSet> sets;
  std::vector<PlannedCall> calls;
  std::vector<std::string> requirements;  ///< that the manifest lists; none where a part of the project is chosen
  bool lints = true;

  /// All files that the sets are made of, the manifest first; each once.
  [[nodiscard]] std::vector<std::string> files() const;
  std::string manifest;  ///< its path
};

/// A scenario is a call, and so is a file of properties. Of a set that does not compile, each file of scenarios is one.
/// Throws base::InputError where the manifest names what there is not, or nothing is chosen.
TestPlan plan_tests(const Manifest& manifest, const TestChoice& choice);

}  // namespace rmpl::tools
