// The examples of diagnostics: the files that the registry tells in one text, and the commands that show the finding.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "grammar/source/codes.hpp"

namespace rmpl::tools {

struct ExampleFile {
  std::string name;
  std::string text;
};

/// An example as somebody would try it: in an empty folder, write the files, then run the commands in one shell.
struct Example {
  std::vector<ExampleFile> files;
  std::vector<std::string> commands;
};

/// Reads `wrong` or `right` of an entry. Lines `$ COMMAND` at the start are the commands; a line `// NAME.EXT` begins a
/// file of that name. One file needs no such line: it is named by its content. Without commands, the files are given to
/// the program that reads them, except those that another one names.
Example example(const grammar::CodeInfo& info, std::string_view text);

}  // namespace rmpl::tools
