// The bridge process: a robot, through its adaptor, as a source of STATE.

#include <unistd.h>

#include <cstdio>

#include "bridge/adaptor/adaptor_host.h"
#include "bridge/adaptor/motor_space_adaptor.h"
#include "bridge/source/source_main.h"
#include "bridge/adaptor/threaded_adaptor.h"
#include "robot/description/load.h"
#include "common/process/process.h"

namespace twinbus::inline bridge {
namespace {

int run(int argc, char** argv) {
  SourceMainOptions options = source_main_options("bridge", SourceKind::kBridge, ProcessKind::kBridge);
  std::string name = "emulated_robot";
  AdaptorConfig config;
  Options parser("twinbus_bridge", "Runs a robot, through its adaptor, as a source of STATE.");
  add_common(parser, options.common);
  parser.text("--adaptor", "PATH_OR_NAME", name,
              "what moves the robot: a name under lib/adaptors, or the path of a shared object");
  parser.settings("--set", config.settings, "key=value for the adaptor");
  add_source_options(parser, options, false);
  parser.parse(argc, argv);

  const Model model = load_robot(options.common.robot);
  LoadedAdaptor loaded(name);
  enter_real_time(options.priority);  // the device's thread inherits it
  ThreadedAdaptor device(*loaded);
  MotorSpaceAdaptor adaptor(device);  // the bus has joints
  const Status opened = adaptor.open(model, config);
  if (opened != Status::kOk) {
    std::fprintf(
        stderr,
        "bridge: adaptor '%s' cannot be opened: %s; is the robot switched on and reachable?\n",
        name.c_str(), to_text(opened));
    return 1;
  }
  const int code = run_source_main(options, model, adaptor);
  adaptor.close();
  if (device.hung()) {
    std::fprintf(stderr, "bridge: the device hangs; leaving without it\n");
    loaded.abandon();
    std::fflush(nullptr);
    ::_exit(1);
  }
  return code;
}

}  // namespace
}  // namespace twinbus::bridge

int main(int argc, char** argv) {
  return twinbus::run_process("bridge", twinbus::run, argc, argv);
}
