#include "viewer_log/server/stranger_seats.h"

#include <gtest/gtest.h>

#include <vector>

namespace twinbus {
namespace {

TEST(StrangerSeats, WhoOpensManyConnectionsLosesHisOwn) {
  StrangerSeats seats(4);
  std::vector<int> closed;
  std::vector<StrangerSeats::Place> places(20);
  int crowds = 0;
  const auto take = [&](int id, const char* address) {
    places[static_cast<std::size_t>(id)] =
        seats.take({address,
                    [&, id] {
                      closed.push_back(id);
                      seats.leave(places[static_cast<std::size_t>(id)]);
                    }},
                   crowds);
  };
  take(0, "phone");
  for (int id = 1; id < 10; ++id) take(id, "many");
  EXPECT_EQ(seats.size(), 4U);
  EXPECT_EQ(closed, (std::vector<int>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(crowds, 6);
}

}  // namespace
}  // namespace twinbus
