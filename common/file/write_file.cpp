#include "common/file/write_file.h"

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace twinbus::inline common {

namespace fs = std::filesystem;

void write_file(const std::string& file, const std::string& text) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (stream) return;
  const std::string why = errno != 0 ? ": " + std::generic_category().message(errno) : "";
  throw std::runtime_error("cannot write " + file + why);
}

void write_whole(const std::string& file, const std::string& text) {
  const std::string made = file + ".new" + std::to_string(getpid());  // two that write at once do not mix
  std::error_code error, ignored;
  std::string why;
  try {
    write_file(made, text);
    fs::rename(made, file, error);
    if (!error) return;
    why = "cannot write " + file + ": " + error.message();
  } catch (const std::runtime_error& failure) {
    why = failure.what();
  }
  fs::remove(made, ignored);
  throw std::runtime_error(why);
}

void write_new(const std::string& file, const std::string& text) {
  if (fs::exists(file)) throw std::runtime_error(file + ": exists; name a new one");
  if (fs::path(file).has_parent_path()) fs::create_directories(fs::path(file).parent_path());
  write_file(file, text);
}

std::string write_unasked(const std::string& file, const std::string& text) {
  try {
    write_file(file, text);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace twinbus::common
