// Carries datagrams between two LCM ports and, with a seed, loses, doubles, delays and reorders
// them.
//
//   relay --left PORT --right PORT [--right-netns PID] [--loss P] [--double P] [--delay MS]
//   [--jitter MS]
//         [--reorder P] [--seed N] [--arm CHANNEL] [--rule
//         CHANNEL:N:ACTION[:from-left|:from-right]]...
//
// P are shares 0..1.  ACTION is drop, double or delay=MS; N counts the messages of that channel
// from 1, or is * for all of them.  With --arm the counting starts behind the first message on that
// channel, so that "the third STATE after the request" is STATE:3.  Standard input takes, line by
// line: `rule ...`, `clear` (rules and counts), `arm CHANNEL`, `loss P`, `delay MS`, `stats` (one
// line of JSON).  At the end of input it goes on; a signal ends it.

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <queue>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr char kGroup[] = "239.255.76.67";
constexpr std::size_t kLargest = 65536;

volatile sig_atomic_t g_quit = 0;
void on_signal(int) { g_quit = 1; }

std::int64_t now_ns() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return std::int64_t{1'000'000'000} * t.tv_sec + t.tv_nsec;
}

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

// One port: what is received from others, what is sent to them.
struct Side {
  int receiver = -1;
  int sender = -1;
  sockaddr_in group{};
  std::uint16_t own_port = 0;  // of what we sent ourselves, network order

  void open(int port) {
    group.sin_family = AF_INET;
    group.sin_port = htons(static_cast<std::uint16_t>(port));
    inet_pton(AF_INET, kGroup, &group.sin_addr);
    receiver = socket(AF_INET, SOCK_DGRAM, 0);
    const int one = 1, buffer = 4194304;
    setsockopt(receiver, SOL_SOCKET, SO_REUSEADDR, &one, sizeof one);
    setsockopt(receiver, SOL_SOCKET, SO_RCVBUFFORCE, &buffer, sizeof buffer);
    sockaddr_in any{};
    any.sin_family = AF_INET;
    any.sin_port = group.sin_port;
    ip_mreq membership{group.sin_addr, {INADDR_ANY}};
    if (bind(receiver, reinterpret_cast<sockaddr*>(&any), sizeof any) != 0) fail("bind");
    if (setsockopt(receiver, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) != 0) {
      fail("join " + std::string(kGroup));
    }
    sender = socket(AF_INET, SOCK_DGRAM, 0);
    const unsigned char ttl = 0;
    setsockopt(sender, IPPROTO_IP, IP_MULTICAST_TTL, &ttl, sizeof ttl);
    any.sin_port = 0;
    if (bind(sender, reinterpret_cast<sockaddr*>(&any), sizeof any) != 0) fail("bind");
    socklen_t size = sizeof any;
    getsockname(sender, reinterpret_cast<sockaddr*>(&any), &size);
    own_port = any.sin_port;
  }
};

struct Rule {
  std::string channel;
  long number = 0;  // 0: all
  enum { kDrop, kDouble, kDelay } action = kDrop;
  double delay = 0;  // [s]
  int from = -1;     // side, -1 either
};

Rule parse_rule(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  const std::runtime_error bad("rule " + text + ": write CHANNEL:N:drop, :double or :delay=MS");
  if (parts.size() < 3 || parts.size() > 4) throw bad;
  Rule rule;
  rule.channel = parts[0];
  rule.number = parts[1] == "*" ? 0 : std::atol(parts[1].c_str());
  if (parts[1] != "*" && rule.number < 1) throw bad;
  if (parts[2] == "drop")
    rule.action = Rule::kDrop;
  else if (parts[2] == "double")
    rule.action = Rule::kDouble;
  else if (parts[2].rfind("delay=", 0) == 0) {
    rule.action = Rule::kDelay;
    rule.delay = 1e-3 * std::atof(parts[2].c_str() + 6);
  } else {
    throw bad;
  }
  if (parts.size() == 4) {
    if (parts[3] != "from-left" && parts[3] != "from-right") throw bad;
    rule.from = parts[3] == "from-left" ? 0 : 1;
  }
  return rule;
}

