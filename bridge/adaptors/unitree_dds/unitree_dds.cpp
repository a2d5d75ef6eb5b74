#include "bridge/adaptors/unitree_dds/unitree_dds.h"

#include <dds/dds.h>
#include <sys/eventfd.h>
#include <unistd.h>
#include <unitree_api.h>  // made by idlc from idl/
#include <unitree_go.h>
#include <unitree_hg.h>

#include <cstring>
#include <stdexcept>
#include <string_view>

namespace twinbus::inline bridge {

namespace {

constexpr int kFramesKept = 64;  // between two looks: a writer of rubbish must not push a good one's frames out
constexpr int kCallsKept = 16;
constexpr std::size_t kLongestParameter = 4096;

// What idlc makes lies in memory as bridge/unitree/frames.h says.
#define TWINBUS_SAME(Ours, Theirs, field) static_assert(offsetof(Ours, field) == offsetof(Theirs, field))
static_assert(sizeof(HgLowCmd) == sizeof(unitree_hg_msg_dds__LowCmd_));
static_assert(sizeof(HgMotorCmd) == sizeof(unitree_hg_msg_dds__MotorCmd_));
TWINBUS_SAME(HgMotorCmd, unitree_hg_msg_dds__MotorCmd_, q);
TWINBUS_SAME(HgMotorCmd, unitree_hg_msg_dds__MotorCmd_, kd);
TWINBUS_SAME(HgLowCmd, unitree_hg_msg_dds__LowCmd_, mode_machine);
TWINBUS_SAME(HgLowCmd, unitree_hg_msg_dds__LowCmd_, motor_cmd);
TWINBUS_SAME(HgLowCmd, unitree_hg_msg_dds__LowCmd_, crc);
static_assert(sizeof(HgLowState) == sizeof(unitree_hg_msg_dds__LowState_));
static_assert(sizeof(HgMotorState) == sizeof(unitree_hg_msg_dds__MotorState_));
TWINBUS_SAME(HgMotorState, unitree_hg_msg_dds__MotorState_, temperature);
TWINBUS_SAME(HgMotorState, unitree_hg_msg_dds__MotorState_, vol);
TWINBUS_SAME(HgMotorState, unitree_hg_msg_dds__MotorState_, motorstate);
TWINBUS_SAME(HgLowState, unitree_hg_msg_dds__LowState_, tick);
TWINBUS_SAME(HgLowState, unitree_hg_msg_dds__LowState_, imu_state);
TWINBUS_SAME(HgLowState, unitree_hg_msg_dds__LowState_, motor_state);
TWINBUS_SAME(HgLowState, unitree_hg_msg_dds__LowState_, wireless_remote);
TWINBUS_SAME(HgLowState, unitree_hg_msg_dds__LowState_, crc);
static_assert(sizeof(GoLowCmd) == sizeof(unitree_go_msg_dds__LowCmd_));
TWINBUS_SAME(GoLowCmd, unitree_go_msg_dds__LowCmd_, bandwidth);
TWINBUS_SAME(GoLowCmd, unitree_go_msg_dds__LowCmd_, motor_cmd);
TWINBUS_SAME(GoLowCmd, unitree_go_msg_dds__LowCmd_, bms_cmd);
TWINBUS_SAME(GoLowCmd, unitree_go_msg_dds__LowCmd_, led);
TWINBUS_SAME(GoLowCmd, unitree_go_msg_dds__LowCmd_, crc);
static_assert(sizeof(GoLowState) == sizeof(unitree_go_msg_dds__LowState_));
static_assert(sizeof(GoMotorState) == sizeof(unitree_go_msg_dds__MotorState_));
TWINBUS_SAME(GoMotorState, unitree_go_msg_dds__MotorState_, temperature);
TWINBUS_SAME(GoMotorState, unitree_go_msg_dds__MotorState_, lost);
TWINBUS_SAME(GoLowState, unitree_go_msg_dds__LowState_, imu_state);
TWINBUS_SAME(GoLowState, unitree_go_msg_dds__LowState_, motor_state);
TWINBUS_SAME(GoLowState, unitree_go_msg_dds__LowState_, bms_state);
TWINBUS_SAME(GoLowState, unitree_go_msg_dds__LowState_, foot_force);
TWINBUS_SAME(GoLowState, unitree_go_msg_dds__LowState_, tick);
TWINBUS_SAME(GoLowState, unitree_go_msg_dds__LowState_, adc_reel);
TWINBUS_SAME(GoLowState, unitree_go_msg_dds__LowState_, power_v);
TWINBUS_SAME(GoLowState, unitree_go_msg_dds__LowState_, crc);
#undef TWINBUS_SAME

// A DDS entity, or an error that says what could not be made.
dds_entity_t made(dds_entity_t entity, const std::string& what) {
  if (entity < 0) throw std::runtime_error("DDS: " + what + ": " + dds_strretcode(-entity));
  return entity;
}

// Only characters of interface names: the name becomes part of a configuration in XML.
void check_interface(const std::string& name) {
  constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
  if (name.empty() || name.size() > 15 || name.find_first_not_of(kAllowed) != std::string::npos)
    throw std::runtime_error("--interface: '" + name + "' is no name of a network interface; `ip link` lists them");
}

std::string configuration(const DdsOptions& options) {
  // Loopback has no multicast flag.  Discovery by multicast works there all the same, and so the vendor's Python finds us; its C++
  // asks the flag, and then looks for others at the well-known ports of this machine alone.
  const bool local = options.interface == "lo";
  return "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface name=\"" + options.interface + "\" multicast=\"" +
         (local ? "true" : "default") + "\"/></Interfaces></General>" +
         (local ? "<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>"
                  "<Peers><Peer Address=\"127.0.0.1\"/></Peers></Discovery>"
                : "") +
         "<Internal><MaxSampleSize>65536 B</MaxSampleSize></Internal></Domain></CycloneDDS>";
}

void wake(dds_entity_t, void* event) {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(static_cast<int>(reinterpret_cast<std::intptr_t>(event)), &one, sizeof one);
}

// Deleted with the scope.
struct Qos {
  Qos(dds_reliability_kind_t reliability, int depth) : qos(dds_create_qos()) {
    dds_qset_reliability(qos, reliability, DDS_MSECS(1));
    dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, depth);
  }
  ~Qos() { dds_delete_qos(qos); }
  Qos(const Qos&) = delete;
  Qos& operator=(const Qos&) = delete;
  dds_qos_t* qos;
};

dds_entity_t topic_of(dds_entity_t participant, const dds_topic_descriptor_t& type, const char* name) {
  return made(dds_create_topic(participant, &type, name, nullptr, nullptr), std::string("topic ") + name);
}

dds_entity_t reader_of(dds_entity_t participant, const dds_topic_descriptor_t& type, const char* name, const Qos& qos,
                       int event) {
  dds_listener_t* listener = dds_create_listener(reinterpret_cast<void*>(static_cast<std::intptr_t>(event)));
  dds_lset_data_available(listener, &wake);
  const dds_entity_t reader = dds_create_reader(participant, topic_of(participant, type, name), qos.qos, listener);
  dds_delete_listener(listener);
  return made(reader, std::string("reader of ") + name);
}

dds_entity_t writer_of(dds_entity_t participant, const dds_topic_descriptor_t& type, const char* name, const Qos& qos) {
  return made(dds_create_writer(participant, topic_of(participant, type, name), qos.qos, nullptr), std::string("writer of ") + name);
}

}  // namespace

