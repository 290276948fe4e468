// Files and what they import: read once, parsed once, in a fixed order.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "automata/scenario.hpp"
#include "compiler/check/definitions.hpp"
#include "compiler/session/kind.hpp"
#include "compiler/session/provider.hpp"
#include "grammar/ast/monitor.hpp"
#include "grammar/ast/plant.hpp"
#include "grammar/ast/program.hpp"
#include "grammar/ast/property.hpp"
#include "grammar/ast/scenario.hpp"
#include "grammar/source/diagnostic.hpp"
#include "grammar/source/source_file.hpp"

namespace rmpl::compiler {

/// One file: its text, and what it holds; with syntax errors a part of that, for an index of names.
struct File {
  std::uint32_t index = 0;  ///< in the sources; of a compiled document, too
  std::string directory;    ///< what its imports are relative to
  Kind kind = Kind::program;
  bool whole = false;  ///< no syntax errors
  bool named = false;  ///< by the user; else another file brought it, which others may have in common
  std::optional<grammar::ProgramFile> program;
  std::optional<grammar::PlantFile> plant;
  std::optional<grammar::ScenarioFile> scenarios;
  std::optional<grammar::PropertyFile> properties;
  std::optional<grammar::MonitorFile> monitors;
  std::unique_ptr<automata::Document> document;  ///< its plants move into the input set that takes them over
};

/// Files that make one program or one plant: those named first, then what they import, each once.
struct FileSet {
  std::vector<const File*> files;
  std::size_t roots = 0;  ///< how many of them were named
  bool complete = true;   ///< false where a file is missing or has syntax errors; that has been reported
  std::vector<const File*> programs = {};  ///< of a plant: those that it imports for their model programs, each once
};

/// Reads and parses; the same file once, however it is named.
class Files {
 public:
  Files(Provider& provider, grammar::Sources& sources, grammar::Diagnostics& diagnostics)
      : provider_(provider), sources_(sources), diagnostics_(diagnostics) {}

  /// A file that the user named. `-` is standard input. Throws base::InputError where it cannot be read, or has
  /// no known extension.
  const File& open(const std::string& path);
  /// A file that another names, relative to it. Null where it cannot be read; then it has been reported, once
  /// for the file, at the first place that names it.
  const File* open(const File& from, const grammar::String& path);
  /// The named files with all that they import. Reports what is missing, what imports itself, and imports of a file of
  /// another kind; but a plant may import programs, whose own imports are not followed.
  FileSet with_imports(const std::vector<const File*>& roots);
  /// All that were opened, and what they hold, for good.
  std::vector<File> take();

 private:
  struct Importing;
  using Reading = std::string (Provider::*)(const std::string& path);
  File& find(const std::string& path, Reading reading);
  File& read(const std::string& path, const std::string& canonical, std::string text);
  /// Nothing where the text is no compiled document; then it has been reported.
  std::unique_ptr<automata::Document> read_document(std::uint32_t index);
  void follow(const File& file, std::vector<Importing>& path, FileSet& set);
  void report_cycle(const File& file, const std::vector<Importing>& path, grammar::Span span);

  Provider& provider_;
  grammar::Sources& sources_;
  grammar::Diagnostics& diagnostics_;
  std::map<std::string, File> files_;  ///< by identity; a map, for files are referred to
  /// What cannot be read and has been reported: the file that names it, and the name.
  std::set<std::pair<std::uint32_t, std::string>> missing_;
};

}  // namespace rmpl::compiler
