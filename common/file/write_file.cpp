#include "common/file/write_file.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace twinbus::inline common {

namespace fs = std::filesystem;

void write_file(const std::string& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error("cannot write " + file);
}

void write_whole(const std::string& file, const std::string& text) {
  const std::string made = file + ".new" + std::to_string(getpid());  // two that write at once do not mix
  std::error_code error;
  try {
    write_file(made, text);
    fs::rename(made, file, error);
  } catch (const std::runtime_error&) {
    error = std::make_error_code(std::errc::io_error);
  }
  if (!error) return;
  std::error_code ignored;
  fs::remove(made, ignored);
  throw std::runtime_error("cannot write " + file);
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
