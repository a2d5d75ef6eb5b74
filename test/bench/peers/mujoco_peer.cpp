// MuJoCo on a scene written by `physics_cases mjcf`, printing the same lines as physics_cases.
//
//     mujoco_peer version
//     mujoco_peer step MODEL.xml METHOD H [SECONDS]
//     mujoco_peer run  MODEL.xml METHOD H DURATION [REPEATS]
//     mujoco_peer map  MODEL.xml METHOD H DURATION        is the stand stable?
//
// METHOD: euler, rk4, implicit, implicitfast.  Keyframe 0 is the start.  Built by
// test/bench/bench_physics.py against every MuJoCo it finds; nothing else of the project needs it.

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "test/measure.h"

namespace {

using twinbus::thread_cpu_seconds;
using twinbus::median;

bool choose(mjModel* model, const std::string& method) {
  if (method == "euler") {
    model->opt.integrator = mjINT_EULER;
  } else if (method == "rk4") {
    model->opt.integrator = mjINT_RK4;
  } else if (method == "implicit") {
    model->opt.integrator = mjINT_IMPLICIT;
#if mjVERSION_HEADER >= 235
  } else if (method == "implicitfast") {
    model->opt.integrator = mjINT_IMPLICITFAST;
#endif
  } else {
    return false;
  }
  return true;
}

bool sane(const mjModel* model, const mjData* data) {
  for (int i = 0; i < model->nq; ++i) {
    if (!(std::fabs(data->qpos[i]) < 1e4)) return false;
  }
  return data->warning[mjWARN_BADQACC].number == 0 && data->warning[mjWARN_BADQPOS].number == 0;
}

int bodies(const mjModel* model) {
  int n = 0;
  while (mj_name2id(model, mjOBJ_BODY, ("link" + std::to_string(n)).c_str()) >= 0) ++n;
  return n;
}

void step(const mjModel* model, mjData* data, double seconds, double duration) {
  const long most = std::lround(duration / model->opt.timestep);
  std::vector<double> batches;
  const double begun = thread_cpu_seconds();
  long done = most;
  while (thread_cpu_seconds() - begun < seconds) {
    constexpr int kBatch = 32;
    if (done + kBatch > most) {
      mj_resetDataKeyframe(model, data, 0);
      done = 0;
    }
    const double t = thread_cpu_seconds();
    for (int i = 0; i < kBatch; ++i) mj_step(model, data);
    batches.push_back(1e6 * (thread_cpu_seconds() - t) / kBatch);
    done += kBatch;
  }
  std::printf("us %.4f\n", median(batches));
}

void run(const mjModel* model, mjData* data, double duration, int repeats) {
  const long steps = std::lround(duration / model->opt.timestep);
  std::vector<double> costs;
  double total = 0.0;
  for (int r = 0; r < repeats || (total < 0.02 && r < 50 * repeats); ++r) {
    mj_resetDataKeyframe(model, data, 0);
    const double t = thread_cpu_seconds();
    for (long i = 0; i < steps; ++i) mj_step(model, data);
    costs.push_back(1e3 * (thread_cpu_seconds() - t) / duration);
    total += thread_cpu_seconds() - t;
    if (!sane(model, data)) {
      std::printf("failed\n");
      return;
    }
  }
  mj_kinematics(model, data);
  mj_comPos(model, data);
  std::printf("ms_per_s %.6f at", median(costs));
  for (int i = 0; i < bodies(model); ++i) {
    const int id = mj_name2id(model, mjOBJ_BODY, ("link" + std::to_string(i)).c_str());
    for (int k = 0; k < 3; ++k) std::printf(" %.17g", data->xipos[3 * id + k]);
  }
  std::printf("\n");
}

// As physics_cases judges: quiet and upright in the last third.
const char* stands(const mjModel* model, mjData* data, double duration) {
  mj_resetDataKeyframe(model, data, 0);
  data->qvel[0] = data->qvel[1] = 0.02;
  const double height = data->qpos[2];
  const long steps = std::lround(duration / model->opt.timestep);
  std::vector<double> before;
  const int n = bodies(model);
  for (long i = 0; i < steps; ++i) {
    before.assign(data->xpos, data->xpos + 3 * model->nbody);
    mj_step(model, data);
    if (!sane(model, data)) return "diverged";
    if (i < 2 * steps / 3) continue;
    if (!(data->xmat[9 + 8] > 0.98) || !(std::fabs(data->qpos[2] - height) < 0.03)) return "fell";
    for (int c = 0; c < data->ncon; ++c) {
      if (!(data->contact[c].dist > -5e-3)) return "sank";
    }
    for (int k = 1; k <= n; ++k) {
      double moved = 0.0;
      for (int a = 0; a < 3; ++a) moved += std::pow(data->xpos[3 * k + a] - before[3 * k + a], 2);
      if (!(std::sqrt(moved) / model->opt.timestep < 0.5)) return "shakes";
    }
  }
  return "stable";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "version") == 0) {
    std::printf("%s\n", mj_versionString());
    return 0;
  }
  if (argc < 5) {
    std::fprintf(stderr, "usage: see the head of mujoco_peer.cpp\n");
    return 2;
  }
  char error[1000] = "";
  mjModel* model = mj_loadXML(argv[2], nullptr, error, sizeof error);
  if (model == nullptr) {
    std::fprintf(stderr, "mujoco_peer: %s\n", error);
    return 1;
  }
  if (!choose(model, argv[3])) {
    std::fprintf(stderr, "mujoco_peer: this MuJoCo has no integrator '%s'\n", argv[3]);
    return 1;
  }
  model->opt.timestep = std::atof(argv[4]);
  mjData* data = mj_makeData(model);
  const double fifth = argc > 5 ? std::atof(argv[5]) : 0.3;
  const std::string what = argv[1];
  if (what == "step") {
    step(model, data, fifth, 1.0);
  } else if (what == "run") {
    run(model, data, fifth, argc > 6 ? std::atoi(argv[6]) : 3);
  } else if (what == "map") {
    std::printf("%s\n", stands(model, data, fifth));
  }
  mj_deleteData(data);
  mj_deleteModel(model);
  return 0;
}
