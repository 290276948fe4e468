// What can be folded: brackets and comments of several lines, runs of imports.
// SPDX-License-Identifier: MIT
#include <vector>

#include "grammar/editor/tokens.hpp"
#include "tools/rmplc/server/features.hpp"

namespace rmpl::tools {
namespace {

class Folds {
 public:
  explicit Folds(const grammar::SourceFile& source) : source_(source) {}

  Json run() {
    const std::string_view text = source_.text();
    for (const grammar::TextToken& token : grammar::tokens_of(text)) {
      const std::string_view word = token.in(text);
      const bool comment = token.kind == grammar::TokenKind::comment;
      if (word == "import") importing_ = true;
      follow(comments_, comment, token, "comment");
      if (comment) continue;
      follow(imports_, importing_, token, "imports");
      if (word == ";") importing_ = false;
      if (word == "{") open_.push_back(token.begin);
      if (word == "}" && !open_.empty()) {
        const std::uint32_t first = line(open_.back());
        const std::uint32_t last = line(token.begin);
        if (last > first + 1) fold(first, last - 1, nullptr);
        open_.pop_back();
      }
    }
    end(comments_, "comment");
    end(imports_, "imports");
    return std::move(folds_);
  }

 private:
  /// Lines that follow each other.
  struct Run {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };

  [[nodiscard]] std::uint32_t line(std::uint32_t offset) const { return source_.place(offset).line; }
  void follow(Run& run, bool belongs, const grammar::TextToken& token, const char* kind) {
    if (!belongs) return end(run, kind);
    const std::uint32_t first = line(token.begin);
    if (run.first == 0 || first > run.last + 1) {
      end(run, kind);
      run.first = first;
    }
    run.last = line(token.end);
  }
  void end(Run& run, const char* kind) {
    if (run.last > run.first) fold(run.first, run.last, kind);
    run = {};
  }
  /// Lines count from 1 here, and from 0 there.
  void fold(std::uint32_t first, std::uint32_t last, const char* kind) {
    Json& one = folds_.emplace_back(Json{{"startLine", first - 1}, {"endLine", last - 1}});
    if (kind != nullptr) one["kind"] = kind;
  }

  const grammar::SourceFile& source_;
  Json folds_ = Json::array();
  std::vector<std::uint32_t> open_;
  Run comments_, imports_;
  bool importing_ = false;
};

}  // namespace

Json folding_ranges(Workspace& workspace, const Json& params) {
  return Folds(*workspace.documents().of(params).source).run();
}

}  // namespace rmpl::tools
