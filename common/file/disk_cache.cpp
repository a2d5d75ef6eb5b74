#include "common/file/disk_cache.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include "common/file/byte_pack.h"

namespace twinbus::inline common {

namespace {

namespace fs = std::filesystem;

constexpr std::array<char, 8> kMagic = {'t', 'w', 'b', 'c', 'a', 'c', 'h', '1'};

Fingerprint seal_of(const std::string& kind, const Fingerprint& key, const std::string& content) {
  return FingerprintMaker().add(kind).add(key.high).add(key.low).add(content).value();
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const noexcept { return number_; }

 private:
  int number_;
};

bool write_all(int file, const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = write(file, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

// A plain file of this user that nobody else may write; nothing, and why, when it is anything else.
std::optional<std::string> read_own(const std::string& name, std::string& why) {
  const Descriptor file(open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  if (file.number() < 0) {
    if (errno != ENOENT && errno != ENOTDIR) why = std::strerror(errno);
    return std::nullopt;
  }
  struct stat about {};
  if (fstat(file.number(), &about) != 0 || !S_ISREG(about.st_mode)) {
    why = "it is not a plain file";
  } else if (about.st_uid != geteuid() || (about.st_mode & (S_IWGRP | S_IWOTH)) != 0) {
    why = "others may have written it";
  } else if (about.st_size > static_cast<off_t>(DiskCache::kMostBytes)) {
    why = "it is too large";
  }
  if (!why.empty()) return std::nullopt;
  std::string bytes(static_cast<std::size_t>(about.st_size), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = read(file.number(), bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      why = "it cannot be read";
      return std::nullopt;
    }
    done += static_cast<std::size_t>(n);
  }
  return bytes;
}

}  // namespace

DiskCache::DiskCache(std::string folder)
    : say([](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); }),
      folder_(std::move(folder)) {}

std::string DiskCache::file(const std::string& kind, const Fingerprint& key) const {
  return folder_ + "/" + key.text() + "." + kind;
}

std::string DiskCache::sealed(const std::string& kind, const Fingerprint& key,
                              const std::string& content) {
  Packer out;
  out.put(kMagic).put(key).put(seal_of(kind, key, content));
  out.put(static_cast<std::uint64_t>(content.size()));
  return out.bytes() + content;
}

std::optional<std::string> DiskCache::unsealed(const std::string& bytes, const std::string& kind,
                                               const Fingerprint& key, std::string& why) {
  Unpacker in(bytes);
  const auto magic = in.get<std::array<char, 8>>();
  const auto own_key = in.get<Fingerprint>();
  const auto seal = in.get<Fingerprint>();
  const auto size = in.get<std::uint64_t>();
  constexpr std::size_t kHeader = 2 * sizeof(std::uint64_t) + 2 * sizeof(Fingerprint);
  if (in.broken() || magic != kMagic) {
    why = "it is none of ours, or of another version";
  } else if (size != bytes.size() - kHeader) {
    why = "it is cut off, or has something behind its end";
  } else if (own_key != key) {
    why = "it belongs to something else";
  } else if (std::string content = bytes.substr(kHeader); seal_of(kind, key, content) != seal) {
    why = "it is damaged";
  } else {
    return content;
  }
  return std::nullopt;
}

std::optional<std::string> DiskCache::find(const std::string& kind, const Fingerprint& key) const {
  if (folder_.empty()) return std::nullopt;
  std::string why;
  std::optional<std::string> content = read_own(file(kind, key), why);
  if (content) content = unsealed(*content, kind, key, why);
  if (!why.empty()) refuse(kind, key, why);
  return content;
}

void DiskCache::refuse(const std::string& kind, const Fingerprint& key,
                       const std::string& why) const {
  if (folder_.empty()) return;
  say("cache: " + file(kind, key) + " is not used: " + why + "; it is made anew");
  unlink(file(kind, key).c_str());
}

void DiskCache::keep(const std::string& kind, const Fingerprint& key, const std::string& content) {
  if (folder_.empty()) return;
  const std::string bytes = sealed(kind, key, content);
  if (bytes.size() > kMostBytes) return;
  std::error_code error;
  if (!fs::is_directory(folder_, error)) {
    fs::create_directories(fs::path(folder_).parent_path(), error);
    mkdir(folder_.c_str(), S_IRWXU);
  }
  make_room(bytes.size());
  std::string name = folder_ + "/new.XXXXXX";
  const Descriptor file_of(mkostemp(name.data(), O_CLOEXEC));  // ours alone may read and write it
  bool good = file_of.number() >= 0 && write_all(file_of.number(), bytes);
  good = good && rename(name.c_str(), file(kind, key).c_str()) == 0;
  if (good) return;
  if (file_of.number() >= 0) unlink(name.c_str());
  say("cache: nothing is kept in " + folder_ + ": " + std::strerror(errno) +
      " (TWINBUS_CACHE=off or =FOLDER)");
  folder_.clear();  // said once
}

void DiskCache::make_room(std::size_t bytes) const {
  struct Kept {
    fs::file_time_type time;
    std::size_t size;
    fs::path path;
  };
  std::vector<Kept> all;
  std::size_t sum = bytes;
  std::error_code error;
  for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
    std::error_code gone;  // another process may be at it too
    const auto size = it->file_size(gone);
    const auto time = it->last_write_time(gone);
    if (gone) continue;
    sum += size;
    all.push_back({time, size, it->path()});
  }
  if (sum <= kMostTogether) return;
  std::sort(all.begin(), all.end(), [](const Kept& a, const Kept& b) { return a.time < b.time; });
  for (const Kept& oldest : all) {
    if (sum <= kMostTogether) return;
    if (fs::remove(oldest.path, error)) sum -= oldest.size;
  }
}

DiskCache& disk_cache() {
  static DiskCache cache;
  return cache;
}

std::string user_cache_folder(const char* chosen, const char* xdg, const char* home) {
  const auto is = [](const char* value) { return value != nullptr && *value != '\0'; };
  if (is(chosen)) return std::string(chosen) == "off" ? "" : chosen;
  // XDG: a path that is not absolute is to be ignored.
  if (is(xdg) && *xdg == '/') return std::string(xdg) + "/twinbus";
  return is(home) ? std::string(home) + "/.cache/twinbus" : "";
}

void use_user_cache() {
  disk_cache() = DiskCache(user_cache_folder(std::getenv("TWINBUS_CACHE"),
                                             std::getenv("XDG_CACHE_HOME"), std::getenv("HOME")));
}

}  // namespace twinbus::common
