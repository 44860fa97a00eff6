// SPDX-License-Identifier: MIT
// The rating of a room, as text and as JSON.
#pragma once

#include <iosfwd>
#include <string>

#include "program/room/learned_room.h"
#include "workbench/rating/room_rating.h"

namespace reorient {

void print_rating(const LearnedRoom& room, const RoomRating& rating, std::ostream& out);

/// JSON with the same numbers (docs/new-halls.md), ended by a line break.
std::string rating_as_json(const LearnedRoom& room, const RoomRating& rating);

/// "works", or "does not work: " and why.
std::string verdict_in_words(const RoomRating& rating);

}  // namespace reorient
