#include "launcher/stack/children.h"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace twinbus::inline launcher {

namespace {

constexpr long kTailBytes = 16384;

// In the child, between fork and exec: only calls that are safe after fork.
[[noreturn]] void become(const ChildSpec& spec, char* const* arguments, pid_t parent,
                         int error_fd) {
  setpgid(0, 0);
  const sched_param ordinary{};  // each program asks for the priority that it needs
  sched_setscheduler(0, SCHED_OTHER, &ordinary);
  // SIGKILL: a child may ignore SIGTERM, outlive us and keep the terminal.  A bridge to real motors is spared: its
  // robot must come to rest by the command timeout, not by losing its last master.
  if (spec.dies_with_launcher) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(127);  // the parent died before prctl took effect
  }
  const int input = open("/dev/null", O_RDONLY);
  const int output = open(spec.log_file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  if (input >= 0) dup2(input, STDIN_FILENO);
  if (output >= 0) {
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  signal(SIGINT, SIG_DFL);
  signal(SIGTERM, SIG_DFL);
  signal(SIGPIPE, SIG_DFL);
  execv(arguments[0], arguments);
  const int error = errno;
  [[maybe_unused]] const ssize_t written = write(error_fd, &error, sizeof error);
  _exit(127);
}

std::string words(const siginfo_t& info) {
  if (info.si_code == CLD_EXITED) return "exit status " + std::to_string(info.si_status);
  return "signal " + std::to_string(info.si_status) + " (" + strsignal(info.si_status) + ")";
}

}  // namespace

Child::Child(const ChildSpec& spec) : spec_(spec) {
  std::vector<char*> arguments;
  for (std::string& word : spec_.command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  if (spec_.command.empty()) throw std::runtime_error(spec_.name + ": no program to start");

  // The pipe closes by itself when exec succeeds; otherwise it brings errno.
  int pipe_fds[2];
  if (pipe2(pipe_fds, O_CLOEXEC) != 0)
    throw std::runtime_error(spec_.name + ": no more file descriptors");
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) become(spec_, arguments.data(), parent, pipe_fds[1]);
  const int fork_error = errno;
  close(pipe_fds[1]);
  if (pid_ < 0) {
    close(pipe_fds[0]);
    throw std::runtime_error(spec_.name + ": cannot start a process: " + std::strerror(fork_error));
  }
  setpgid(pid_, pid_);  // in both processes, so that kill(-pid) never races with the child
  int error = 0;
  const bool failed = read(pipe_fds[0], &error, sizeof error) == static_cast<ssize_t>(sizeof error);
  close(pipe_fds[0]);
  if (failed) {
    waitpid(pid_, nullptr, 0);
    throw std::runtime_error(spec_.name + ": cannot run " + spec_.command[0] + ": " +
                             std::strerror(error));
  }
  pidfd_ = static_cast<int>(syscall(SYS_pidfd_open, pid_, 0));
  if (pidfd_ < 0) {
    kill(-pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    throw std::runtime_error(spec_.name + ": this kernel has no pidfd_open (needs Linux 5.3)");
  }
  fcntl(pidfd_, F_SETFD, FD_CLOEXEC);
}

Child::Child(Child&& other) noexcept
    : spec_(std::move(other.spec_)),
      pid_(std::exchange(other.pid_, -1)),
      pidfd_(std::exchange(other.pidfd_, -1)),
      well_(other.well_),
      how_(std::move(other.how_)) {}

Child::~Child() {
  if (!running()) return;
  ask_to_stop();
  if (!wait_for_end(spec_.grace)) kill_group();
}

bool Child::take_end() { return running() && wait_for_end(0.0); }

bool Child::wait_is_over() const {
  pollfd event{pidfd_, POLLIN, 0};
  return running() && poll(&event, 1, 0) == 1;
}

void Child::ask_to_stop() const {
  if (running()) kill(-pid_, SIGTERM);
}

bool Child::wait_for_end(double seconds) {
  if (!running()) return true;
  pollfd event{pidfd_, POLLIN, 0};
  while (poll(&event, 1, static_cast<int>(seconds * 1e3)) < 0 && errno == EINTR) {
  }
  if ((event.revents & POLLIN) == 0) return false;
  reap();
  return true;
}

void Child::kill_group() {
  if (!running()) return;
  kill(-pid_, SIGKILL);
  if (!wait_for_end(5.0)) {  // stuck in the kernel: nobody can end it
    close(std::exchange(pidfd_, -1));
    how_ = "does not end";
  }
}

void Child::reap() {
  kill(-pid_,
       SIGKILL);  // whatever it left behind in its group; the zombie still keeps the number ours
  siginfo_t info{};
  waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED);
  well_ = info.si_code == CLD_EXITED && info.si_status == 0;
  how_ = words(info);
  close(std::exchange(pidfd_, -1));
}

std::vector<std::string> Child::last_lines(int count) const {
  return tail_of(spec_.log_file, count);
}

std::vector<std::string> tail_of(const std::string& file, int count) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return {};
  const long size = static_cast<long>(stream.tellg());
  stream.seekg(std::max(0L, size - kTailBytes));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) lines.push_back(line);
  }
  const long surplus = static_cast<long>(lines.size()) - count;
  if (surplus > 0) lines.erase(lines.begin(), lines.begin() + surplus);
  return lines;
}

}  // namespace twinbus::launcher
