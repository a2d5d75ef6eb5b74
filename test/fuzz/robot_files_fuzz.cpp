// Whatever is in a URDF, SRDF or robot.yaml: it is read, or refused with one line that names the file.

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "robot/description/robot_yaml.h"
#include "robot/description/srdf.h"
#include "robot/description/urdf.h"

using namespace twinbus;

namespace {

template <class Read>
void read_or_refuse(Read read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    const std::string said = error.what();
    if (said.find("the_file") == std::string::npos || said.find('\n') != std::string::npos) {
      std::abort();
    }
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
