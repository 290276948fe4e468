// Fuzzes the reader of compiled documents: it refuses with a message, or reads what it would write.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "automata/json/document.hpp"
#include "automata/json/parse.hpp"
#include "base/error.hpp"

using namespace rmpl;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  try {
    // The quick scan of texts reads what the library does.
    if (automata::parse_json(input).dump() != automata::Json::parse(input).dump()) std::abort();
  } catch (const automata::Json::exception&) {
    return 0;
  } catch (const base::InputError&) {
  }
  try {
    const automata::Document document = automata::document_from_json(automata::parse_json(input));
    const auto plain = automata::read_plain_document(input);
    if (plain && *plain != document) std::abort();
    const std::string text = automata::to_text(document);
    if (automata::to_text(automata::read_document(text, "document.json")) != text) std::abort();
  } catch (const base::InputError& error) {
    if (std::string_view(error.what()).empty()) std::abort();
  }
  return 0;
}
