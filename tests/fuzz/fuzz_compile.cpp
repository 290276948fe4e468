// Fuzzes the whole way from a text to a document or diagnostics: what compiles is written and reads back the same.
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "automata/json/document.hpp"
#include "compiler/session/compiler.hpp"
#include "grammar/source/render.hpp"

using namespace rmpl;

namespace {

/// The text as a file of each kind in turn: what is wrong for one language may be deep inside another.
void compile_as(const std::string& extension, const std::uint8_t* data, std::size_t size) {
  static const std::string stem =
      (std::filesystem::temp_directory_path() / ("fuzz_compile_" + std::to_string(getpid()))).string();
  const std::vector<std::string> paths{stem + extension};
  std::ofstream(paths[0], std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  const compiler::Compilation result = compiler::compile(paths);
  std::error_code ignored;
  std::filesystem::remove(paths[0], ignored);
  if (!result.ok()) {
    if (grammar::render_text(result.findings(), false).empty()) std::abort();
    if (grammar::render_json(result.findings()).empty()) std::abort();
    return;
  }
  const std::string text = automata::to_text(result.document());
  if (automata::to_text(automata::read_document(text, paths[0])) != text) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const char* extension : {".rmpl", ".tcca", ".scn"}) compile_as(extension, data, size);
  return 0;
}
