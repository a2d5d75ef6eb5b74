// Closes a receiving socket to split datagrams, to foreign senders and to channels nobody here
// listens to, in the kernel and without root.
//
// On a multicast bus every datagram of every channel wakes every process; the channel filter lets
// each sleep through what is not for it.
//
// ttl=0 limits only what we send, and our own messages are never split: who puts split ones together
// can be made to run out of memory, or out of bounds, by two forged datagrams.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace twinbus::inline lcmtypes {

// IPv4 address "10.0.0.2" as a number in host byte order.  Throws std::invalid_argument naming the
// text.
std::uint32_t parse_ipv4(const std::string& text);

// Lets in unsplit LCM datagrams ("LC02") that this machine sent itself (looped back multicast or
// the loopback interface, whatever address they carry) or that come from one of allowed, and of
// these all, or only the channels named.  Everything else is dropped and counted by the kernel.
// Takes the place of an earlier filter.  Returns false if the kernel refuses.
bool attach_filter(int socket, const std::vector<std::uint32_t>& allowed);
bool attach_filter(int socket, const std::vector<std::uint32_t>& allowed,
                   const std::vector<std::string>& channels);

// Datagrams the kernel dropped for this socket: by the filter, or because its buffer was full.  -1
// if unknown.
std::int64_t dropped_datagrams(int socket);

// Asks for a receive buffer of this size; root may go beyond net.core.rmem_max.  Returns what it is
// now [bytes].
int enlarge_receive_buffer(int socket, int bytes);

}  // namespace twinbus::lcmtypes
