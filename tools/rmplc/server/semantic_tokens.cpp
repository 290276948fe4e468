// Every token of a document with what it is: names as the compiler tells them apart, words by the list.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>

#include "base/utf8.hpp"
#include "grammar/editor/keywords.hpp"
#include "grammar/editor/tokens.hpp"
#include "tools/rmplc/server/features.hpp"
#include "tools/rmplc/server/language.hpp"
#include "tools/rmplc/server/mentions.hpp"

namespace rmpl::tools {
namespace {

using grammar::TextToken;
using grammar::TokenKind;

/// What is no word and no name.
constexpr const char* comment_token = "comment";
constexpr const char* string_token = "string";
constexpr const char* number_token = "number";

const std::vector<std::string_view>& token_types() {
  static const std::vector<std::string_view> types = [] {
    std::vector<std::string_view> all = grammar::semantic_tokens();
    for (const char* more : {comment_token, string_token, number_token}) {
      if (std::find(all.begin(), all.end(), more) == all.end()) all.emplace_back(more);
    }
    return all;
  }();
  return types;
}

std::uint32_t number_of(std::string_view token) {
  const auto& types = token_types();
  return static_cast<std::uint32_t>(std::find(types.begin(), types.end(), token) - types.begin());
}

/// The tokens as the protocol packs them: each by its distance from the one before, lengths in UTF-16.
class Packing {
 public:
  explicit Packing(std::string_view text) : text_(text) {}

  /// Tokens come in order; one of several lines becomes one for each, as clients expect it.
  void add(std::uint32_t begin, std::uint32_t end, std::uint32_t type, bool declared) {
    while (begin < end) {
      const std::size_t line_end = std::min<std::size_t>(text_.find('\n', begin), end);
      std::uint32_t last = static_cast<std::uint32_t>(line_end);
      if (last > begin && text_[last - 1] == '\r') --last;
      if (last > begin) put(begin, last, type, declared);
      begin = static_cast<std::uint32_t>(line_end) + 1;
    }
  }
  Json take() { return {{"data", std::move(data_)}}; }

 private:
  void put(std::uint32_t begin, std::uint32_t end, std::uint32_t type, bool declared) {
    walk(begin);
    const std::uint32_t line_delta = line_ - last_line_;
    const std::uint32_t unit_delta = line_delta == 0 ? unit_ - last_unit_ : unit_;
    last_line_ = line_;
    last_unit_ = unit_;
    walk(end);
    for (const std::uint32_t number : {line_delta, unit_delta, unit_ - last_unit_, type, declared ? 1u : 0u})
      data_.push_back(number);
  }
  void walk(std::uint32_t to) {
    for (; at_ < to; ++at_) {
      const char byte = text_[at_];
      if (byte == '\n') {
        ++line_;
        unit_ = 0;
      } else if (!base::is_continuation(byte)) {
        unit_ += static_cast<unsigned char>(byte) >= 0xF0 ? 2 : 1;
      }
    }
  }

  std::string_view text_;
  Json data_ = Json::array();
  std::uint32_t at_ = 0, line_ = 0, unit_ = 0, last_line_ = 0, last_unit_ = 0;
};

class Colouring {
 public:
  Colouring(std::string_view text, grammar::Language language, std::span<const compiler::Mention> mentions)
      : text_(text),
        keywords_(grammar::keywords(language)),
        next_(mentions.begin()),
        last_(mentions.end()),
        out_(text) {}

  Json run() {
    for (const TextToken& token : grammar::tokens_of(text_)) {
      switch (token.kind) {
        case TokenKind::comment:
          out_.add(token.begin, token.end, number_of(comment_token), false);
          break;
        case TokenKind::string:
          out_.add(token.begin, token.end, number_of(string_token), false);
          break;
        case TokenKind::number:
          out_.add(token.begin, token.end, number_of(number_token), false);
          break;
        case TokenKind::word:
          word(token);
          break;
        case TokenKind::symbol:
          break;
      }
    }
    return out_.take();
  }

 private:
  void word(const TextToken& token) {
    while (next_ != last_ && next_->span.begin < token.begin) ++next_;
    bool named = false;
    for (; next_ != last_ && next_->span.end <= token.end; ++next_) {
      const auto type = number_of(grammar::token_of_names(name_of(next_->kind)));
      out_.add(next_->span.begin, next_->span.end, type, next_->span == next_->declaration);
      named = true;
    }
    if (named) return;
    const auto keyword = keywords_.find(token.in(text_));
    if (keyword != keywords_.end()) out_.add(token.begin, token.end, number_of(keyword->second.token), false);
  }

  std::string_view text_;
  const grammar::Keywords& keywords_;
  std::span<const compiler::Mention>::iterator next_;
  std::span<const compiler::Mention>::iterator last_;
  Packing out_;
};

}  // namespace

Json semantic_legend() { return {{"tokenTypes", token_types()}, {"tokenModifiers", Json::array({"declaration"})}}; }

Json semantic_tokens(Workspace& workspace, const Json& params) {
  const OpenDocument& document = workspace.documents().of(params);
  const Analysis* analysis = workspace.analysis_of(document);
  const auto language = language_of(document.path);
  if (analysis == nullptr || !language) return {{"data", Json::array()}};
  const std::uint32_t file = *analysis->find(workspace.texts().identity(document.path));
  const auto mentions = analysis->names().all();
  const auto before = [](const compiler::Mention& m, std::uint32_t f) { return m.span.file < f; };
  const auto first = std::lower_bound(mentions.begin(), mentions.end(), file, before);
  const auto last = std::lower_bound(first, mentions.end(), file + 1, before);
  return Colouring(analysis->sources()[file].text(), *language, {first, last}).run();
}

}  // namespace rmpl::tools
