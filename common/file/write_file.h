// Texts written into files.  Each but the last throws std::runtime_error that names the file.

#pragma once

#include <string>

namespace twinbus::inline common {

// Over what was there; into a device or a pipe too.
void write_file(const std::string& file, const std::string& text);
// Whole at once: who reads meanwhile has the old text or the new one.
void write_whole(const std::string& file, const std::string& text);
// Never over a file that is there; makes the folder.
void write_new(const std::string& file, const std::string& text);
// As write_file, of a copy that nobody asked for: says what was wrong, empty when nothing was.
std::string write_unasked(const std::string& file, const std::string& text);

}  // namespace twinbus::common
