// The largest push a standing robot survives, per direction, with and without the balance controller.
//
//     pushes_bench [--robot R] [--set key=value ...] [--csv F] [--one IX IY] [--trace] [--only DEGREES]

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "robot/description/load.h"
#include "common/process/process.h"
#include "test/control/sim_rig.h"

namespace twinbus {
namespace {

constexpr double kAt = 1.5;      // [s] when the push begins
constexpr double kAfter = 4.0;   // [s] watched after it
constexpr double kStep = 2.5;    // [N s] resolution
constexpr double kMost = 160.0;  // [N s]

struct Case {
  Model model;
  std::string link = "CHEST";
  Settings settings;
  BalanceGains gains;
  bool guard = false;
};

double* find_gain(BalanceGains& g, const std::string& name) {
  const std::pair<const char*, double*> table[] = {
      {"dcm", &g.stabilizer.dcm},
      {"integral", &g.stabilizer.integral},
      {"margin", &g.stabilizer.margin},
      {"cop_filter", &g.stabilizer.cop_filter},
      {"least_load", &g.stabilizer.least_load},
      {"trunk_frequency", &g.trunk.frequency},
      {"trunk_damping", &g.trunk.damping},
      {"trunk_limit", &g.trunk.limit},
      {"trunk_most", &g.trunk.most},
      {"trunk_filter", &g.trunk.filter},
      {"ankle", &g.foot.ankle},
      {"sole_tilt", &g.sole_tilt},
      {"lag", &g.foot.lag},
      {"filter", &g.foot.filter},
      {"velocity_filter", &g.velocity_filter},
      {"leg_kp", &g.leg_kp},
      {"leg_kd", &g.leg_kd},
      {"lead", &g.lead},
      {"waist", &g.trunk.waist},
      {"waist_rate", &g.trunk.waist_rate},
      {"height", &g.height},
      {"height_damping", &g.height_damping},
      {"yaw", &g.yaw},
      {"home_forward", &g.home_forward},
  };
  for (const auto& [key, value] : table) {
    if (name == key) return value;
  }
  return nullptr;
}

RigRecord push(const Case& c, double ix, double iy, bool feedback, bool trace) {
  Scene scene;
  scene.name = "push";
  scene.pushes.push_back(
      {.link = c.link, .point = {0, 0, 0}, .impulse = {ix, iy, 0}, .at = kAt, .duration = 0.1});
  ControlConfig config;
  config.guard_in_loop = c.guard;
  config.gains = c.gains;
  if (!feedback) config.first_mode = Mode::kHold;
  SimRig rig(c.model, scene, c.settings, config);
  const auto n = static_cast<int>((kAt + kAfter) / c.model.period());
  for (int i = 0; i < n && !rig.record().fell; ++i) {
    if (!rig.tick()) break;
    if (i == static_cast<int>(0.5 * kAt / c.model.period())) rig.forget();
    if (trace && i % 5 == 0) {
      const ControllerStatus& s = rig.loop().status();
      const SimTruth& t = rig.truth();
      const double pitch = 2.0 * std::asin(std::clamp(t.base_attitude[2], -1.0, 1.0));
      const double roll = 2.0 * std::asin(std::clamp(t.base_attitude[1], -1.0, 1.0));
      std::printf(
          "%5.2f com %6.1f %6.1f %6.1f ref %6.1f %6.1f dcm %6.1f %6.1f zmp %6.1f %6.1f want %6.1f "
          "%6.1f margin %5.1f "
          "roll %5.2f pitch %5.2f fL %5.0f fR %5.0f tilt %5.2f %5.2f\n",
          i * c.model.period(), 1e3 * double(s.com[0]), 1e3 * double(s.com[1]),
          1e3 * double(s.com[2]), 1e3 * double(s.com_reference[0]),
          1e3 * double(s.com_reference[1]), 1e3 * double(s.dcm[0]), 1e3 * double(s.dcm[1]),
          1e3 * double(s.zmp[0]), 1e3 * double(s.zmp[1]), 1e3 * double(s.zmp_reference[0]),
          1e3 * double(s.zmp_reference[1]), 1e3 * double(t.zmp_margin), roll * 57.3, pitch * 57.3,
          double(t.foot_force[0][2]), double(t.foot_force[1][2]),
          114.6 * double(t.foot_attitude[0][1]), 114.6 * double(t.foot_attitude[1][1]));
    }
  }
  return rig.record();
}

double largest(const Case& c, double degrees, bool feedback) {
  const double x = std::cos(degrees / 57.29577951308232);
  const double y = std::sin(degrees / 57.29577951308232);
  double good = 0.0;
  double bad = kMost;
  while (bad - good > kStep) {
    const double middle = 0.5 * (good + bad);
    (push(c, middle * x, middle * y, feedback, false).fell ? bad : good) = middle;
  }
  return good;
}

int run(int argc, char** argv) {
  Case c;
  std::string robot = "hrp1s";
  std::string csv;
  bool one = false;
  bool trace = false;
  bool feedback = true;
  double ix = 0.0;
  double iy = 0.0;
  for (int i = 1; i < argc; ++i) {
    const std::string a = argv[i];
    if (a == "--robot" && i + 1 < argc) {
      robot = argv[++i];
    } else if (a == "--csv" && i + 1 < argc) {
      csv = argv[++i];
    } else if (a == "--set" && i + 1 < argc) {
      const std::string text = argv[++i];
      const std::size_t equal = text.find('=');
      if (equal == std::string::npos) throw std::invalid_argument("--set wants key=value");
      c.settings.emplace_back(text.substr(0, equal), text.substr(equal + 1));
    } else if (a == "--one" && i + 2 < argc) {
      one = true;
      ix = std::atof(argv[++i]);
      iy = std::atof(argv[++i]);
    } else if (a == "--gain" && i + 1 < argc) {
      const std::string text = argv[++i];
      const std::size_t equal = text.find('=');
      double* gain =
          equal == std::string::npos ? nullptr : find_gain(c.gains, text.substr(0, equal));
      if (gain == nullptr)
        throw std::invalid_argument("--gain wants name=value with a known name, not " + text);
      *gain = std::atof(text.c_str() + equal + 1);
    } else if (a == "--trace") {
      trace = true;
    } else if (a == "--guard") {
      c.guard = true;
    } else if (a == "--without") {
      feedback = false;
    } else {
      std::printf(
          "pushes_bench [--robot R] [--set key=value] [--csv F] [--guard] [--one IX IY [--without] "
          "[--trace]]\n");
      return a == "--help" ? 0 : 2;
    }
  }
  c.model = load_robot(robot);
  if (one) {
    const RigRecord r = push(c, ix, iy, feedback, trace);
    std::printf(
        "push %6.1f %6.1f N s: %s, ZMP margin %6.1f mm, sole tilt %5.2f deg, base tilt %5.2f deg, "
        "slip %5.2f mm, "
        "effort %4.0f %%\n",
        ix, iy, r.fell ? "FALLS" : "stands", 1e3 * r.zmp_margin_min, 57.2958 * r.sole_tilt_max,
        57.2958 * r.base_tilt_max, 1e3 * r.slip_max, 100.0 * r.effort_share_max);
    return r.fell ? 1 : 0;
  }
  std::ofstream out;
  if (!csv.empty()) {
    out.open(csv);
    out << "bench,case,metric,unit,median,p99,p999,max,peer,peer_median,ratio\n";
  }
  std::printf("largest push at the %s within 0.1 s, %s standing [N s]\n", c.link.c_str(),
              robot.c_str());
  std::printf("%-14s %8s %8s\n", "direction", "balance", "without");
  const char* name[] = {"forward", "forward left", "left",  "back left",
                        "back",    "back right",   "right", "forward right"};
  for (int d = 0; d < 8; ++d) {
    const double with = largest(c, 45.0 * d, true);
    const double without = largest(c, 45.0 * d, false);
    std::printf("%-14s %8.1f %8.1f\n", name[d], with, without);
    std::fflush(stdout);
    if (out) {
      out << "push," << name[d] << ",largest,N s," << with << ",,,,"
          << "without," << without << "," << (without > 0.0 ? with / without : 0.0) << "\n";
    }
  }
  return 0;
}

}  // namespace
}  // namespace twinbus

int main(int argc, char** argv) {
  return twinbus::run_process("pushes_bench", twinbus::run, argc, argv);
}
