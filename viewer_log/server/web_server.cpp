#include "viewer_log/server/web_server.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

// After <utility>: asio of Boost 1.74 uses std::exchange without including it.
#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "viewer_log/server/own_address.h"
#include "viewer_log/server/stranger_seats.h"

namespace twinbus::inline viewer_log {

namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
namespace asio = boost::asio;
using asio::ip::tcp;
using Error = beast::error_code;
using Text = std::shared_ptr<const std::string>;

constexpr std::string_view kAcknowledge = "ack";
constexpr int kMostUnread = 8;
constexpr auto kHttpTimeout = std::chrono::seconds(15);
constexpr auto kStrangerTimeout = std::chrono::seconds(2);  // from elsewhere, no token yet
constexpr std::size_t kMaxHeader = 8192;                    // [bytes]
constexpr std::uint64_t kMaxFile = 64 * 1024 * 1024;        // [bytes]
constexpr std::size_t kMaxAnswers = 16;                     // waiting for one client

struct Slot {
  Text text;
  std::uint64_t number = 0;  // counts up by one per frame
};
using Slots = std::array<Slot, kWebSlots>;

class Client;

// What connections share.  Touched on the server's thread only, but for the counters.
struct Shared {
  WebConfig config;
  int port = 0;
  Slots newest;
  std::set<std::shared_ptr<Client>> clients;
  std::size_t connections = 0;               // that are no page yet
  std::unique_ptr<StrangerSeats> strangers;  // of those, from other machines and without a token
  std::atomic<std::size_t> client_count{0};
  std::atomic<long> frames_sent{0};
  std::atomic<long> refused{0};
};

// One open page.
class Client : public std::enable_shared_from_this<Client> {
 public:
  Client(Shared& shared, beast::tcp_stream&& stream, bool trusted)
      : shared_(shared), socket_(std::move(stream)), trusted_(trusted) {}

  void start(http::request<http::empty_body> request) {
    auto timeout = websocket::stream_base::timeout::suggested(beast::role_type::server);
    timeout.idle_timeout =
        std::chrono::milliseconds(static_cast<std::int64_t>(1000.0 * shared_.config.idle_timeout));
    timeout.keep_alive_pings = true;
    socket_.set_option(timeout);
    socket_.text(true);
    socket_.read_message_max(trusted_ ? shared_.config.max_trusted_message
                                      : shared_.config.max_message);
    // The request must outlive the asynchronous accept.
    auto kept = std::make_shared<http::request<http::empty_body>>(std::move(request));
    socket_.async_accept(*kept, [self = shared_from_this(), kept](Error error) {
      if (error) return;
      self->shared_.clients.insert(self);
      self->shared_.client_count = self->shared_.clients.size();
      self->read();
      self->write();
    });
  }

  // Something new may be there to send.
  void write() {
    if (writing_) return;
    writing_ = next();
    if (!writing_) return;
    socket_.async_write(asio::buffer(*writing_),
                        [self = shared_from_this()](Error error, std::size_t) {
                          self->writing_.reset();
                          if (error) return self->leave();
                          self->write();
                        });
  }

  void close() { beast::get_lowest_layer(socket_).close(); }

 private:
  // Answers first, then the slot this client has waited for longest.
  Text next() {
    if (!answers_.empty()) {
      Text answer = std::move(answers_.front());
      answers_.pop_front();
      return answer;
    }
    if (acknowledges_ && unread_ >= kMostUnread) return nullptr;
    for (std::size_t i = 0; i < kWebSlots; ++i) {
      const std::size_t slot = (last_slot_ + 1 + i) % kWebSlots;
      const Slot& newest = shared_.newest[slot];
      if (!newest.text || newest.number == sent_[slot]) continue;
      sent_[slot] = newest.number;
      last_slot_ = slot;
      ++unread_;
      ++shared_.frames_sent;
      return newest.text;
    }
    return nullptr;
  }

  void read() {
    socket_.async_read(incoming_, [self = shared_from_this()](Error error, std::size_t) {
      if (error) return self->leave();
      const std::string text = beast::buffers_to_string(self->incoming_.data());
      self->incoming_.consume(self->incoming_.size());
      if (text == kAcknowledge) {
        self->acknowledges_ = true;
        if (self->unread_ > 0) --self->unread_;
        self->write();
      } else if (self->socket_.got_text() && self->shared_.config.on_message) {
        std::string answer = self->shared_.config.on_message(text, self->trusted_);
        if (!answer.empty() && self->answers_.size() < kMaxAnswers) {
          self->answers_.push_back(std::make_shared<const std::string>(std::move(answer)));
          self->write();
        }
      }
      self->read();
    });
  }

