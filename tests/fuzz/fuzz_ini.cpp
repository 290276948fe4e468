// Fuzzes the reader of rmpl.ini: what it does not take is an input error, and what it takes it takes again.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/check.hpp"
#include "base/error.hpp"
#include "tools/shared/settings.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const rmpl::tools::Settings settings = rmpl::tools::read_settings("rmpl.ini", text);
    CHECK(settings.options == rmpl::tools::read_settings("rmpl.ini", text).options);
  } catch (const rmpl::base::InputError&) {
  }
  return 0;
}
