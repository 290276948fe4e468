// Damage to texts: the mutations of the fuzz driver and of the malformed-input test.
// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>
#include <vector>

namespace rmpl::fuzz {

using Random = std::mt19937_64;

/// A file that mutations start from.
struct Seed {
  std::string path;
  std::string text;
};

/// All files below `directory` with one of the extensions (".tcca"), sorted by path.
std::vector<Seed> read_corpus(const std::string& directory, const std::vector<std::string>& extensions);

/// One to four random changes: bits and bytes, cuts, doubled and swapped pieces, pieces of another seed, huge numbers,
/// NUL bytes and broken UTF-8, brackets nested deep. The same generator state gives the same text.
std::string mutate(const std::string& text, const std::vector<Seed>& corpus, Random& random);

}  // namespace rmpl::fuzz