  void leave() {
    close();  // also ends the other of read and write
    shared_.clients.erase(shared_from_this());
    shared_.client_count = shared_.clients.size();
  }

  Shared& shared_;
  websocket::stream<beast::tcp_stream> socket_;
  const bool trusted_;
  beast::flat_buffer incoming_;
  Text writing_;
  std::deque<Text> answers_;
  std::array<std::uint64_t, kWebSlots> sent_{};
  std::size_t last_slot_ = kWebSlots - 1;
  bool acknowledges_ = false;
  int unread_ = 0;  // frames sent and not acknowledged
};

// One connection until it is closed or becomes a Client.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  // own: the address it came to; far: it comes from another machine; stranger: which has shown no token yet.
  HttpConnection(Shared& shared, tcp::socket&& socket, std::string own, std::string from, bool far, bool stranger)
      : shared_(shared), stream_(std::move(socket)), own_(std::move(own)), far_(far), stranger_(stranger) {
    ++shared_.connections;
    if (stranger) place_ = shared_.strangers->take({std::move(from), [this] { close(); }}, shared_.refused);
  }
  ~HttpConnection() {
    --shared_.connections;
    no_stranger();
  }
  void close() {
    no_stranger();
    stream_.close();
  }

  void read() {
    parser_.emplace();
    parser_->header_limit(kMaxHeader);
    parser_->body_limit(0);
    stream_.expires_after(stranger_ ? kStrangerTimeout : kHttpTimeout);
    http::async_read(
        stream_, buffer_, *parser_, [self = shared_from_this()](Error error, std::size_t) {
          if (!error) {
            self->answer();
          } else if (error == http::error::header_limit || error == http::error::body_limit) {
            self->refuse(http::status::payload_too_large, "request too large\n", true);
          }
        });
  }

 private:
  using Request = http::request<http::empty_body>;

  void no_stranger() {
    if (stranger_) shared_.strangers->leave(place_);
    stranger_ = false;
  }

  static std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

  void answer() {
    const Request& request = parser_->get();
    const std::string_view host = view(request[http::field::host]);
    const std::string_view origin = view(request[http::field::origin]);
    const std::string& as = shared_.config.reached_as;
    const bool forwarded = far_ && !as.empty() && host == as && (origin.empty() || origin == "http://" + as);
    if (!forwarded && (!host_allowed(host, shared_.port, own_) || !origin_allowed(origin, shared_.port, own_))) {
      return refuse(http::status::forbidden, "foreign host or origin\n");
    }
    if (request.method() != http::verb::get && request.method() != http::verb::head) {
      return refuse(http::status::method_not_allowed, "GET only\n");
    }
    std::string path;
    if (!decode_target(view(request.target()), path)) {
      return refuse(http::status::bad_request, "bad path\n");
    }
    const std::string token = query_value(view(request.target()), "token");
    const bool trusted = same_token(token, shared_.config.token);
    const bool known = !far_ || trusted || same_token(token, shared_.config.watch_token);
    if (known) no_stranger();
    if (websocket::is_upgrade(request)) return upgrade(path, known, trusted);
    if (!known && !is_page(path)) {
      return refuse(http::status::forbidden, "from another machine only with the token\n");
    }
    const WebDocument* document = find_document(shared_.config.documents, path);
    if (document != nullptr) return send_text(http::status::ok, document->type, document->body);
    send_file(find_file(shared_.config.roots, path));
  }

  // The page itself is the same for everybody; what is of this robot lies in documents and in the
  // other roots.
  bool is_page(const std::string& path) const {
    if (const WebDocument* document = find_document(shared_.config.documents, path)) return document->of_page;
    for (const WebRoot& root : shared_.config.roots) {
      if (root.prefix != "/" && path.compare(0, root.prefix.size(), root.prefix) == 0) return false;
    }
    return true;
  }

  void upgrade(const std::string& path, bool known, bool trusted) {
    if (path != "/ws") return refuse(http::status::not_found, "not found\n");
    if (!known) return refuse(http::status::forbidden, "from another machine only with the token\n");
    // Half of the places are for this machine.
    if (shared_.clients.size() >= shared_.config.max_clients / (far_ ? 2 : 1)) {
      return refuse(http::status::service_unavailable, "too many viewers\n");
    }
    stream_.expires_never();  // the WebSocket has time-outs of its own
    std::make_shared<Client>(shared_, std::move(stream_), trusted)->start(parser_->release());
  }

