// Arrays of an NPZ file: what numpy.savez and numpy.savez_compressed write, a zip archive of .npy members.
//
// Read from the central directory, so sizes are known before anything is unpacked.  Every size is checked against the
// bytes that are there; nothing is allocated on the word of a header alone.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace twinbus::inline robot {

// One array, row-major whatever order the file has.  Numbers of any kind become double; text becomes strings.
struct NpyArray {
  std::string name;                // of the member, without .npy
  std::vector<std::size_t> shape;  // empty: a scalar
  std::vector<double> numbers;
  std::vector<std::string> texts;  // of an array of text; then numbers is empty
  std::size_t size() const;
};

// Throws std::runtime_error naming file and member: no archive, cut short, a wrong checksum, objects (pickles), a method or
// type that is not known, or more than 1 GB unpacked.
std::vector<NpyArray> read_npz(const std::string& file, std::string_view bytes);

// Throws std::runtime_error "where: what".
[[noreturn]] void refuse_npz(const std::string& where, const std::string& what);

}  // namespace twinbus::robot
