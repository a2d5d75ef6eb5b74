#include "sim/mujoco/mujoco_library.h"

#include <dlfcn.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "sim/mujoco/find_mujoco.h"

namespace twinbus::inline sim {

namespace {

constexpr const char* kRemedy =
    "`pip install mujoco` into the Python environment that is active, or set TWINBUS_MUJOCO to a libmujoco.so";

thread_local std::jmp_buf* recovery_place = nullptr;
thread_local std::array<char, 300> last_error{};

void on_warning(const char*) {}  // would write a file into the working folder; what diverged is seen by its numbers

// Whether bytes can be read there, asked of the kernel; less than a pipe holds.
bool readable(const void* start, std::size_t offset, std::size_t size) {
  int ends[2];
  if (::pipe(ends) != 0) return false;
  const bool good = ::write(ends[1], static_cast<const char*>(start) + offset, size) == static_cast<ssize_t>(size);
  ::close(ends[0]);
  ::close(ends[1]);
  return good;
}

template <class Number>
Number number_at(const void* start, std::size_t offset) noexcept {
  Number value;
  std::memcpy(&value, static_cast<const char*>(start) + offset, sizeof value);
  return value;
}

// Two balls on a plane, 0.5 and 0.7 mm deep, a sledge and an arm with armatures, a body that is placed.
constexpr const char* kProbe = R"(<mujoco><option timestep="0.002" integrator="implicitfast"/>
<worldbody><geom name="ground" type="plane" size="5 5 1"/>
<body name="a" pos="0.3 -0.2 0.0995"><freejoint/><geom name="a" size="0.1" mass="2"/></body>
<body name="b" pos="-0.4 0.6 0.0993"><freejoint/><geom name="b" size="0.1" mass="2"/></body>
<body name="sledge" pos="0 0 1"><joint name="sledge" type="slide" axis="1 0 0" armature="0.25"/>
<geom size="0.1" mass="2" contype="0" conaffinity="0"/></body>
<body name="arm" pos="0 3 1"><joint name="arm" type="hinge" axis="0 1 0" armature="0.25"/>
<geom size="0.1" pos="0 0 -0.5" mass="2" contype="0" conaffinity="0"/></body>
<body name="placed" mocap="true" pos="0 0 2"><geom size="0.1" contype="0" conaffinity="0"/></body></worldbody></mujoco>)";

constexpr double kArm = 2.0 * 0.25 + 0.4 * 2.0 * 0.01;  // inertia about its hinge [kg m^2]

bool near(double a, double b) { return std::abs(a - b) <= 1e-9 * (1.0 + std::abs(b)); }

}  // namespace

// As test/tools/mujoco_layout.py reads them in a release's headers.
const MujocoLibrary::Layout MujocoLibrary::kLayouts[] = {
    {327, 1824, 1848, 161584, 162464, 576, 532, false},
    {337, 1864, 1888, 161576, 162368, 576, 532, false},
    {3005000, 2232, 2256, 161576, 162432, 576, 532, true},
    {4000000, 2344, 2376, 160560, 161488, 608, 564, true},
};
std::size_t MujocoLibrary::layout_count() { return std::size(kLayouts); }

void MujocoLibrary::enter(Recovery& recovery) noexcept { recovery_place = &recovery.place; }

bool MujocoLibrary::leave(bool good) noexcept {
  recovery_place = nullptr;
  return good;
}

void MujocoLibrary::on_error(const char* text) {
  std::strncpy(last_error.data(), text != nullptr ? text : "", last_error.size() - 1);
  if (recovery_place != nullptr) std::longjmp(*recovery_place, 1);
}

const MujocoLibrary& MujocoLibrary::get() {
  static const MujocoLibrary library;
  return library;
}

