// Whatever is in a mesh file, taken as STL, OBJ and DAE: it is read, or refused with one line that names the file.

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "geometry/mesh/mesh_file.h"

using namespace twinbus;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  for (const char* file : {"the_file.stl", "the_file.obj", "the_file.dae"}) {
    try {
      const TriangleMesh mesh = parse_mesh(bytes, file, Eigen::Vector3d::Ones());
      for (const auto& triangle : mesh.triangles) {
        for (const int corner : triangle) {
          if (!(mesh.points.at(static_cast<std::size_t>(corner)).allFinite())) std::abort();
        }
      }
    } catch (const std::runtime_error& error) {
      const std::string said = error.what();
      if (said.find("the_file") == std::string::npos || said.find('\n') != std::string::npos)
        std::abort();
    }
  }
  return 0;
}