struct Waiting {
  std::int64_t due_ns;
  std::uint64_t order;
  int to;
  std::vector<std::uint8_t> bytes;
  bool operator>(const Waiting& other) const {
    return due_ns != other.due_ns ? due_ns > other.due_ns : order > other.order;
  }
};

struct Relay {
  std::array<Side, 2> sides;
  double loss = 0, twice = 0, delay = 0, jitter = 0, reorder = 0;  // [-], [-], [s], [s], [-]
  std::string arm;  // channel that starts the counting; empty: armed
  bool armed = true;
  std::vector<Rule> rules;
  std::map<std::string, std::array<long, 2>> counts;
  std::mt19937_64 random{1};
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting;
  std::uint64_t order = 0;
  long carried = 0, lost = 0, doubled = 0, delayed = 0, matched = 0;

  bool chance(double p) { return p > 0 && std::uniform_real_distribution<>(0, 1)(random) < p; }

  void put(int to, const std::uint8_t* data, std::size_t size, double after_s) {
    if (after_s <= 0) {
      send_now(to, data, size);
      return;
    }
    ++delayed;
    waiting.push(
        {now_ns() + static_cast<std::int64_t>(1e9 * after_s), order++, to, {data, data + size}});
  }
  void send_now(int to, const std::uint8_t* data, std::size_t size) {
    Side& side = sides[static_cast<std::size_t>(to)];
    sendto(side.sender, data, size, 0, reinterpret_cast<sockaddr*>(&side.group), sizeof side.group);
    ++carried;
  }
  void flush() {
    while (!waiting.empty() && waiting.top().due_ns <= now_ns()) {
      send_now(waiting.top().to, waiting.top().bytes.data(), waiting.top().bytes.size());
      waiting.pop();
    }
  }

  void carry(int from, const std::uint8_t* data, std::size_t size) {
    std::string channel;
    if (size > 9 && std::memcmp(data, "LC02", 4) == 0) {
      const auto* name = reinterpret_cast<const char*>(data + 8);
      channel.assign(name, strnlen(name, size - 8));
    }
    double after =
        delay > 0 || jitter > 0
            ? std::max(0.0, delay + jitter * std::uniform_real_distribution<>(-1, 1)(random))
            : 0.0;
    if (chance(reorder)) after += 0.003;
    int copies = chance(loss) ? 0 : chance(twice) ? 2 : 1;
    if (armed) {
      auto& count = counts[channel];
      ++count[static_cast<std::size_t>(from)];
      for (const Rule& rule : rules) {
        if (rule.channel != channel || (rule.from >= 0 && rule.from != from)) continue;
        const long number =
            rule.from >= 0 ? count[static_cast<std::size_t>(from)] : count[0] + count[1];
        if (rule.number != 0 && rule.number != number) continue;
        ++matched;
        if (rule.action == Rule::kDrop) copies = 0;
        if (rule.action == Rule::kDouble) copies = 2;
        if (rule.action == Rule::kDelay) after += rule.delay;
      }
    } else if (channel == arm) {
      armed = true;
    }
    lost += copies == 0;
    doubled += copies == 2;
    for (int i = 0; i < copies; ++i) put(1 - from, data, size, after);
  }

  void command(const std::string& line) {
    const std::size_t space = line.find(' ');
    const std::string word = line.substr(0, space);
    const std::string rest = space == std::string::npos ? "" : line.substr(space + 1);
    if (word == "rule")
      rules.push_back(parse_rule(rest));
    else if (word == "clear")
      rules.clear(), counts.clear(), matched = 0, armed = true;
    else if (word == "arm")
      arm = rest, armed = rest.empty(), counts.clear();
    else if (word == "loss")
      loss = std::atof(rest.c_str());
    else if (word == "delay")
      delay = 1e-3 * std::atof(rest.c_str());
    else if (word == "stats")
      print_stats();
    else if (!word.empty())
      throw std::runtime_error("unknown command " + word);
  }
  void print_stats() {
    std::printf(
        "{\"carried\": %ld, \"lost\": %ld, \"doubled\": %ld, \"delayed\": %ld, \"matched\": %ld}\n",
        carried, lost, doubled, delayed, matched);
    std::fflush(stdout);
  }

