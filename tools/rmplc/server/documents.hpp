// The documents that are open in the editor: their texts lie over those of the disk.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "compiler/session/provider.hpp"
#include "grammar/source/source_file.hpp"
#include "tools/rmplc/server/message.hpp"

namespace rmpl::tools {

/// A document as the editor has it.
struct OpenDocument {
  std::string uri;
  std::string path;  ///< of a document that is no file, a name that no file has
  bool is_file = false;
  std::int64_t version = 0;
  std::shared_ptr<const grammar::SourceFile> source;
};

/// Follows what the editor says of its documents. What it says wrongly is an RpcError, and changes nothing.
class Documents {
 public:
  explicit Documents(compiler::Overlay& texts) : texts_(texts) {}

  const OpenDocument& open(const Json& params);
  const OpenDocument& change(const Json& params);
  void close(const Json& params);

  /// The document that `params.textDocument` names. Throws RpcError where it is not open.
  [[nodiscard]] const OpenDocument& of(const Json& params) const;
  [[nodiscard]] const std::map<std::string, OpenDocument>& all() const { return open_; }
  /// The URI of a source: as the editor has it, or of the path.
  [[nodiscard]] std::string uri_of(const std::string& path) const;

 private:
  void keep(OpenDocument& document, std::shared_ptr<const grammar::SourceFile> source);

  compiler::Overlay& texts_;
  std::map<std::string, OpenDocument> open_;          ///< by URI
  std::map<std::string, std::string> uri_by_source_;  ///< by identity
};

}  // namespace rmpl::tools