  void send_file(const std::string& name) {
    if (name.empty()) return refuse(http::status::not_found, "not found\n");
    Error error;
    http::file_body::value_type file;
    file.open(name.c_str(), beast::file_mode::scan, error);
    if (error || file.size() > kMaxFile) return refuse(http::status::not_found, "not found\n");
    http::response<http::file_body> response{http::status::ok, parser_->get().version()};
    response.body() = std::move(file);
    send(std::move(response), content_type(name));
  }

  void refuse(http::status status, const char* text, bool last = false) {
    ++shared_.refused;
    send_text(status, "text/plain; charset=utf-8", text, last);
  }

  void send_text(http::status status, const std::string& type, std::string text, bool last = false) {
    http::response<http::string_body> response{status, 11};
    response.body() = std::move(text);
    send(std::move(response), type.c_str(), last);
  }

  template <class Body>
  void send(http::response<Body>&& response, const char* type, bool last = false) {
    const bool head = !last && parser_->get().method() == http::verb::head;
    response.set(http::field::content_type, type);
    response.set(http::field::cache_control, "no-cache");
    response.set("X-Content-Type-Options", "nosniff");
    response.set("X-Frame-Options", "DENY");
    response.set("Referrer-Policy", "no-referrer");
    response.set("Content-Security-Policy",
                 content_policy(own_, shared_.port, !far_, shared_.config.reached_as));
    response.keep_alive(!last && parser_->get().keep_alive());
    response.prepare_payload();
    auto kept = std::make_shared<http::response<Body>>(std::move(response));
    auto serializer = std::make_shared<http::response_serializer<Body>>(*kept);
    stream_.expires_after(stranger_ ? kStrangerTimeout : kHttpTimeout);
    const auto done = [self = shared_from_this(), kept, serializer](Error error, std::size_t) {
      if (!error && kept->keep_alive()) self->read();
    };
    if (head) {
      http::async_write_header(stream_, *serializer, done);
    } else {
      http::async_write(stream_, *serializer, done);
    }
  }

  Shared& shared_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_{16 * 1024};
  boost::optional<http::request_parser<http::empty_body>> parser_;
  const std::string own_;
  const bool far_;
  bool stranger_;
  StrangerSeats::Place place_;
};

// As it is written in an address.
std::string written(const asio::ip::address& address) {
  const std::string plain = address.to_string();
  return address.is_v6() ? "[" + plain + "]" : plain;
}

}  // namespace

struct WebServer::Impl {
  Shared shared;  // outlives the connections that io's queue still holds
  asio::io_context io{1};
  // On 127.0.0.1, and where others come; one for both when that is 0.0.0.0.
  std::array<tcp::acceptor, 2> acceptors{tcp::acceptor{io}, tcp::acceptor{io}};
  asio::ip::address others;  // unspecified unless it listens for them
  std::mutex mutex;          // guards published
  Slots published;
  std::atomic<bool> notified{false};
  std::thread thread;

