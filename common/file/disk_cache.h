// What took long to find, kept in files from one run to the next.
//
// A file is named by the fingerprint of all that its content depends on, so it is never out of date,
// only unused.  It is read as if somebody else had written it: another user's, a damaged, cut off or
// mistaken one is ignored with one line that says so, and written anew.  What it says must be
// verified by whoever asked, who calls refuse() when it does not hold.  Files appear whole: several
// processes may write one at the same time.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "common/file/fingerprint.h"

namespace twinbus::inline common {

class DiskCache {
 public:
  static constexpr std::size_t kMostBytes = 64u << 20;      // of a file
  static constexpr std::size_t kMostTogether = 512u << 20;  // of all: the oldest make room

  // folder: made when something is kept; empty: nothing is ever kept or found.
  explicit DiskCache(std::string folder = "");

  // kind: the ending of the file's name, a few letters.
  std::optional<std::string> find(const std::string& kind, const Fingerprint& key) const;
  // Does not fail: a result that cannot be kept is found again next time.
  void keep(const std::string& kind, const Fingerprint& key, const std::string& content);
  // What find() gave is wrong: says so, and takes it away.
  void refuse(const std::string& kind, const Fingerprint& key, const std::string& why) const;

  const std::string& folder() const noexcept { return folder_; }
  std::string file(const std::string& kind, const Fingerprint& key) const;

  // Where its lines go; stderr by default.
  std::function<void(const std::string&)> say;

  // The bytes of a file with this content, and back; a sentence in `why` when they are none.
  static std::string sealed(const std::string& kind, const Fingerprint& key,
                            const std::string& content);
  static std::optional<std::string> unsealed(const std::string& bytes, const std::string& kind,
                                             const Fingerprint& key, std::string& why);

 private:
  void make_room(std::size_t bytes) const;

  std::string folder_;
};

// That of this process: nothing is kept until its main() asks for it.  Not while threads use it.
DiskCache& disk_cache();
// From now on files of the user's cache folder: $TWINBUS_CACHE, else twinbus in $XDG_CACHE_HOME, else
// ~/.cache/twinbus.  TWINBUS_CACHE=off keeps nothing.
void use_user_cache();

// $TWINBUS_CACHE and so on, read from the arguments (null: not set).
std::string user_cache_folder(const char* chosen, const char* xdg, const char* home);

}  // namespace twinbus::common
