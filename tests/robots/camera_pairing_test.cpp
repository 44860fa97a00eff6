// SPDX-License-Identifier: MIT
#include "robots/camera_pairing.h"

#include <gtest/gtest.h>

namespace reorient {
namespace {

CameraFrame at(double time) {
  CameraFrame frame;
  frame.time = time;
  return frame;
}

TEST(CameraPairing, IsDueWithAnUpperImageAndIncludesTheNewestLowerImage) {
  CameraPairing pairing;
  pairing.put_lower(at(0.970), 0.975);
  pairing.put_lower(at(0.990), 0.995);
  EXPECT_FALSE(pairing.is_due(1.0));
  pairing.put_upper(at(1.000));
  ASSERT_TRUE(pairing.is_due(1.0));
  Observation observation;
  pairing.take(observation);
  EXPECT_EQ(observation.time, 1.000);
  EXPECT_EQ(observation.upper->time, 1.000);
  EXPECT_EQ(observation.lower->time, 0.990);
  EXPECT_FALSE(pairing.is_due(2.0)) << "each image is used in one frame";
}

TEST(CameraPairing, UsesTheTimeOfALowerImageThatIsNewerThanTheUpperOne) {
  CameraPairing pairing;
  pairing.put_upper(at(1.000));
  pairing.put_lower(at(1.010), 1.015);
  Observation observation;
  pairing.take(observation);
  EXPECT_EQ(observation.time, 1.010);
}

TEST(CameraPairing, DeliversALowerImageAloneAfterAWait) {
  CameraPairing pairing;
  pairing.put_lower(at(1.000), 1.045);
  EXPECT_FALSE(pairing.is_due(1.090)) << "the wait counts from the arrival, not from the exposure";
  pairing.drop_lower();
  EXPECT_FALSE(pairing.is_due(1.096)) << "no image waits";
  pairing.put_lower(at(1.033), 1.078);
  EXPECT_TRUE(pairing.is_due(1.096)) << "the wait counts from the first image, or a fast camera would wait for ever";
  Observation observation;
  pairing.take(observation);
  EXPECT_FALSE(observation.upper);
  EXPECT_EQ(observation.time, 1.033);
}

TEST(CameraPairing, WithoutPatienceDeliversEachImageAtOnce) {
  CameraPairing pairing(0.0);
  EXPECT_FALSE(pairing.is_due(1.0));
  pairing.put_lower(at(1.0), 1.0);
  EXPECT_TRUE(pairing.is_due(1.0));
}

}  // namespace
}  // namespace reorient
