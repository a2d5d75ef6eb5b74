// The module twinbus._native: what python/twinbus wraps with names, types and docstrings.
//
// Arrays are views into the simulation's own memory, which stays where it is; each keeps its simulation alive.  What takes time
// releases the interpreter; one simulation is used by one thread at a time, a second one is refused.

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>

#include <atomic>
#include <cstdlib>
#include <stdexcept>

#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/wire.h"
#include "python/simulation/robot_query.h"
#include "python/simulation/simulation.h"
#include "python/simulation/worlds.h"
#include "robot/description/named_hands.h"

namespace nb = nanobind;
using namespace twinbus;

namespace {

using Array = nb::ndarray<nb::numpy>;
using Numbers = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Settings = std::vector<std::pair<std::string, std::string>>;

// A second thread in one simulation would see half a step.
class Turn {
 public:
  explicit Turn(std::atomic<bool>& busy) : busy_(busy) {
    if (busy_.exchange(true)) throw std::runtime_error("this simulation is at work in another thread");
  }
  ~Turn() { busy_ = false; }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  std::atomic<bool>& busy_;
};

template <class T>
struct Shared {
  std::unique_ptr<T> is;
  std::atomic<bool> busy = false;
};

SimulationConfig config_of(const std::string& scene, const std::string& robot, const std::string& engine, const std::string& pose,
                           std::uint64_t seed, bool controller, bool guard, bool fade, const Settings& settings) {
  return {.scene = scene, .robot = robot, .engine = engine, .start_pose = pose, .seed = seed, .controller = controller,
          .guard = guard, .fade = fade, .settings = settings};
}

// What cannot be loaded is a wrong argument.
template <class Make>
auto made(Make make) {
  try {
    nb::gil_scoped_release free;
    return make();
  } catch (const std::runtime_error& error) {
    throw nb::value_error(error.what());
  }
}

Eigen::Vector3d vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

int link_of(const Model& model, const std::string& link) {
  const int index = model.find_link(link);
  if (index < 0) throw nb::value_error(("the robot has no moving link '" + link + "'").c_str());
  return index;
}

void check(Status push) {
  if (push != Status::kOk) throw nb::value_error((std::string("push: ") + to_text(push)).c_str());
}

// Views of `rows` structs that lie `stride` bytes apart; rows < 0: of one, without that axis.
class Views {
 public:
  Views(nb::handle owner, int rows, std::size_t stride) : owner_(owner), rows_(rows), stride_(stride) {}

  template <class T>
  void add(const char* name, T* first, std::initializer_list<std::size_t> shape = {}) {
    std::vector<std::size_t> sizes(shape);
    std::vector<std::int64_t> strides(sizes.size());
    std::int64_t step = 1;
    for (std::size_t i = sizes.size(); i-- > 0;) {
      strides[i] = step;
      step *= static_cast<std::int64_t>(sizes[i]);
    }
    put(name, first, sizes, strides);
  }
  // Rows of an inner array of which only the first `columns` of `wide` are looked at.
  template <class T>
  void put(const char* name, T* first, std::vector<std::size_t> sizes, std::vector<std::int64_t> strides) {
    if (rows_ >= 0) {
      sizes.insert(sizes.begin(), static_cast<std::size_t>(rows_));
      strides.insert(strides.begin(), static_cast<std::int64_t>(stride_ / sizeof(T)));
    }
    if (sizes.empty()) {  // one number: an array of one
      sizes.push_back(1);
      strides.push_back(1);
    }
    found_[name] = nb::cast(Array(first, sizes.size(), sizes.data(), owner_, strides.data(), nb::dtype<T>()));
  }
  nb::dict take() { return found_; }

