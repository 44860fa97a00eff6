// SPDX-License-Identifier: MIT
// Tests in which the program decodes images of other programs.
#pragma once

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "tests/paths.h"
#include "tests/shared_data.h"

namespace reorient {

/// For SetUp(): skips the test where the decoder was not built, else names it to the program.
inline void need_decoder() {
  if (*kDecoder == '\0') GTEST_SKIP() << "built without OpenCV's imgcodecs and videoio (tools/packages-footage)";
  setenv("REORIENT_DECODER", kDecoder, 1);
}

/// Images of the shared data that the program decodes.
class DecodedSharedDataTest : public SharedDataTest {
 protected:
  using SharedDataTest::SharedDataTest;
  void SetUp() override {
    SharedDataTest::SetUp();
    if (!IsSkipped()) need_decoder();
  }
};

}  // namespace reorient