UnitreeDds::UnitreeDds(UnitreeFamily family, Side side, const DdsOptions& options) : side_(side) {
  check_interface(options.interface);
  event_ = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
  if (event_ < 0) throw std::runtime_error("DDS: no descriptor is left");
  try {
    const auto domain = static_cast<dds_domainid_t>(options.domain);
    domain_ = made(dds_create_domain(domain, configuration(options).c_str()), "domain " + std::to_string(options.domain) + " on interface " +
                                                                                  options.interface);
    participant_ = made(dds_create_participant(domain, nullptr, nullptr),
                        "interface " + options.interface + " cannot be used (is it up? `ip link`)");
    open_frames(family);
    if (side == Side::kRobot) open_service();
  } catch (...) {
    close();
    throw;
  }
}

UnitreeDds::~UnitreeDds() { close(); }

void UnitreeDds::close() noexcept {
  if (domain_ > 0) dds_delete(domain_);
  domain_ = 0;
  if (event_ >= 0) ::close(event_);
  event_ = -1;
}

void UnitreeDds::open_frames(UnitreeFamily family) {
  const bool hg = family == UnitreeFamily::kHg, robot = side_ == Side::kRobot;
  const dds_topic_descriptor_t& state = hg ? unitree_hg_msg_dds__LowState__desc : unitree_go_msg_dds__LowState__desc;
  const dds_topic_descriptor_t& command = hg ? unitree_hg_msg_dds__LowCmd__desc : unitree_go_msg_dds__LowCmd__desc;
  read_bytes_ = robot ? command_bytes(family) : state_bytes(family);
  write_bytes_ = robot ? state_bytes(family) : command_bytes(family);
  // Nothing is asked for again: a frame that was lost is old.  A reader of this kind hears reliable writers too.
  const Qos reads(DDS_RELIABILITY_BEST_EFFORT, kFramesKept);
  const Qos writes(DDS_RELIABILITY_RELIABLE, 1);
  reader_ = reader_of(participant_, robot ? command : state, robot ? "rt/lowcmd" : "rt/lowstate", reads, event_);
  writer_ = writer_of(participant_, robot ? state : command, robot ? "rt/lowstate" : "rt/lowcmd", writes);
}

