// Fuzzes the reader of rmpl.toml: what it does not take is an input error, and what it takes it takes again.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/check.hpp"
#include "base/error.hpp"
#include "tools/shared/manifest.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const rmpl::tools::Manifest manifest = rmpl::tools::read_manifest("rmpl.toml", text);
    CHECK(manifest.sets.size() == rmpl::tools::read_manifest("rmpl.toml", text).sets.size());
  } catch (const rmpl::base::InputError&) {
  }
  return 0;
}
