// `./twinbus doctor`: is this machine ready: network, bus, real time, packages, space.

#include "launcher/commands/commands.h"

#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "common/file/beside_program.h"
#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "common/process/priority.h"
#include "common/process/process.h"
#include "common/text/formatted.h"
#include "launcher/bus/bus_link.h"
#include "launcher/operate/package_list.h"
#include "launcher/stack/run_folder.h"
#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/udpm_receiver.h"

namespace twinbus::inline launcher {

namespace {

namespace fs = std::filesystem;

constexpr long kWantedBuffer = 4194304;  // recv_buf_size of the default URL [bytes]

enum class Health { kGood, kCould, kBad };  // kCould: works, but not as well as it could

class Report {
 public:
  void add(Health health, const std::string& what, const std::string& remedy = "") {
    const char* mark = health == Health::kGood    ? "ok     "
                       : health == Health::kCould ? "better "
                                                  : "MISSING";
    print_typed(stdout, "%s  %s\n", mark, what.c_str());
    if (!remedy.empty() && health != Health::kGood)
      print_typed(stdout, "         mend: %s\n", remedy.c_str());
    bad_ += health == Health::kBad;
  }
  int bad() const { return bad_; }

 private:
  int bad_ = 0;
};

std::string in_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string file = folder + "/" + program;
    if (access(file.c_str(), X_OK) == 0) return file;
  }
  return "";
}

void check_network(Report& report, const std::string& url) {
  const std::string scheme = "udpm://";
  const std::string group =
      url.starts_with(scheme)
          ? url.substr(scheme.size(), url.find(':', scheme.size()) - scheme.size())
          : "";
  if (group.empty()) {
    report.add(Health::kGood, "bus " + url + " is not multicast: no route is needed");
    return;
  }
  std::string why;
  if (has_route(group, why)) {
    report.add(Health::kGood, "route for multicast to " + group);
  } else {
    report.add(Health::kBad,
               "no route for multicast to " + group + " (" + why + "): LCM cannot start",
               "sudo ip link set lo up && sudo ip route add 224.0.0.0/4 dev lo");
  }
  const long buffer = std::atol(first_line_of("/proc/sys/net/core/rmem_max").c_str());
  report.add(buffer >= kWantedBuffer ? Health::kGood : Health::kCould,
             "largest socket buffer (net.core.rmem_max) " + std::to_string(buffer) + " bytes" +
                 (buffer >= kWantedBuffer ? "" : ", 4194304 keep bursts of messages whole"),
             "sudo sysctl -w net.core.rmem_max=4194304");
}

void check_bus(Report& report, const std::string& url) {
  try {
    BusLink bus(url, "");
    bus.listen(0.5);
    const auto sources = bus.seen().sources(monotonic_ns());
    const auto processes = bus.seen().processes(monotonic_ns());
    if (sources.empty() && processes.empty()) {
      report.add(Health::kGood, "bus " + bus.url() + " opens, and nobody is on it");
    } else {
      report.add(Health::kGood,
                 "bus " + bus.url() + " is in use: " + std::to_string(processes.size()) +
                     " processes" + (sources.empty() ? "" : ", " + describe(*sources.front())));
    }
  } catch (const std::exception& error) {
    report.add(Health::kBad, std::string("the bus does not open: ") + error.what());
  }
}

void check_java(Report& report) {
  const std::string java = in_path("java");
  report.add(java.empty() ? Health::kCould : Health::kGood,
             java.empty() ? "no java: ./twinbus spy needs it" : "java: " + java,
             "sudo apt-get install default-jre");
  for (const auto& [jar, package] : {std::pair("lcm.jar", "liblcm-java"), std::pair("jchart2d.jar", "libjchart2d-java")}) {
    bool there = false;
    for (const char* folder : {"/usr/share/java/", "/usr/local/share/java/"})
      there = there || fs::exists(std::string(folder) + jar);
    report.add(there ? Health::kGood : Health::kCould,
               there ? std::string(jar) + " for lcm-spy" : std::string("no ") + jar + ": ./twinbus spy needs it",
               std::string("sudo apt-get install ") + package);
  }
  const std::string types = fs::path(program_folder()).parent_path().string() + "/share/types.jar";
  report.add(fs::exists(types) ? Health::kGood : Health::kCould,
             fs::exists(types) ? "types for lcm-spy: " + types
                               : "no " + types + ": lcm-spy would not decode",
             program_is_installed() ? "make the package anew where default-jdk-headless and liblcm-java are installed"
                                    : "sudo apt-get install default-jdk-headless liblcm-java && rm -r build/release && "
                                      "./twinbus status");
}

// What Docker and Podman leave for whoever is inside.
bool in_container() {
  return fs::exists("/.dockerenv") || fs::exists("/run/.containerenv");
}
constexpr char kContainerRights[] =
    "docker run --cap-add SYS_NICE --ulimit rtprio=90 --ulimit memlock=-1 ...";

