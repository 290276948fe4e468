// All that the server knows: open documents, the units they make, what was found in each, kept up with every edit.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tools/rmplc/server/analysis.hpp"
#include "tools/rmplc/server/documents.hpp"
#include "tools/rmplc/server/units.hpp"

namespace rmpl::tools {

/// A place in a document, with the unit that answers for it.
struct Spot {
  const Analysis* analysis;
  std::uint32_t file;
  std::uint32_t offset;
  [[nodiscard]] const grammar::SourceFile& source() const { return analysis->sources()[file]; }
};

class Workspace {
 public:
  /// `below` gives the texts that are not open; it must live as long. `pages`: the folder with a page for each code of
  /// a diagnostic; empty where there is none.
  Workspace(compiler::Provider& below, std::string pages)
      : texts_(below), documents_(texts_), references_(texts_), pages_(std::move(pages)) {}

  void open(const Json& params);
  void change(const Json& params);
  void close(const Json& params);
  /// Something on the disk is no longer as it was.
  void disk_changed();

  /// The folders of the workspace, by path, as the client said at the start; may be none.
  void set_roots(std::vector<std::string> roots) { roots_ = std::move(roots); }
  [[nodiscard]] const std::vector<std::string>& roots() const { return roots_; }
  [[nodiscard]] References& references() { return references_; }

  [[nodiscard]] const Documents& documents() const { return documents_; }
  [[nodiscard]] compiler::Overlay& texts() { return texts_; }
  [[nodiscard]] const std::string& pages() const { return pages_; }
  /// What is known of every unit, up to date.
  const std::vector<std::shared_ptr<Analysis>>& analyses();
  /// The first unit with the document `params.textDocument`; null where it is in no unit.
  const Analysis* analysis_of(const OpenDocument& document);
  /// The place that `params.textDocument` and `params.position` name. Throws RpcError where the document is in no unit.
  Spot spot(const Json& params);

 private:
  void bring_up_to_date();

  compiler::Overlay texts_;
  Documents documents_;
  References references_;
  std::string pages_;
  std::vector<std::string> roots_;
  std::vector<Unit> units_;
  std::vector<std::shared_ptr<Analysis>> analyses_;
  bool units_are_old_ = false;
  bool analyses_are_old_ = false;
};

}  // namespace rmpl::tools
