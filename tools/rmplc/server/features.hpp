// What the server can do for a document, a file each.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <span>
#include <string>

#include "tools/rmplc/server/message.hpp"
#include "tools/rmplc/server/workspace.hpp"

namespace rmpl::tools {

/// Diagnostics of a unit, ready for the client: each {"uri", "diagnostic"}, and an "action" where there is a fix.
Json findings_of(std::span<const grammar::Diagnostic> diagnostics, const Analysis& analysis,
                 const Workspace& workspace);

/// All that there is to tell of a unit, in that form. Once it was linted, lint has the warnings of the compiler too, at
/// their levels.
Json findings_of(const Analysis& analysis, const Workspace& workspace);
/// Whether two ranges of a document have a place in common.
bool touch(const Json& range, const Json& other);

/// The diagnostics of all files that were read, by URI; an empty array for a file without any.
std::map<std::string, Json> diagnostics_by_uri(Workspace& workspace);

// Each takes the parameters of its request and gives its result. What cannot be is an RpcError.

Json code_actions(Workspace& workspace, const Json& params);
/// Their commands are `rmpl.run`, with {program, arguments, folder}, and `rmpl.debug`, with a launch of the debugger:
/// the client has them (docs/editors.md).
Json code_lenses(Workspace& workspace, const Json& params);
Json prepare_call_hierarchy(Workspace& workspace, const Json& params);
Json incoming_calls(Workspace& workspace, const Json& params);
Json outgoing_calls(Workspace& workspace, const Json& params);
Json hover(Workspace& workspace, const Json& params);
Json definition(Workspace& workspace, const Json& params);
Json references(Workspace& workspace, const Json& params);
Json highlights(Workspace& workspace, const Json& params);
Json prepare_rename(Workspace& workspace, const Json& params);
Json rename(Workspace& workspace, const Json& params);
Json completion(Workspace& workspace, const Json& params);
Json document_symbols(Workspace& workspace, const Json& params);
Json workspace_symbols(Workspace& workspace, const Json& params);
Json formatting(Workspace& workspace, const Json& params);
Json folding_ranges(Workspace& workspace, const Json& params);
Json document_links(Workspace& workspace, const Json& params);
Json inlay_hints(Workspace& workspace, const Json& params);
Json semantic_tokens(Workspace& workspace, const Json& params);

/// The names of the types and modifiers that semantic tokens are numbered by.
Json semantic_legend();

}  // namespace rmpl::tools
