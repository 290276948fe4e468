// Models of Livingstone2, as its compiler writes them (XMPL).
//
// Livingstone2 (NASA Ames; Kurien and Nayak 2000) compiles its modelling language to clauses over variables with
// domains: components with a state variable, transitions guarded by clauses, and a rank for each failure, the negative
// decimal logarithm of its probability.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// `a=b` or `!a=b`; the right side is a value of the left one's domain, or a variable. Variables are named as of their
/// component, or in full.
struct XmplTerm {
  bool negated = false;
  std::string left, right;
};

/// Terms of which one holds; none: never.
struct XmplClause {
  std::vector<XmplTerm> terms;
  grammar::Span place;
};

struct XmplTransition {
  std::string from;  ///< a mode; `*` is any
  std::string to;
  std::optional<double> probability;  ///< of a failure
  std::vector<XmplClause> clauses;    ///< of each the transition happens where no term holds; none: always
  grammar::Span place;
};

struct XmplAttribute {
  std::string name;
  std::string type;
  grammar::Span place;
};

struct XmplComponent {
  std::string name;  ///< in full
  std::string type;
  std::string state;  ///< the attribute that is its mode; empty: it has none, as a module
  std::vector<XmplAttribute> attributes;
  std::vector<XmplClause> clauses;  ///< what holds in it
  std::vector<XmplTransition> transitions;
  grammar::Span place;
};

/// A model with its harness, which says what is commanded and seen, and its start.
struct XmplModel {
  std::string name;
  std::map<std::string, std::vector<std::string>> types;  ///< domains by name
  std::vector<XmplComponent> components;
  std::vector<std::pair<std::string, grammar::Span>> observed, commanded;  ///< in full
  std::vector<std::pair<std::string, grammar::Span>> initial;              ///< `name=value`
};

/// Adds what a file says: a model, a harness (`.hrn`) or a start (`.ini`), in any dialect: elements of the name space
/// `ci` with a term an element; elements without one, with clauses in the attribute `disj`; the same below a root
/// `mplModel`, with variables in full and what is commanded, seen and a mode told of each attribute. False where the
/// text has errors; then they have been reported.
bool read_xmpl(const grammar::Sources& sources, std::uint32_t file, XmplModel& model,
               grammar::Diagnostics& diagnostics);

/// The same of a whole model in `.l2` (L211), what Livingstone2 compiles XMPL to, where names are in it.
bool read_l2(const grammar::Sources& sources, std::uint32_t file, XmplModel& model, grammar::Diagnostics& diagnostics);

/// The model as a plant in the surface language: names are kept, components that are alike share a type, ranks become
/// probabilities. Nothing where something has no counterpart, or names what is not there; then that has been reported.
std::optional<std::string> to_tcca(const XmplModel& model, grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
