// Where each number of a message lies in its bytes, read from the .lcm file: independent of the
// code under test.

#pragma once

#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace twinbus {

struct FieldElement {
  std::string field;  // "qd"
  std::string type;   // "float"
  std::size_t index;  // in a flattened array
  std::size_t
      offset;  // from the start of the encoded message, which begins with 8 bytes of type hash
  std::size_t size;  // [bytes]
};

inline std::vector<FieldElement> layout_of(const std::string& message_type) {
  const std::string path = std::string(TWINBUS_LCM_FOLDER) + "/" + message_type + ".lcm";
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::vector<FieldElement> elements;
  std::size_t offset = 8;
  for (std::string line; std::getline(file, line);) {
    const std::size_t end = line.find(';');
    std::istringstream words(line.substr(0, end));
    std::string type;
    words >> type;
    const std::size_t size = type == "double" || type == "int64_t"  ? 8
                             : type == "float" || type == "int32_t" ? 4
                             : type == "int16_t"                    ? 2
                             : type == "int8_t"                     ? 1
                                                                    : 0;
    if (size == 0 || end == std::string::npos) continue;
    std::string name;  // "q[6][12]", or the first of "a, b"
    while (std::getline(words >> std::ws, name, ',')) {
      std::size_t count = 1;
      const std::size_t bracket = name.find('[');
      for (std::size_t at = bracket; at != std::string::npos; at = name.find('[', at + 1)) {
        count *= std::stoul(name.substr(at + 1));
      }
      for (std::size_t k = 0; k < count; ++k, offset += size) {
        elements.push_back({name.substr(0, bracket), type, k, offset, size});
      }
    }
  }
  return elements;
}

}  // namespace twinbus
