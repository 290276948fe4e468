// Codes of the registry: compiled documents.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array document_table = {
    CodeInfo{Code::document_schema, "not a compiled document",
             "The JSON does not have the form that `rmplc compile` writes. A key is missing, unknown or duplicated, or "
             "a value has the wrong type or refers to something that does not exist. The message gives the path in the "
             "document.",
             R"({"format": "rmpl-automata", "version": 2, "plants": 3, "programs": [], "scenarios": []})",
             R"({"format": "rmpl-automata", "version": 2, "plants": [], "programs": [], "scenarios": []})"},
};

}  // namespace

std::span<const CodeInfo> document_codes() { return document_table; }

}  // namespace rmpl::grammar
