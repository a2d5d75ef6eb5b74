// Loose bodies that lie still: nothing of them is modelled until something that moves touches them.
//
// A heap is what hangs together by touch.  It falls asleep as a whole (sim/objects/rigid_objects.h says when) and keeps what its
// contacts remember; it wakes as a whole, in the search in which something comes so near to one of its bodies that it would
// touch it at the end of the step, and then rests on the same springs as before.

#include <algorithm>
#include <utility>

#include "sim/contact/bristle.h"
#include "sim/objects/rigid_object_contacts.h"

namespace twinbus::inline sim {

void LooseContacts::fall_asleep(const std::vector<int>& heap, const std::vector<ArticulatedBody*>& systems,
                                const std::vector<Contact>& contacts, double h) noexcept {
  for (std::size_t i = 0; i < loose_; ++i) {
    if (heap[at(pieces_[i].system)] > 0) place(i, i + 1, systems);
  }
  for (std::size_t s = 0; s < heap.size(); ++s) {
    if (heap[s] > 0) heap_[s] = heap[s];
    sleepers_ = sleepers_ || heap[s] > 0;
  }
  for (const Contact& c : contacts) {
    const bool sleeps = heap[at(c.system)] > 0 || (c.other_system >= 0 && heap[at(c.other_system)] > 0);
    const int place = sleeps ? remembered_.find(c.key) : -1;
    if (place < 0 || slept_.size() == slept_.capacity()) continue;
    const int system = heap[at(c.system)] > 0 ? c.system : c.other_system;
    slept_.push_back({memory_[at(place)], system, stored_energy(c, h)});
  }
}

double LooseContacts::asleep_energy() const noexcept {
  double energy = 0.0;
  for (const Slept& slept : slept_) energy += slept.energy;
  return energy;
}

void LooseContacts::wake(int heap) noexcept {
  const auto of_heap = [&](const Slept& slept) { return heap_[at(slept.system)] == heap; };
  for (const Slept& slept : slept_) {
    if (!of_heap(slept) || memory_.size() == memory_.capacity()) continue;
    memory_.push_back(slept.memory);
    if (saved_.size() < saved_.capacity()) saved_.push_back(slept.memory);
  }
  slept_.erase(std::remove_if(slept_.begin(), slept_.end(), of_heap), slept_.end());
  for (std::size_t s = 0; s < heap_.size(); ++s) {
    if (heap_[s] != heap) continue;
    heap_[s] = 0;
    woke_[s] = 1;
  }
  sleepers_ = std::any_of(heap_.begin(), heap_.end(), [](int each) { return each > 0; });
  index_memory();
}

void LooseContacts::index_memory() noexcept {
  remembered_.clear();
  for (std::size_t i = 0; i < memory_.size(); ++i) remembered_.add(memory_[i].key, static_cast<int>(i));
}

void LooseContacts::forget() noexcept {
  memory_.clear();
  remembered_.clear();
  faces_.forget();
  slept_.clear();
  std::fill(heap_.begin(), heap_.end(), 0);
  sleepers_ = false;
}

bool LooseContacts::wake_touched(std::size_t first, Search& search) noexcept {
  const auto with_sleeper = [this](const Contact& c) { return asleep(c.system) || asleep(c.other_system); };
  bool woke = false;
  for (std::size_t i = first; i < search.contacts.size(); ++i) {
    const Contact& c = search.contacts[i];
    if (!with_sleeper(c) || !(c.depth - search.h * c.normal.dot(c.v0) > 0.0)) continue;
    wake(heap_[at(asleep(c.system) ? c.system : c.other_system)]);
    woke = true;
  }
  const auto begin = search.contacts.begin() + static_cast<std::ptrdiff_t>(first);
  if (!woke) search.contacts.erase(std::remove_if(begin, search.contacts.end(), with_sleeper), search.contacts.end());
  return woke;
}

void LooseContacts::find(const std::vector<ArticulatedBody*>& systems, double h, std::vector<Contact>& contacts,
                         bool away) noexcept {
  const bool placed = std::exchange(placed_, false);
  if (!away) place_all(systems);
  for (std::size_t i = 0; away && !placed && i < loose_; ++i) {
    if (!asleep(pieces_[i].system)) place(i, i + 1, systems);
  }
  Search search{systems, h, contacts};
  const std::size_t first = contacts.size();
  find_once(search, away);
  while (sleepers_ && wake_touched(first, search)) {
    contacts.erase(contacts.begin() + static_cast<std::ptrdiff_t>(first), contacts.end());
    find_once(search, away);
  }
}

}  // namespace twinbus::sim
