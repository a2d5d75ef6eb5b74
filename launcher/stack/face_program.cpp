#include "launcher/stack/face_program.h"

#include <filesystem>
#include <stdexcept>

#include "launcher/stack/run_folder.h"

namespace twinbus::inline launcher {

std::string face_program() {
  const std::string program = program_folder() + "/twinbus_face";
  if (!std::filesystem::exists(program)) {
    throw std::runtime_error(
        "twinbus_face was not built, since CycloneDDS was not found: apt-get install cyclonedds-dev cyclonedds-tools; then "
        "`./twinbus face KIND` in the source tree builds it");
  }
  return program;
}

void add_face(Stack& stack, const std::string& kind, const std::vector<std::string>& options) {
  if (kind != "unitree_hg" && kind != "unitree_go")
    throw std::runtime_error("--face " + kind + ": no such face; write unitree_hg or unitree_go");
  if (stack.find("controller") != nullptr) {
    throw std::runtime_error("--face: stack " + stack.name +
                             " has a controller of its own; programs drive the stacks client, client_both and others without one");
  }
  static_cast<void>(face_program());
  StackProcess face;
  face.name = "face";
  face.program = "twinbus_face";
  face.arguments = {kind, "{robot}", "{bus}"};
  face.arguments.insert(face.arguments.end(), options.begin(), options.end());
  face.ready_when = ReadyWhen::kLine;
  face.required = false;
  face.restart = true;
  stack.processes.push_back(face);
}

}  // namespace twinbus::launcher
