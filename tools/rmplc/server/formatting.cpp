// The one style, as an edit of the whole text: editors find out what it changes.
// SPDX-License-Identifier: MIT
#include "compiler/format/format.hpp"
#include "compiler/session/files.hpp"
#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/positions.hpp"

namespace rmpl::tools {

Json formatting(Workspace& workspace, const Json& params) {
  const OpenDocument& document = workspace.documents().of(params);
  const auto kind = compiler::kind_by_name(document.path);
  if (!kind || *kind == compiler::Kind::document)
    throw RpcError(RpcCode::request_failed,
                   document.uri + ": expected a file named .rmpl, .tcca, .scn, .props or .mon");
  const std::string_view before = document.source->text();
  const auto after = compiler::format(before, *kind);
  if (!after) throw RpcError(RpcCode::request_failed, "the text has syntax errors: fix them first");
  if (*after == before) return Json::array();
  const Json range = range_of(*document.source, 0, static_cast<std::uint32_t>(before.size()));
  return Json::array({{{"range", range}, {"newText", *after}}});
}

}  // namespace rmpl::tools
