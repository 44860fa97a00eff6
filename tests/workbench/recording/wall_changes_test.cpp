// SPDX-License-Identifier: MIT
// The wall is sent again when its colors have changed visibly.
#include "workbench/views/viewer/wall_changes.h"

#include <gtest/gtest.h>

namespace reorient {
namespace {

RoomRecord learned_room() {
  RoomRecord room;
  room.basis.wall.rows = 1;
  room.basis.wall.columns = 4;
  room.model.resize(4);
  for (TileModel& tile : room.model) tile.light_visits = 1;
  return room;
}

TEST(WallChanges, AreTheFirstWallAndEachBegin) {
  WallChanges changes;
  const RoomRecord room = learned_room();
  EXPECT_TRUE(changes.take(room, false));
  EXPECT_FALSE(changes.take(room, false));
  EXPECT_TRUE(changes.take(room, true));
}

TEST(WallChanges, AreTilesThatWereLearnedAndOtherWalls) {
  WallChanges changes;
  RoomRecord room = learned_room();
  room.model[2].light_visits = 0;
  changes.take(room, true);
  room.model[2].light_visits = 1;
  EXPECT_TRUE(changes.take(room, false));
  room.model.resize(3);
  EXPECT_TRUE(changes.take(room, false));
  EXPECT_TRUE(changes.take(RoomRecord(), false)) << "no wall";
  EXPECT_FALSE(changes.take(RoomRecord(), false));
}

TEST(WallChanges, AddUpUntilTheyAreVisible) {
  WallChanges changes;
  RoomRecord room = learned_room();
  changes.take(room, true);
  int frames = 1;
  for (; frames < 100; ++frames) {
    room.model[1].light.luma += 0.01;
    if (changes.take(room, false)) break;
  }
  EXPECT_GT(frames, 2);
  EXPECT_LT(frames, 100);
  EXPECT_FALSE(changes.take(room, false));
}

}  // namespace
}  // namespace reorient
