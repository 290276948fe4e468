// The definitions of a program, who calls whom and in what position, and where execution enters.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "grammar/ast/program.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// A file of a program set. The files named by the user are roots; those that an import brought are not.
struct ProgramSource {
  const grammar::ProgramFile* file;
  bool root;
};

/// One call as written.
struct CallSite {
  const grammar::Call* call;
  std::size_t callee;  ///< position in `Definitions::all`
  /// Why the call is not the last thing that its definition does, for messages; empty where it is.
  std::string not_last;
  /// Nothing happens before the call: no location is passed between entering the definition and entering the callee.
  bool immediate;
  bool whole;  ///< the definition consists of the call
};

/// The definitions in order of the text, with their calls.
struct Definitions {
  struct Entry {
    const grammar::Definition* definition;
    bool root;                    ///< from a file that the user named
    bool called = false;          ///< by another definition
    std::vector<CallSite> calls;  ///< with the right number of arguments, to known definitions
  };
  std::vector<Entry> all;
  std::unordered_map<std::string, std::size_t> by_name;
  std::unordered_map<const grammar::Call*, std::size_t> callees;  ///< of every call that is collected
  std::unordered_set<const grammar::Call*> immediate;             ///< the calls that are, as their site says
  std::set<std::string> unknown;                                  ///< called and not there; each is reported once
  bool model = false;                                             ///< a model program: it tells what holds
  bool mixed = false;                                             ///< model and control definitions: reported
};

/// Collects the definitions. Reports double names and parameters, unknown callees, wrong numbers of arguments, what
/// belongs in model programs only, and model and control definitions side by side.
Definitions collect_definitions(const std::vector<ProgramSource>& files, grammar::Diagnostics& diagnostics);

/// The entry point: the definition of that name, or where `main` is empty the one that no other calls. Definitions that
/// came by import are candidates only where no other is left. Nothing where there is none, or where several are left;
/// then it has been reported, at `blame` where no definition is to blame; but for several, where a call of a definition
/// that is not there has been reported: it may have been meant for one of them.
std::optional<std::size_t> find_entry(const Definitions& definitions, const std::string& main,
                                      std::optional<grammar::Span> main_span, grammar::Span blame,
                                      grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