  static bool open_at(tcp::acceptor& acceptor, const tcp::endpoint& endpoint, Error& error) {
    acceptor.close(error);
    acceptor.open(endpoint.protocol(), error);
    if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error && endpoint.protocol() == tcp::v6()) acceptor.set_option(asio::ip::v6_only(true), error);
    if (!error) acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    return !error;
  }

  void open() {
    const std::string& listen = shared.config.listen;
    Error error;
    asio::ip::address first = asio::ip::address_v4::loopback();
    if (!listen.empty()) {
      others = asio::ip::make_address(listen, error);
      if (error)
        throw std::runtime_error("--listen " + listen +
                                 " is no address of this machine; 0.0.0.0 is all");
      if (others == asio::ip::address_v4::any() || others.is_loopback()) first = others;
    }
    const bool both = !listen.empty() && others != first && !others.is_loopback();
    for (int i = 0; i < shared.config.ports_to_try; ++i) {
      const int wanted = shared.config.port == 0 ? 0 : shared.config.port + i;
      if (wanted < 0 || wanted > 65535) break;
      if (!open_at(acceptors[0], {first, static_cast<std::uint16_t>(wanted)}, error)) continue;
      const std::uint16_t port = acceptors[0].local_endpoint().port();
      if (both && !open_at(acceptors[1], {others, port}, error)) {
        if (error == asio::error::address_in_use) continue;
        throw std::runtime_error("--listen " + listen + ": " + error.message() +
                                 "; name an address of this machine, 0.0.0.0 is all");
      }
      shared.port = port;
      return;
    }
    throw std::runtime_error("no free port from " + std::to_string(shared.config.port) + " on (" +
                             error.message() + "); choose one with --port");
  }

  void accept(tcp::acceptor& acceptor) {
    acceptor.async_accept([this, &acceptor](Error error, tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (!error) take_in(std::move(socket));
      accept(acceptor);
    });
  }

  // A request that has come with its connection shows a token: one without takes a stranger's seat.
  bool brings_token(tcp::socket& socket) const {
    std::array<char, 512> head;
    Error error;
    socket.non_blocking(true, error);
    const std::size_t size = socket.receive(asio::buffer(head), asio::socket_base::message_peek, error);
    const std::string token = error ? "" : query_value(target_of({head.data(), size}), "token");
    return same_token(token, shared.config.token) || same_token(token, shared.config.watch_token);
  }

  void take_in(tcp::socket&& socket) {
    Error error;
    const tcp::endpoint to = socket.local_endpoint(error);
    const tcp::endpoint from = error ? tcp::endpoint() : socket.remote_endpoint(error);
    const bool far = !from.address().is_loopback();
    // Half of the places are for this machine; strangers have seats of their own.
    const std::size_t most = shared.config.max_connections / (far ? 2 : 1);
    const std::size_t known = shared.connections - shared.strangers->size() + shared.clients.size();
    if (error || known >= most) {
      ++shared.refused;  // the socket closes as it leaves
      return;
    }
    socket.set_option(tcp::no_delay(true), error);
    const bool stranger = far && !brings_token(socket);
    std::make_shared<HttpConnection>(shared, std::move(socket), written(to.address()), written(from.address()), far,
                                     stranger)->read();
  }

  void take_published() {
    notified = false;
    {
      const std::lock_guard<std::mutex> lock(mutex);
      shared.newest = published;
    }
    // Copied, because a client that fails removes itself while we walk the set.
    const auto clients = shared.clients;
    for (const auto& client : clients) client->write();
  }

  void run() {
    while (!io.stopped()) {
      try {
        io.run();
      } catch (const std::exception&) {
        ++shared.refused;  // out of memory for one connection: the others go on
      }
    }
  }
};

WebServer::WebServer(WebConfig config) : impl_(std::make_unique<Impl>()) {
  if (config.token.empty()) config.token = random_token();
  if (config.watch_token.empty()) config.watch_token = random_token();
  impl_->shared.config = std::move(config);
  impl_->shared.strangers =
      std::make_unique<StrangerSeats>(impl_->shared.config.max_connections / 4);
  impl_->open();
  for (tcp::acceptor& acceptor : impl_->acceptors) {
    if (acceptor.is_open()) impl_->accept(acceptor);
  }
  impl_->thread = std::thread([impl = impl_.get()] { impl->run(); });
}

WebServer::~WebServer() {
  asio::post(impl_->io, [impl = impl_.get()] {
    Error error;
    for (tcp::acceptor& acceptor : impl->acceptors) acceptor.close(error);
    const auto clients = impl->shared.clients;
    for (const auto& client : clients) client->close();
    impl->shared.clients.clear();
    impl->io.stop();
  });
  impl_->thread.join();
}

int WebServer::port() const { return impl_->shared.port; }
const std::string& WebServer::token() const { return impl_->shared.config.token; }

std::string WebServer::address() const {
  const std::string host = impl_->others.is_loopback() ? written(impl_->others) : "127.0.0.1";
  return "http://" + host + ":" + std::to_string(port()) + "/#token=" + token();
}

std::string WebServer::watch_address() const {
  const asio::ip::address& others = impl_->others;
  if (impl_->shared.config.listen.empty()) return {};
  const std::string host =
      others.is_unspecified() ? address_for_others(others.is_v6()) : written(others);
  const std::string& as = impl_->shared.config.reached_as;
  return "http://" + (as.empty() ? host + ":" + std::to_string(port()) : as) +
         "/#token=" + impl_->shared.config.watch_token;
}

void WebServer::publish(int slot, std::string payload) {
  auto text = std::make_shared<const std::string>(std::move(payload));
  {
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    Slot& target = impl_->published.at(static_cast<std::size_t>(slot));
    target.text.swap(text);
    ++target.number;
  }
  if (!impl_->notified.exchange(true)) {
    asio::post(impl_->io, [impl = impl_.get()] { impl->take_published(); });
  }
}

WebStats WebServer::stats() const {
  return {impl_->shared.client_count, impl_->shared.frames_sent, impl_->shared.refused};
}

}  // namespace twinbus::viewer_log