MujocoLibrary::MujocoLibrary() {
  std::string tried;
  for (const std::string& file : mujoco_files()) {
    handle_ = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ != nullptr) {
      file_ = file;
      break;
    }
    const char* why = ::dlerror();
    if (file.find('/') != std::string::npos) tried += std::string("; ") + (why != nullptr ? why : file.c_str());
  }
  if (handle_ == nullptr)
    throw std::runtime_error(std::string("engine mujoco: no library of MuJoCo is found") + tried + "; " + kRemedy);
  resolve();
  version_ = version_string();
  choose_layout();
}

void MujocoLibrary::resolve() {
  const auto find = [this](const char* name, auto& function) {
    void* symbol = ::dlsym(handle_, name);
    if (symbol == nullptr)
      throw std::runtime_error("engine mujoco: " + file_ + " has no " + name + ", it is older than 3.2; " + kRemedy);
    std::memcpy(&function, &symbol, sizeof symbol);
  };
  find("mj_version", version_number);
  find("mj_versionString", version_string);
  find("mj_makeData", make_data);
  find("mj_deleteData", delete_data);
  find("mj_deleteModel", delete_model);
  find("mj_step", step);
  find("mj_forward", forward);
  find("mj_setConst", set_const);
  find("mj_stateSize", state_size);
  find("mj_getState", get_state);
  find("mj_setState", set_state);
  find("mj_name2id", name_to_id);
  find("mj_id2name", id_to_name);
  find("mj_contactForce", contact_force);
  find("mj_loadXML", load_xml_);
  find("mj_defaultVFS", default_vfs_);
  find("mj_addBufferVFS", add_buffer_vfs_);
  find("mj_deleteVFS", delete_vfs_);
  void (**handler)(const char*) = nullptr;
  find("mju_user_error", handler);
  *handler = &on_error;
  find("mju_user_warning", handler);
  *handler = &on_warning;
  // Older ones have a file system of another kind.
  if (version_number() < kLayouts[0].release - 7)
    throw std::runtime_error("engine mujoco: " + file_ + " is MuJoCo " + version_string() + ", older than 3.2; " + kRemedy);
}

mjModelOpaque* MujocoLibrary::load(const std::string& xml, const File* files, std::size_t count) const {
  static std::mutex one_at_a_time;  // the parser has global state
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  std::array<void*, 8> vfs{};  // since 3.2 one pointer
  std::array<char, 1000> error{};
  mjModelOpaque* model = nullptr;
  default_vfs_(vfs.data());
  bool stored = add_buffer_vfs_(vfs.data(), "scene.xml", xml.data(), static_cast<int>(xml.size())) == 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& text = files[i].text;
    stored = add_buffer_vfs_(vfs.data(), files[i].name.c_str(), text.data(), static_cast<int>(text.size())) == 0 && stored;
  }
  if (stored && !guarded([&] { model = load_xml_("scene.xml", vfs.data(), error.data(), static_cast<int>(error.size())); }))
    std::memcpy(error.data(), last_error.data(), last_error.size());
  delete_vfs_(vfs.data());
  if (model == nullptr)
    throw std::runtime_error(std::string("engine mujoco: MuJoCo refuses the scene: ") +
                             (stored ? error.data() : "its files have one name"));
  return model;
}

int MujocoLibrary::contact_count(const mjDataOpaque* data) const noexcept { return number_at<int>(data, layout_.count); }

MujocoLibrary::Armatures MujocoLibrary::armatures(mjModelOpaque* model) const noexcept {
  return {number_at<double*>(model, layout_.armatures), number_at<double*>(model, layout_.masses)};
}

SolvedContact MujocoLibrary::contact(const mjDataOpaque* data, int index) const noexcept {
  const char* each = number_at<const char*>(data, layout_.list) + layout_.stride * static_cast<std::size_t>(index);
  SolvedContact contact;
  std::memcpy(&contact.distance, each, 13 * sizeof(double));
  std::memcpy(contact.geom, each + layout_.geom, sizeof contact.geom);
  return contact;
}

