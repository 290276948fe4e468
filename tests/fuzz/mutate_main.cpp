// Writes malformed inputs: for each run, one mutated file beside the file that it was made from.
//
// Usage: mutate COUNT SEED DIRECTORY EXTENSION…   prints the paths that it wrote
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/fuzz/mutate.hpp"

using namespace rmpl;

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() < 4) {
    std::fprintf(stderr, "usage: %s COUNT SEED DIRECTORY EXTENSION…\n", argv[0]);
    return EXIT_FAILURE;
  }
  fuzz::Random random(std::stoull(arguments[1]));
  const auto corpus = fuzz::read_corpus(arguments[2], {arguments.begin() + 3, arguments.end()});
  if (corpus.empty()) {
    std::fprintf(stderr, "%s holds no file to start from\n", arguments[2].c_str());
    return EXIT_FAILURE;
  }
  const std::size_t count = std::stoull(arguments[0]);
  for (std::size_t i = 0; i < count; ++i) {
    const fuzz::Seed& seed = corpus[random() % corpus.size()];
    const std::filesystem::path original(seed.path);
    const auto path = original.parent_path() / ("malformed-" + std::to_string(i) + original.extension().string());
    std::ofstream(path, std::ios::binary) << fuzz::mutate(seed.text, corpus, random);
    std::printf("%s\n", path.c_str());
  }
  return EXIT_SUCCESS;
}
