// Serves the viewer's page and streams frames to it, from one thread of its own.
//
// Knows nothing of robots or the bus.  It listens on 127.0.0.1 only, unless it is told another
// address, and refuses foreign Host and Origin headers, so no page from elsewhere can reach it
// through the user's browser.  Who comes from another machine gets the page, and nothing else
// without a token: the watch token shows everything and may stop, the token acts.  Frames live
// in slots; each client gets the newest frame of every slot when it is ready for one, so that a
// stalled client misses frames and never delays anybody.  A page answers each frame with the text
// `ack` and is never more than a few frames ahead of what it has read, so what a slow one draws is
// not old; one that never answers is held back by TCP alone.

#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "viewer_log/server/web_path.h"

namespace twinbus::inline viewer_log {

inline constexpr int kWebSlots = 10;

struct WebConfig {
  int port = 8040;          // the first one tried; 0: any free one
  int ports_to_try = 20;    // when it is taken, the next ones
  std::string token;        // empty: a random one is drawn
  std::string listen;       // an address of this machine beside 127.0.0.1; 0.0.0.0: all
  std::string watch_token;  // for who comes there; empty: a random one is drawn
  // HOST:PORT that a forwarded port gives it for others, a container's; empty: its own address.
  std::string reached_as;
  std::vector<WebRoot> roots;
  std::vector<WebDocument> documents;
  std::size_t max_clients = 16;            // WebSockets
  std::size_t max_connections = 64;        // of any kind
  std::size_t max_message = 4096;          // from a page that watches [bytes]
  std::size_t max_trusted_message = 4096;  // from one that may act [bytes]
  double idle_timeout = 20.0;              // a client that neither reads nor answers is dropped [s]
  // Called on the server's thread with each text message of a page; trusted: the page brought the
  // token.  The answer, if not empty, goes back to that page only.  Must return quickly.
  std::function<std::string(const std::string& text, bool trusted)> on_message;
};

struct WebStats {
  std::size_t clients = 0;
  long frames_sent = 0;
  long refused = 0;  // foreign hosts and origins, bad paths, too many, too big
};

class WebServer {
 public:
  // Opens the port and starts the thread.  Throws std::runtime_error if no port is free.
  explicit WebServer(WebConfig config);
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  int port() const;
  const std::string& token() const;
  std::string address()
      const;  // with the token in the fragment, which browsers never send to servers
  // For another machine: watching and stopping.  Empty unless it listens there.
  std::string watch_address() const;

  // Replaces the frame of a slot, 0 <= slot < kWebSlots.  From any thread, never waits for a
  // client.
  void publish(int slot, std::string payload);

  WebStats stats() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus::viewer_log