void check_real_time(Report& report, bool in_detail) {
  sched_param before{};
  const int policy = sched_getscheduler(0);
  sched_getparam(0, &before);
  sched_param wanted{};
  wanted.sched_priority = 60;
  const bool fifo = sched_setscheduler(0, SCHED_FIFO, &wanted) == 0;
  const std::string why = fifo ? "" : std::strerror(errno);
  if (fifo) sched_setscheduler(0, policy, &before);
  report.add(fifo ? Health::kGood : Health::kCould,
             fifo ? "FIFO priority is allowed"
                  : "no FIFO priority (" + why + "): up to 1 % of the ticks may be missed",
             in_container() ? kContainerRights
                            : "run as root, or: echo '@sudo - rtprio 90' | sudo tee "
                              "/etc/security/limits.d/twinbus.conf, and log in again");
  const bool hard = may_enter_real_time();
  report.add(Health::kGood, hard ? "simulated worlds keep a hard clock, for loops have FIFO priority here (./twinbus up --no-fifo: they "
                                   "wait for late commands)"
                                 : "simulated worlds wait up to 200 ms for a late command, for loops have no FIFO priority here: "
                                   "slower than real time when the machine is busy (./twinbus up --strict: hard clock)");
  if (!in_detail) return;
  const bool locked = mlockall(MCL_CURRENT) == 0;
  report.add(locked ? Health::kGood : Health::kCould,
             locked ? "memory can be locked"
                    : std::string("memory cannot be locked (") + std::strerror(errno) + ")",
             in_container() ? kContainerRights
                            : "echo '@sudo - memlock unlimited' | sudo tee -a "
                              "/etc/security/limits.d/twinbus.conf, and log in again");
  if (locked) munlockall();
  const bool awake = access("/dev/cpu_dma_latency", W_OK) == 0;
  report.add(
      awake ? Health::kGood : Health::kCould,
      awake ? "CPUs are kept awake between ticks while a stack runs (TWINBUS_CPU_SLEEP=1 saves "
              "their power instead)"
            : "/dev/cpu_dma_latency cannot be written: CPUs may sleep between ticks and wake late",
      "sudo chmod o+w /dev/cpu_dma_latency");
  const std::string runtime = first_line_of("/proc/sys/kernel/sched_rt_runtime_us");
  report.add(Health::kGood, "share of a CPU for real-time tasks: " +
                                (runtime.empty() ? "unknown" : runtime) + " us per 1000000");
  report.add(fs::exists("/sys/kernel/realtime") ? Health::kGood : Health::kCould,
             fs::exists("/sys/kernel/realtime")
                 ? "PREEMPT_RT kernel"
                 : "no PREEMPT_RT kernel: enough for 500 Hz, not for 2 kHz",
             "sudo apt-get install linux-image-rt-amd64");
  const std::string governor = first_line_of("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  if (!governor.empty()) {
    report.add(governor == "performance" ? Health::kGood : Health::kCould,
               "CPU governor " + governor,
               "echo performance | sudo tee /sys/devices/system/cpu/cpu*/cpufreq/scaling_governor");
  }
  report.add(Health::kGood, std::to_string(sysconf(_SC_NPROCESSORS_ONLN)) + " CPUs");
}

void check_packages(Report& report) {
  std::ifstream list(install_folder() + "/config/packages.txt");
  std::ifstream status_file("/var/lib/dpkg/status");
  if (!list || !status_file) return;  // not a source tree, or not Debian
  std::stringstream buffer;
  buffer << status_file.rdbuf();
  std::vector<std::string> installed;
  std::string name;
  for (std::string line; std::getline(buffer, line);) {
    if (line.starts_with("Package: ")) name = line.substr(9);
    if (line == "Status: install ok installed") installed.push_back(name);
  }
  const char* release_file = std::getenv("TWINBUS_OS_RELEASE");
  std::ifstream release(release_file != nullptr ? release_file : "/etc/os-release");
  const PackageList wanted = packages_for(list, release_names(release));
  const auto lacking = [&](const std::vector<std::string>& packages) {
    std::string words;
    for (const std::string& package : packages) {
      if (std::find(installed.begin(), installed.end(), package) == installed.end()) words += " " + package;
    }
    return words;
  };
  const std::string missing = lacking(wanted.needed), for_spy = lacking(wanted.spy);
  report.add(missing.empty() ? Health::kGood : Health::kBad,
             missing.empty()
                 ? "all " + std::to_string(wanted.needed.size()) + " packages of config/packages.txt are installed"
                 : "packages are missing:" + missing,
             "sudo apt-get install" + missing);
  if (!for_spy.empty()) {
    report.add(Health::kCould, "packages that only ./twinbus spy needs are missing:" + for_spy,
               "sudo apt-get install" + for_spy);
  }
}

void check_space(Report& report) {
  std::error_code error;
  const fs::space_info space = fs::space(install_folder(), error);
  if (error) return;
  const double free_gb = 1e-9 * static_cast<double>(space.available);
  report.add(free_gb > 2.0 ? Health::kGood : Health::kCould, formatted("%.1f GB free for runs and builds", free_gb), "rm -r runs");
}

}  // namespace

int doctor_command(const std::vector<std::string>& words) {
  const Arguments arguments({"doctor", 0, 0, R"(
Looks at this machine: packages, multicast, buffers, the bus, Java for lcm-spy, real-time rights; names
what is missing and the command that mends it.  Exit status 1 if something needed is missing.
  --rt  real-time rights, kernel and CPU in detail
  --url)"}, words);
  catch_quit_signals();
  const std::string url = arguments.text("--url", default_url());
  Report report;
  check_packages(report);
  check_network(report, url);
  check_bus(report, url);
  check_java(report);
  check_real_time(report, arguments.has("--rt"));
  check_space(report);
  return report.bad() == 0 ? 0 : 1;
}

}  // namespace twinbus::launcher
