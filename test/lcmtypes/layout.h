// Where each number of a message lies in its bytes, read from the .lcm file: independent of the
// code under test.

#pragma once

#include <cstddef>
#include <fstream>
#include <regex>
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
  const std::regex field(R"(^\s*(double|float|int8_t|int16_t|int32_t|int64_t)\s+(.*?);.*$)");
  const std::regex name(R"(([a-z_][a-z_0-9]*)((?:\[\d+\])*))");
  const std::regex dimension(R"(\[(\d+)\])");
  std::vector<FieldElement> elements;
  std::size_t offset = 8;
  for (std::string line; std::getline(file, line);) {
    std::smatch parts;
    if (!std::regex_match(line, parts, field)) continue;
    const std::string type = parts[1];
    const std::size_t size = type == "double" || type == "int64_t"  ? 8
                             : type == "float" || type == "int32_t" ? 4
                             : type == "int16_t"                    ? 2
                                                                    : 1;
    const std::string names = parts[2];
    for (std::sregex_iterator i(names.begin(), names.end(), name), end; i != end; ++i) {
      const std::string dimensions = (*i)[2];
      std::size_t count = 1;
      for (std::sregex_iterator d(dimensions.begin(), dimensions.end(), dimension); d != end; ++d) {
        count *= std::stoul((*d)[1]);
      }
      for (std::size_t k = 0; k < count; ++k, offset += size) {
        elements.push_back({(*i)[1], type, k, offset, size});
      }
    }
  }
  return elements;
}

}  // namespace twinbus