void UnitreeDds::open_service() {
  const Qos qos(DDS_RELIABILITY_RELIABLE, kCallsKept);
  calls_ = reader_of(participant_, unitree_api_msg_dds__Request__desc, "rt/api/motion_switcher/request", qos, event_);
  answers_ = writer_of(participant_, unitree_api_msg_dds__Response__desc, "rt/api/motion_switcher/response", qos);
}

void UnitreeDds::quiet() noexcept {
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t got = ::read(event_, &count, sizeof count);
}

bool UnitreeDds::take(DdsSample& sample) noexcept {
  for (;;) {
    void* samples[1] = {taken_.data()};
    dds_sample_info_t info;
    const dds_return_t got = dds_take(reader_, samples, &info, 1, 1);
    if (got <= 0) return false;
    if (!info.valid_data) continue;  // a writer that left
    sample = {.bytes = std::span<const std::byte>(taken_).first(read_bytes_),
              .writer = info.publication_handle,
              .stamp_ns = info.source_timestamp};
    return true;
  }
}

bool UnitreeDds::write(std::span<const std::byte> frame) noexcept {
  if (frame.size() < write_bytes_) return false;
  std::memcpy(sent_.data(), frame.data(), write_bytes_);
  return dds_write(writer_, sent_.data()) == DDS_RETCODE_OK;
}

void UnitreeDds::serve() noexcept {
  if (calls_ == 0) return;
  for (;;) {
    void* samples[1] = {nullptr};  // lent: a call has no fixed size
    dds_sample_info_t info;
    const dds_return_t got = dds_take(calls_, samples, &info, 1, 1);
    if (got <= 0) return;
    if (info.valid_data) {
      const auto& call = *static_cast<const unitree_api_msg_dds__Request_*>(samples[0]);
      const std::string_view parameter(call.parameter != nullptr ? call.parameter : "");
      const ServiceAnswer answer = motion_service(call.header.identity.api_id, parameter.substr(0, kLongestParameter));
      if (!call.header.policy.noreply) {
        unitree_api_msg_dds__Response_ response;
        std::memset(&response, 0, sizeof response);
        response.header.identity = call.header.identity;
        response.header.status.code = answer.code;
        std::array<char, 64> data{};
        std::strncpy(data.data(), answer.data, data.size() - 1);
        response.data = data.data();
        static_cast<void>(dds_write(answers_, &response));  // the caller asks again
      }
    }
    static_cast<void>(dds_return_loan(calls_, samples, got));
  }
}

}  // namespace twinbus::bridge
