// A main for fuzz targets where libFuzzer is not at hand: seeded mutations of a corpus, for a number of runs or
// seconds.
//
// Usage: TARGET RUNS SECONDS SEED DIRECTORY EXTENSION…   runs mutations of the files found
//        TARGET FILE                                     runs one input, to look at a crash
// An input that crashes or takes longer than 20 seconds is left in the file `TARGET.crash`.
// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/fuzz/mutate.hpp"

using namespace rmpl;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr unsigned hang_seconds = 20;

// What the signal handler writes; plain pointers, as a handler may touch nothing that allocates.
const char* current_data = nullptr;
std::size_t current_size = 0;
char crash_file[4096];

extern "C" void leave_input(int signal) {
  const int file = open(crash_file, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file >= 0) {
    for (std::size_t written = 0; written < current_size;) {
      const ssize_t more = write(file, current_data + written, current_size - written);
      if (more <= 0) break;
      written += static_cast<std::size_t>(more);
    }
    close(file);
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void run(const std::string& input) {
  current_data = input.data();
  current_size = input.size();
  alarm(hang_seconds);
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
  alarm(0);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 1) {
    std::ifstream file(arguments[0], std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    run(text.str());
    return EXIT_SUCCESS;
  }
  if (arguments.size() < 5) {
    std::fprintf(stderr, "usage: %s RUNS SECONDS SEED DIRECTORY EXTENSION…, or %s FILE\n", argv[0], argv[0]);
    return EXIT_FAILURE;
  }
  const std::size_t runs = std::stoull(arguments[0]);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(std::stoll(arguments[1]));
  fuzz::Random random(std::stoull(arguments[2]));
  const std::vector<fuzz::Seed> corpus = fuzz::read_corpus(arguments[3], {arguments.begin() + 4, arguments.end()});
  if (corpus.empty()) {
    std::fprintf(stderr, "%s holds no file to start from\n", arguments[3].c_str());
    return EXIT_FAILURE;
  }

  std::snprintf(crash_file, sizeof crash_file, "%s.crash", argv[0]);
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGILL, SIGBUS, SIGALRM}) std::signal(signal, leave_input);
  for (const fuzz::Seed& seed : corpus) run(seed.text);
  std::size_t done = 0;
  for (; done < runs && std::chrono::steady_clock::now() < deadline; ++done)
    run(fuzz::mutate(corpus[random() % corpus.size()].text, corpus, random));
  std::printf("%zu seeds, %zu mutations\n", corpus.size(), done);
  return EXIT_SUCCESS;
}
