// Whatever is in a URDF, SRDF or robot.yaml: it is read, or refused with lines that name the file, one a fault.

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

#include "robot/description/robot_yaml.h"
#include "robot/description/srdf.h"
#include "robot/description/urdf.h"

using namespace twinbus;

namespace {

constexpr int kMostFaults = 12;  // told at once; a last line counts the others

template <class Read>
void read_or_refuse(Read read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    std::istringstream said(error.what());
    std::string line;
    int lines = 0;
    while (std::getline(said, line)) {
      const bool counts = lines == kMostFaults && line.starts_with("  and ") && line.ends_with(" more");
      if (++lines > kMostFaults + 1 || (line.find("the_file") == std::string::npos && !counts)) std::abort();
    }
    if (lines == 0) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  read_or_refuse([&] { (void)parse_urdf(text, "the_file", {}); });
  read_or_refuse([&] { (void)parse_srdf(text, "the_file"); });
  read_or_refuse([&] { (void)parse_robot_yaml(text, "the_file"); });
  return 0;
}
