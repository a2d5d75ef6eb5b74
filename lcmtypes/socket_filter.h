// Closes LCM's receiving socket to split datagrams and to foreign senders, in the kernel and
// without root.
//
// liblcm binds every address and trusts what arrives; ttl=0 limits only what we send.  One pair of
// forged fragments ends the process inside liblcm, before any handler could refuse it
// (facts/reliability.md section 3).

#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace twinbus {

// IPv4 address "10.0.0.2" as a number in host byte order.  Throws std::invalid_argument naming the
// text.
std::uint32_t parse_ipv4(const std::string& text);

// The open UDP sockets of this process bound to port.
std::set<int> udp_sockets(int port);

// Lets in unsplit LCM datagrams ("LC02") that this machine sent itself (looped back multicast or
// the loopback interface, whatever address they carry) or that come from one of allowed. Everything
// else is dropped and counted by the kernel.  Returns false if the kernel refuses.
bool attach_filter(int socket, const std::vector<std::uint32_t>& allowed);

// Datagrams the kernel dropped for this socket: by the filter, or because its buffer was full.  -1
// if unknown.
std::int64_t dropped_datagrams(int socket);

// Asks for a receive buffer of this size; root may go beyond net.core.rmem_max.  Returns what it is
// now [bytes].
int enlarge_receive_buffer(int socket, int bytes);

}  // namespace twinbus
