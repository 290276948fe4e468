// What the properties of a project speak of.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "compiler/session/compiler.hpp"
#include "tools/shared/manifest.hpp"

namespace rmpl::tools {

struct PropertySubject {
  std::string plant;
  std::string program = {};  ///< empty: none
  std::string main = {};     ///< the definition to start with; empty: the only one
};

/// Of a set that has properties: what the set names, or all of its scenarios, which are among what was compiled. Throws
/// base::InputError where that is no plant, or not one.
PropertySubject subject_of(const Manifest& manifest, const ManifestSet& set, const SetFiles& files,
                           const compiler::Compilation& compilation);

/// Of a file of properties: that of the set that has it. Throws base::InputError where none has it, or several do.
PropertySubject subject_of(const Manifest& manifest, const std::string& properties);

}  // namespace rmpl::tools
