// MuJoCo's library, opened at run time: nothing of it is needed to build twinbus.
//
// Looked for in this order: $TWINBUS_MUJOCO (a file, or a folder that holds libmujoco.so*), the system's library folders, and
// the `mujoco` wheel of $VIRTUAL_ENV, $CONDA_PREFIX, the python3 on PATH, the user's own packages.
//
// Functions are stable from release to release; structs are not.  Everything therefore goes through functions (mj_getState,
// mj_setState, mj_contactForce, ...) but for two things that no function hands out: the list of contacts and the armatures of
// the joints.  Where they are is in a table of releases, and what the table says is held against a small scene of known
// contacts, forces and accelerations before anything is simulated.

#pragma once

#include <csetjmp>
#include <cstddef>
#include <string>

namespace twinbus::inline sim {

struct mjModelOpaque;
struct mjDataOpaque;

// A contact as MuJoCo found it at the start of the step.
struct SolvedContact {
  double distance;        // negative: depth [m]
  double position[3];     // world [m]
  double frame[9];        // rows: normal from geom[0] to geom[1], two tangents; world
  int geom[2];
};

class MujocoLibrary {
 public:
  // Opened once for the process.  Throws std::runtime_error with the remedy where there is none, or it is a release whose
  // contacts cannot be read.
  static const MujocoLibrary& get();

  const std::string& version() const { return version_; }
  const std::string& file() const { return file_; }

  // Bits of mj_getState and mj_setState, which differ between releases.
  struct StateBits {
    int qpos, qvel, warmstart, qfrc_applied, xfrc_applied, mocap_pos, mocap_quat;
  };
  const StateBits& bits() const { return bits_; }
  static constexpr int kBody = 1, kJoint = 3, kGeom = 5;  // mjtObj

  int contact_count(const mjDataOpaque* data) const noexcept;
  SolvedContact contact(const mjDataOpaque* data, int index) const noexcept;
  // Inertias added to the joints, in the order of velocities; they may be changed between steps [kg m^2 or kg].
  struct Armatures {
    double* own = nullptr;
    double* whole = nullptr;  // with what moves behind the joint, which MuJoCo takes for joints that move one simple body
    void set(std::size_t joint, double value) const noexcept {
      whole[joint] += value - own[joint];
      own[joint] = value;
    }
  };
  Armatures armatures(mjModelOpaque* model) const noexcept;

  // Calls something of MuJoCo.  False: it complained of an error (which would end the process by itself).
  template <class Call>
  bool guarded(const Call& call) const noexcept {
    Recovery recovery;
    if (setjmp(recovery.place) != 0) return leave(false);
    enter(recovery);
    call();
    return leave(true);
  }

  // The model of an MJCF text; meshes: name of the file and its text.  Throws std::runtime_error with what MuJoCo says.
  struct File {
    std::string name, text;
  };
  mjModelOpaque* load(const std::string& xml, const File* files, std::size_t count) const;

  // As MuJoCo declares them.
  int (*version_number)() = nullptr;
  const char* (*version_string)() = nullptr;
  mjDataOpaque* (*make_data)(const mjModelOpaque*) = nullptr;
  void (*delete_data)(mjDataOpaque*) = nullptr;
  void (*delete_model)(mjModelOpaque*) = nullptr;
  void (*step)(const mjModelOpaque*, mjDataOpaque*) = nullptr;
  void (*forward)(const mjModelOpaque*, mjDataOpaque*) = nullptr;
  void (*set_const)(mjModelOpaque*, mjDataOpaque*) = nullptr;  // leaves the data in the posture of the file
  int (*state_size)(const mjModelOpaque*, int) = nullptr;
  void (*get_state)(const mjModelOpaque*, const mjDataOpaque*, double*, int) = nullptr;
  void (*set_state)(const mjModelOpaque*, mjDataOpaque*, const double*, int) = nullptr;
  int (*name_to_id)(const mjModelOpaque*, int, const char*) = nullptr;
  const char* (*id_to_name)(const mjModelOpaque*, int, int) = nullptr;
  void (*contact_force)(const mjModelOpaque*, const mjDataOpaque*, int, double*) = nullptr;

 private:
  struct Recovery {
    std::jmp_buf place;
  };
  // Where mjModel keeps armatures and mjData its contacts, and how far apart these are.
  struct Layout {
    int release;  // mj_version()
    std::size_t armatures, masses, count, list, stride, geom;  // [bytes]
    bool history;                                      // the state has one bit more
  };
  static const Layout kLayouts[];
  static std::size_t layout_count();

  MujocoLibrary();
  void resolve();
  void choose_layout();
  std::string complaint_of(const Layout& layout);
  static void enter(Recovery& recovery) noexcept;
  static bool leave(bool good) noexcept;
  static void on_error(const char* text);

  void* handle_ = nullptr;
  std::string file_, version_;
  StateBits bits_{};
  Layout layout_{};
  mjModelOpaque* (*load_xml_)(const char*, const void*, char*, int) = nullptr;
  void (*default_vfs_)(void*) = nullptr;
  int (*add_buffer_vfs_)(void*, const char*, const void*, int) = nullptr;
  void (*delete_vfs_)(void*) = nullptr;
};

}  // namespace twinbus::sim