// The row of this release first, then the others: a release between two of the table mostly has the one or the other.
void MujocoLibrary::choose_layout() {
  std::string complaint, first;
  for (const bool own : {true, false}) {
    for (std::size_t i = layout_count(); i-- > 0;) {
      if ((kLayouts[i].release == version_number()) != own) continue;
      complaint = complaint_of(kLayouts[i]);
      if (complaint.empty()) return;
      if (first.empty()) first = complaint;
    }
  }
  std::string known;
  for (std::size_t i = 0; i < layout_count(); ++i)
    known += (i > 0 ? ", " : "") + std::to_string(kLayouts[i].release);
  throw std::runtime_error("engine mujoco: MuJoCo " + version_ + " (" + file_ +
                           ") keeps armatures or contacts where no release that is known does (" + first + "); `pip install mujoco==4.0.0`, or add what test/tools/mujoco_layout.py says of it to "
                           "sim/mujoco/mujoco_library.cpp; known: " + known);
}

std::string MujocoLibrary::complaint_of(const Layout& layout) {
  const int more = layout.history ? 1 : 0;
  const auto shifted = [more](int bit) { return 1 << (bit + more); };
  layout_ = layout;
  bits_ = {1 << 1, 1 << 2, shifted(4), shifted(6), shifted(7), shifted(9), shifted(10)};
  mjModelOpaque* model = load(kProbe, nullptr, 0);
  mjDataOpaque* data = make_data(model);
  const auto found = [&]() -> std::string {
    const std::array<std::array<int, 2>, 7> sizes{{{bits_.qpos, 16}, {bits_.qvel, 14}, {bits_.warmstart, 14},
                                                   {bits_.qfrc_applied, 14},
                                                   {bits_.xfrc_applied, 36}, {bits_.mocap_pos, 3}, {bits_.mocap_quat, 4}}};
    for (const auto& [bit, size] : sizes) {
      if (state_size(model, bit) != size) return "another order of the state";
    }
    if (!readable(data, layout.count, sizeof(int)) || !readable(data, layout.list, sizeof(void*))) return "a smaller mjData";
    for (const std::size_t place : {layout.armatures, layout.masses}) {
      if (!readable(model, place, sizeof(void*)) || !readable(number_at<const void*>(model, place), 0, 14 * sizeof(double)))
        return "no armatures there";
    }
    const Armatures joints = armatures(model);
    if (joints.own[12] != 0.25 || joints.own[13] != 0.25 || !near(joints.whole[12], 2.25) || !near(joints.whole[13], kArm + 0.25))
      return "other armatures there";
    std::vector<double> qvel(14), force(14);
    for (const std::size_t joint : {12U, 13U}) {
      joints.set(joint, 3.0);
      force[joint] = 8.0;
    }
    set_state(model, data, force.data(), bits_.qfrc_applied);
    if (!guarded([&] { step(model, data); })) return last_error.data();
    if (contact_count(data) != 2) return "no count of contacts there";
    if (!readable(number_at<const char*>(data, layout.list), 0, 2 * layout.stride)) return "no list of contacts there";
    for (int i = 0; i < 2; ++i) {
      const SolvedContact each = contact(data, i);
      const double x = i == 0 ? 0.3 : -0.4, y = i == 0 ? -0.2 : 0.6, depth = i == 0 ? 5e-4 : 7e-4;
      std::array<double, 6> pressed{};
      contact_force(model, data, i, pressed.data());
      if (!near(each.distance, -depth) || !near(each.position[0], x) || !near(each.position[1], y) ||
          !near(each.position[2], -0.5 * depth) || !near(each.frame[2], 1.0) || each.geom[0] != 0 || each.geom[1] != i + 1 ||
          !(pressed[0] > 0.0)) {
        return "contacts of another form";
      }
    }
    get_state(model, data, qvel.data(), bits_.qvel);
    const bool moved = near(qvel[12], 0.002 * 8.0 / (2.0 + 3.0)) && near(qvel[13], 0.002 * 8.0 / (kArm + 3.0));
    return moved ? "" : "armatures that do nothing";
  }();
  delete_data(data);
  delete_model(model);
  return found;
}

}  // namespace twinbus::sim