  void run() {
    std::array<pollfd, 3> ready{
        {{sides[0].receiver, POLLIN, 0}, {sides[1].receiver, POLLIN, 0}, {0, POLLIN, 0}}};
    std::vector<std::uint8_t> buffer(kLargest);
    std::string input;
    while (!g_quit) {
      timespec wait{1, 0};
      if (!waiting.empty()) {
        const std::int64_t left = std::max<std::int64_t>(0, waiting.top().due_ns - now_ns());
        wait = {left / 1'000'000'000, left % 1'000'000'000};
      }
      if (ppoll(ready.data(), ready.size(), &wait, nullptr) > 0) {
        for (int from = 0; from < 2; ++from) {
          if ((ready[static_cast<std::size_t>(from)].revents & POLLIN) == 0) continue;
          sockaddr_in sender{};
          socklen_t sender_size = sizeof sender;
          const Side& side = sides[static_cast<std::size_t>(from)];
          const ssize_t size = recvfrom(side.receiver, buffer.data(), buffer.size(), MSG_DONTWAIT,
                                        reinterpret_cast<sockaddr*>(&sender), &sender_size);
          if (size <= 0 || sender.sin_port == side.own_port) continue;
          carry(from, buffer.data(), static_cast<std::size_t>(size));
        }
        if ((ready[2].revents & (POLLIN | POLLHUP)) != 0) {
          char piece[512];
          const ssize_t size = read(0, piece, sizeof piece);
          if (size <= 0)
            ready[2].fd = -1;
          else
            input.append(piece, static_cast<std::size_t>(size));
          for (std::size_t end; (end = input.find('\n')) != std::string::npos;
               input.erase(0, end + 1)) {
            command(input.substr(0, end));
          }
        }
      }
      flush();
    }
  }
};

// Opens the side in the network namespace of another process.
void open_in_namespace(Side& side, int port, int pid) {
  const int here = open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC);
  const int there =
      open(("/proc/" + std::to_string(pid) + "/ns/net").c_str(), O_RDONLY | O_CLOEXEC);
  if (here < 0 || there < 0 || setns(there, CLONE_NEWNET) != 0)
    fail("--right-netns " + std::to_string(pid));
  side.open(port);
  if (setns(here, CLONE_NEWNET) != 0) fail("back from --right-netns");
  close(here);
  close(there);
}

}  // namespace

int main(int argc, char** argv) try {
  Relay relay;
  int left = 0, right = 0, netns = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (i + 1 >= argc) throw std::invalid_argument(name + ": unknown, or needs a value");
    const std::string value = argv[++i];
    if (name == "--left")
      left = std::stoi(value);
    else if (name == "--right")
      right = std::stoi(value);
    else if (name == "--right-netns")
      netns = std::stoi(value);
    else if (name == "--loss")
      relay.loss = std::stod(value);
    else if (name == "--double")
      relay.twice = std::stod(value);
    else if (name == "--delay")
      relay.delay = 1e-3 * std::stod(value);
    else if (name == "--jitter")
      relay.jitter = 1e-3 * std::stod(value);
    else if (name == "--reorder")
      relay.reorder = std::stod(value);
    else if (name == "--seed")
      relay.random.seed(std::stoull(value));
    else if (name == "--rule")
      relay.rules.push_back(parse_rule(value));
    else if (name == "--arm")
      relay.command("arm " + value);
    else
      throw std::invalid_argument(name + ": unknown");
  }
  if (left <= 0 || right <= 0 || (left == right && netns == 0)) {
    throw std::invalid_argument("--left PORT and --right PORT are needed and differ");
  }
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  relay.sides[0].open(left);
  if (netns != 0)
    open_in_namespace(relay.sides[1], right, netns);
  else
    relay.sides[1].open(right);
  std::printf("ready\n");
  std::fflush(stdout);
  relay.run();
  relay.print_stats();
  return 0;
} catch (const std::invalid_argument& error) {
  std::fprintf(stderr, "relay: %s\n", error.what());
  return 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "relay: %s\n", error.what());
  return 1;
}
