// Names of files in a text that lead there: imports, and the programs and plants of scenarios.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "grammar/editor/tokens.hpp"
#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/positions.hpp"
#include "tools/rmplc/server/uri.hpp"

namespace rmpl::tools {

Json document_links(Workspace& workspace, const Json& params) {
  const OpenDocument& document = workspace.documents().of(params);
  Json links = Json::array();
  if (!document.is_file) return links;
  const std::filesystem::path folder = std::filesystem::path(document.path).parent_path();
  const std::string_view text = document.source->text();
  std::string_view before;
  for (const grammar::TextToken& token : grammar::tokens_of(text)) {
    if (token.kind == grammar::TokenKind::comment) continue;
    const std::string_view word = token.in(text);
    const bool names_file = before == "import" || before == "program" || before == "plant";
    before = word;
    if (!names_file || token.kind != grammar::TokenKind::string || word.size() < 3 || word.back() != '"') continue;
    const std::filesystem::path path = (folder / word.substr(1, word.size() - 2)).lexically_normal();
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(path, unknown)) continue;
    links.push_back({{"range", range_of(*document.source, token.begin + 1, token.end - 1)},
                     {"target", workspace.documents().uri_of(path.string())}});
  }
  return links;
}

}  // namespace rmpl::tools
