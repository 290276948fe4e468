// Codes of the registry: compiled documents.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array document_table = {
    CodeInfo{
        Code::document_schema, "not a compiled document",
        "The JSON is not what `rmplc compile` writes: a key is missing, unknown or there twice, or its value has the "
        "wrong type or names what is not there. The message gives the path in the document.",
        R"({"format": "rmpl-automata", "version": 2, "plants": 3, "programs": [], "scenarios": []})",
        R"({"format": "rmpl-automata", "version": 2, "plants": [], "programs": [], "scenarios": []})"},
};

}  // namespace

std::span<const CodeInfo> document_codes() { return document_table; }

}  // namespace rmpl::grammar
