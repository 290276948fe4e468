// The world that fails: preloaded into a program, it lets the n-th allocation, read, write … of the run fail.
//
// RMPL_FAULT=call:n:m lets m calls from the n-th on fail (m = 0: all of them). RMPL_FAULT_COUNTS=FILE writes at the end
// how often each was called. Calls: alloc, open, read, write, sync, rename, stat.
// SPDX-License-Identifier: MIT
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

enum Call : std::uint8_t { alloc, open_, read_, write_, sync_, rename_, stat_, calls };
constexpr std::array<std::string_view, calls> names{"alloc", "open", "read", "write", "sync", "rename", "stat"};
constexpr std::array<int, calls> reasons{ENOMEM, EMFILE, EIO, ENOSPC, EIO, EIO, EIO};

std::array<std::atomic<std::uint64_t>, calls> counts;
std::uint64_t first = 0, most = 0;
int which = -1;

/// Before main, and without memory: what is called earlier is the loader's.
__attribute__((constructor)) void read_wish() {
  const char* wish = std::getenv("RMPL_FAULT");
  if (wish == nullptr) return;
  const std::string_view text = wish;
  for (int c = 0; c < calls; ++c) {
    const std::string_view name = names[static_cast<std::size_t>(c)];
    if (!text.starts_with(name) || text.size() <= name.size() || text[name.size()] != ':') continue;
    char* end = nullptr;
    first = std::strtoull(wish + name.size() + 1, &end, 10);
    most = *end == ':' ? std::strtoull(end + 1, nullptr, 10) : 1;
    for (auto& count : counts) count = 0;
    which = c;
  }
}

__attribute__((destructor)) void write_counts() {
  which = -1;
  const char* path = std::getenv("RMPL_FAULT_COUNTS");
  if (path == nullptr) return;
  std::FILE* file = std::fopen(path, "w");
  if (file == nullptr) return;
  for (std::size_t c = 0; c < calls; ++c) {
    std::fprintf(file, "%s %llu\n", names[c].data(), static_cast<unsigned long long>(counts[c].load()));
  }
  std::fclose(file);
}

bool fails(Call call) {
  const std::uint64_t n = ++counts[call];
  if (which != call || n < first || (most != 0 && n >= first + most)) return false;
  errno = reasons[call];
  return true;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) { return fails(alloc) ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) { return fails(alloc) ? nullptr : __libc_calloc(count, size); }
void* realloc(void* old, std::size_t size) { return fails(alloc) ? nullptr : __libc_realloc(old, size); }
void* memalign(std::size_t alignment, std::size_t size) {
  return fails(alloc) ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }
int posix_memalign(void** result, std::size_t alignment, std::size_t size) {
  *result = memalign(alignment, size);
  return *result == nullptr ? ENOMEM : 0;
}

int open(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return fails(open_) ? -1 : openat(AT_FDCWD, path, flags, mode);
}
int open64(const char* path, int flags, ...) __attribute__((alias("open")));

ssize_t read(int file, void* bytes, std::size_t size) {
  static auto* const real = next<ssize_t(int, void*, std::size_t)>("read");
  return fails(read_) ? -1 : real(file, bytes, size);
}
ssize_t write(int file, const void* bytes, std::size_t size) {
  static auto* const real = next<ssize_t(int, const void*, std::size_t)>("write");
  // Half of a block is written before the disk is full: what is not whole must not be kept.
  if (!fails(write_)) return real(file, bytes, size);
  if (size > 1 && file != STDERR_FILENO) static_cast<void>(real(file, bytes, size / 2) + 0);
  errno = reasons[write_];
  return -1;
}
ssize_t writev(int file, const iovec* parts, int count) {
  static auto* const real = next<ssize_t(int, const iovec*, int)>("writev");
  return fails(write_) ? -1 : real(file, parts, count);
}
int fsync(int file) {
  static auto* const real = next<int(int)>("fsync");
  return fails(sync_) ? -1 : real(file);
}
int rename(const char* from, const char* to) {
  static auto* const real = next<int(const char*, const char*)>("rename");
  return fails(rename_) ? -1 : real(from, to);
}
int stat(const char* path, struct stat* about) {
  static auto* const real = next<int(const char*, struct stat*)>("stat");
  return fails(stat_) ? -1 : real(path, about);
}
int fstat(int file, struct stat* about) {
  static auto* const real = next<int(int, struct stat*)>("fstat");
  return fails(stat_) ? -1 : real(file, about);
}

}  // extern "C"
