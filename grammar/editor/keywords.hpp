// The words of the languages, with their kinds: read from the one list.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rmpl::grammar {

enum class Language { rmpl, tcca, scn, props, mon };

/// `rmpl`, `tcca`, `scn`, `props`, `mon`: what files of it end with.
std::string_view to_string(Language language);

struct KeywordInfo {
  std::string_view kind;     ///< `control`, `declaration`, `unit` …
  std::string_view token;    ///< the semantic token of the kind
  std::string_view meaning;  ///< in a few words
};

using Keywords = std::map<std::string_view, KeywordInfo>;

/// The keywords of a language, by word.
const Keywords& keywords(Language language);
/// The semantic token of a kind of names: `definition`, `mode` …; empty where there is no such kind.
std::string_view token_of_names(std::string_view kind);
/// Every semantic token of the list, in its order.
const std::vector<std::string_view>& semantic_tokens();

}  // namespace rmpl::grammar