 private:
  nb::handle owner_;
  int rows_;
  std::size_t stride_;
  nb::dict found_;
};

void add_state(Views& views, RobotState& s, std::size_t n) {
  views.add("tick", &s.tick);
  views.add("time_ns", &s.time_ns);
  views.add("stop_kind", reinterpret_cast<std::int8_t*>(&s.stop_kind));
  views.add("q", s.q.data(), {n});
  views.add("qd", s.qd.data(), {n});
  views.add("tau", s.tau.data(), {n});
  views.add("attitude", s.attitude.data(), {4});
  views.add("gyro", s.gyro.data(), {3});
  views.add("accel", s.accel.data(), {3});
  views.add("wrench", s.wrench[0].data(), {kLimbs, 6});
}

void add_command(Views& views, JointCommand& c, std::size_t n) {
  views.add("q", c.q.data(), {n});
  views.add("qd", c.qd.data(), {n});
  views.add("tau", c.tau.data(), {n});
  views.add("kp", c.kp.data(), {n});
  views.add("kd", c.kd.data(), {n});
}

void add_truth(Views& views, SimTruth& t) {
  views.add("fell", &t.fell);
  views.add("base_position", t.base_position.data(), {3});
  views.add("base_attitude", t.base_attitude.data(), {4});
  views.add("base_velocity", t.base_velocity.data(), {3});
  views.add("base_angular_velocity", t.base_angular_velocity.data(), {3});
  views.add("com", t.com.data(), {3});
  views.add("com_velocity", t.com_velocity.data(), {3});
  views.add("zmp", t.zmp.data(), {2});
  views.add("foot_position", t.foot_position[0].data(), {kMaxFeet, 3});
  views.add("foot_force", t.foot_force[0].data(), {kMaxFeet, 3});
}

nb::dict describe(const Model& model) {
  nb::dict found;
  const auto of_joints = [&](auto Joint::* value) {
    nb::list list;
    for (const int j : model.bus_joints) list.append(model.joints[static_cast<std::size_t>(j)].*value);
    return list;
  };
  nb::list links;
  for (const Link& link : model.links) links.append(link.name);
  nb::dict poses;
  for (const NamedPose& pose : model.poses) {
    nb::list q;
    for (const int j : model.bus_joints) q.append(pose.q[static_cast<std::size_t>(j)]);
    poses[pose.name.c_str()] = q;
  }
  nb::dict hands, grippers;
  for (const Hand* hand : hands_of(model)) {
    hands[hand->name.c_str()] = number_of(model, *hand) + 1;
    const Gripper gripper = gripper_of(model, *hand);
    nb::dict joints;
    for (std::size_t i = 0; i < gripper.joints.size(); ++i) {
      const Joint& joint = model.joints[static_cast<std::size_t>(gripper.joints[i])];
      joints[joint.name.c_str()] = nb::make_tuple(gripper.closed[i], gripper.open[i]);
    }
    if (!gripper.joints.empty()) grippers[hand->name.c_str()] = joints;
  }
  found["hands"] = hands;
  found["grippers"] = grippers;
  found["name"] = model.name;
  found["folder"] = model.folder;
  found["joints"] = of_joints(&Joint::name);
  found["links"] = links;
  found["lower"] = of_joints(&Joint::lower);
  found["upper"] = of_joints(&Joint::upper);
  found["velocity"] = of_joints(&Joint::velocity);
  found["effort"] = of_joints(&Joint::effort);
  found["kp"] = of_joints(&Joint::kp);
  found["kd"] = of_joints(&Joint::kd);
  found["poses"] = poses;
  found["period"] = model.period();
  found["mass"] = model.total_mass();
  return found;
}

// orientation: empty, or w x y z.
RobotQuery::Place place_of(const std::array<double, 3>& position, const std::vector<double>& orientation) {
  RobotQuery::Place place{.position = vector_of(position), .orientation = {}};
  if (orientation.empty()) return place;
  if (orientation.size() != 4) throw nb::value_error("orientation: four numbers, w x y z");
  place.orientation.emplace(orientation[0], orientation[1], orientation[2], orientation[3]);
  return place;
}

// Shape, size, position, attitude w x y z.
using BoxOrBall = std::tuple<int, std::array<double, 3>, std::array<double, 3>, std::array<double, 4>>;

Obstacle obstacle_of(const BoxOrBall& said) {
  const auto& [shape, size, position, attitude] = said;
  const Eigen::Quaterniond turn(attitude[0], attitude[1], attitude[2], attitude[3]);
  if (!(turn.norm() > 1e-6 && turn.norm() < 1e6)) throw nb::value_error("attitude of an obstacle: a quaternion w x y z, not of length zero");
  if (shape < 1 || shape > 3) throw nb::value_error("shape of an obstacle: 1 box, 2 sphere, 3 cylinder");
  Obstacle obstacle;
  obstacle.shape = static_cast<ObstacleShape>(shape);
  obstacle.size = vector_of(size);
  obstacle.pose.translation() = vector_of(position);
  obstacle.pose.linear() = turn.normalized().toRotationMatrix();
  return obstacle;
}

template <class T>
T decoded(const nb::bytes& body) {
  T value;
  const auto* data = static_cast<const std::uint8_t*>(body.data());
  if (decode(std::span<const std::uint8_t>(data, body.size()), value) != Status::kOk)
    throw nb::value_error("a message of another type, or with a number that is not finite");
  return value;
}

void say(Shared<Simulation>& simulation, const std::string& channel, const nb::bytes& body) {
  const Turn turn(simulation.busy);
  OneProcess& process = simulation.is->process();
  if (channel == channel::kModeRequest) {
    process.say(decoded<ModeRequest>(body));
  } else if (channel == channel::kWalk) {
    process.say(decoded<WalkCommand>(body));
  } else if (channel == channel::kArmGoal) {
    process.say(decoded<ArmGoal>(body));
  } else if (channel == channel::kStop) {
    process.say(decoded<StopRequest>(body));
  } else {
    throw nb::value_error((channel + ": one of MODE_REQUEST, WALK, ARM_GOAL, STOP").c_str());
  }
}

template <class Ticking>
void step(Ticking& self, int ticks) {
  const Turn turn(self.busy);
  self.is->step(ticks);
}

void bind_simulation(nb::module_& m) {
  using Sim = Shared<Simulation>;
  nb::class_<Sim>(m, "Simulation")
      .def("__init__",
           [](Sim* self, const std::string& scene, const std::string& robot, const std::string& engine, const std::string& pose,
              std::uint64_t seed, bool controller, bool guard, bool fade, const Settings& settings) {
             auto is = made([&] {
               return std::make_unique<Simulation>(
                   config_of(scene, robot, engine, pose, seed, controller, guard, fade, settings));
             });
             new (self) Sim{.is = std::move(is)};
           })
      .def("reset",
           [](Sim& self, std::uint64_t seed) {
             const Turn turn(self.busy);
             self.is->reset(seed);
           },
           nb::call_guard<nb::gil_scoped_release>())
      .def("step", &step<Sim>, nb::call_guard<nb::gil_scoped_release>())
      .def("time", [](Sim& self) { return self.is->time(); })
      .def("seed", [](Sim& self) { return self.is->seed(); })
      .def("state_hash", [](Sim& self) { return self.is->state_hash(); })
      .def("sentences", [](Sim& self) { return self.is->process().take_sentences(); })
      .def("robot", [](Sim& self) { return describe(self.is->model()); })
      .def("scene", [](Sim& self) { return self.is->scene().name; })
      .def("say", &say)
      .def("push",
           [](Sim& self, const std::string& link, const std::array<double, 3>& force, const std::array<double, 3>& point,
              double seconds) {
             const Turn turn(self.busy);
             check(self.is->process().push(link_of(self.is->model(), link), vector_of(force), vector_of(point), seconds));
           })
      .def("views",
           [](nb::object self) {
             auto& s = *nb::cast<Sim&>(self).is;
             const auto n = static_cast<std::size_t>(s.model().bus_count());
             Views state(self, -1, 0), command(self, -1, 0), truth(self, -1, 0);
             add_state(state, s.state(), n);
             add_command(command, s.command(), n);
             add_truth(truth, s.truth());
             return nb::make_tuple(state.take(), command.take(), truth.take());
           });
}

void bind_worlds(nb::module_& m) {
  using Many = Shared<Worlds>;
  nb::class_<Many>(m, "Worlds")
      .def("__init__",
           [](Many* self, const std::string& scene, const std::string& robot, const std::string& engine, const std::string& pose,
              std::uint64_t seed, const Settings& settings, int count, int threads) {
             auto is = made([&] {
               return std::make_unique<Worlds>(config_of(scene, robot, engine, pose, seed, false, false, false, settings), count,
                                               threads);
             });
             new (self) Many{.is = std::move(is)};
           })
      .def("reset",
           [](Many& self, const std::vector<int>& which, const std::vector<std::uint64_t>& seeds) {
             const Turn turn(self.busy);
             self.is->reset(which, seeds);
           },
           nb::call_guard<nb::gil_scoped_release>())
      .def("step", &step<Many>, nb::call_guard<nb::gil_scoped_release>())
      .def("push",
           [](Many& self, int world, const std::string& link, const std::array<double, 3>& force,
              const std::array<double, 3>& point, double seconds) {
             const Turn turn(self.busy);
             check(self.is->push(world, link_of(self.is->model(), link), vector_of(force), vector_of(point), seconds));
           })
      .def("threads", [](Many& self) { return self.is->threads(); })
      .def("robot", [](Many& self) { return describe(self.is->model()); })
      .def("views", [](nb::object self) {
        auto& worlds = *nb::cast<Many&>(self).is;
        std::vector<WorldRow>& rows = worlds.rows();
        const auto n = static_cast<std::size_t>(worlds.model().bus_count());
        const auto make = [&] { return Views(self, static_cast<int>(rows.size()), sizeof(WorldRow)); };
        Views state = make(), command = make(), truth = make();
        add_state(state, rows[0].state, n);
        add_command(command, rows[0].command, n);
        add_truth(truth, rows[0].truth);
        truth.add("hand_position", rows[0].hand[0].data(), {2, 3});
        truth.add("failed", &rows[0].failed);
        return nb::make_tuple(state.take(), command.take(), truth.take());
      });
}

std::vector<double> list_of(const Numbers& numbers) {
  return {numbers.data(), numbers.data() + numbers.size()};
}

void bind_robot(nb::module_& m) {
  using Query = Shared<RobotQuery>;
  nb::class_<Query>(m, "Robot")
      .def("__init__", [](Query* self, const std::string& robot) {
        auto is = made([&] { return std::make_unique<RobotQuery>(robot); });
        new (self) Query{.is = std::move(is)};
      })
      .def("describe", [](Query& self) { return describe(self.is->model()); })
      .def("link_pose",
           [](Query& self, const Numbers& q, const std::string& link) {
             const Turn turn(self.busy);
             return self.is->link_pose(list_of(q), link);
           })
      .def("com",
           [](Query& self, const Numbers& q) {
             const Turn turn(self.busy);
             return self.is->com(list_of(q));
           })
      .def("jacobian",
           [](Query& self, const Numbers& q, const std::string& link) {
             const Turn turn(self.busy);
             return self.is->jacobian(list_of(q), link);
           })
      .def("nearest",
           [](Query& self, const Numbers& q, int most) {
             const Turn turn(self.busy);
             return self.is->nearest(list_of(q), most);
           })
      .def("inverse", [](Query& self, const Numbers& q, const std::string& hand, const std::array<double, 3>& position,
                         const std::vector<double>& orientation) {
        const Turn turn(self.busy);
        nb::gil_scoped_release free;
        return self.is->inverse(list_of(q), hand, place_of(position, orientation));
      })
      .def("plan", [](Query& self, const Numbers& q, const std::string& hand, const std::array<double, 3>& position,
                      const std::vector<double>& orientation, const std::vector<BoxOrBall>& obstacles, double speed,
                      std::uint64_t seed) {
        const Turn turn(self.busy);
        nb::gil_scoped_release free;
        std::vector<Obstacle> all;
        for (const BoxOrBall& each : obstacles) all.push_back(obstacle_of(each));
        return self.is->plan(list_of(q), hand, place_of(position, orientation), all, speed, seed);
      });
  nb::class_<RobotQuery::Reached>(m, "Reached")
      .def_ro("reached", &RobotQuery::Reached::reached)
      .def_ro("q", &RobotQuery::Reached::q)
      .def_ro("position_error", &RobotQuery::Reached::position_error)
      .def_ro("rotation_error", &RobotQuery::Reached::rotation_error);
  nb::class_<RobotQuery::Near>(m, "Near")
      .def_ro("link_a", &RobotQuery::Near::link_a)
      .def_ro("link_b", &RobotQuery::Near::link_b)
      .def_ro("distance", &RobotQuery::Near::distance);
  nb::class_<RobotQuery::Path>(m, "Path")
      .def_ro("text", &RobotQuery::Path::text)
      .def_ro("joints", &RobotQuery::Path::joints)
      .def_ro("time", &RobotQuery::Path::time)
      .def_ro("q", &RobotQuery::Path::q)
      .def_ro("qd", &RobotQuery::Path::qd);
}

}  // namespace

NB_MODULE(_native, m) {
  m.attr("__version__") = TWINBUS_VERSION;
  m.def("set_config_folder", [](const std::string& folder) { (void)setenv("TWINBUS_CONFIG", folder.c_str(), 0); });
  bind_simulation(m);
  bind_worlds(m);
  bind_robot(m);
}
