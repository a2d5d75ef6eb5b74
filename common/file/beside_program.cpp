#include "common/file/beside_program.h"

#include <filesystem>

namespace twinbus::inline common {

namespace fs = std::filesystem;

std::string beside_program(const std::string& what, const std::string& otherwise) {
  std::error_code error;
  fs::path at = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (int up = 0; !error && up < 4 && at.has_relative_path(); ++up, at = at.parent_path()) {
    for (const fs::path& folder : {at, at / "share" / "twinbus"}) {
      if (fs::exists(folder / what, error)) return (folder / what).string();
      error.clear();
    }
  }
  return otherwise;
}

bool program_is_installed() {
  std::error_code error;
  const fs::path bin = fs::read_symlink("/proc/self/exe", error).parent_path();
  return !error && bin.filename() == "bin" && bin.parent_path().filename() == "twinbus" &&
         bin.parent_path().parent_path().filename() == "lib";
}

}  // namespace twinbus::common
