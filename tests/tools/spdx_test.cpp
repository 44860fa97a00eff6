// SPDX-License-Identifier: MIT
// tools/spdx on a small tree.
#include <string>

#include <gtest/gtest.h>

#include "tests/tools/tool_tree.h"

namespace reorient {
namespace {

class Spdx : public testing::Test {
 protected:
  Spdx() {
    tree.copy("tools/spdx");
    write("LICENSE", "MIT License\n");
    write("CITATION.cff", "title: a\nlicense: MIT\n");
    tree.run("tools/spdx --add");  // to the tool itself
  }

  void write(const std::string& file, const std::string& text) { tree.folder.write(file, text); }

  std::string run(const std::string& line) {
    const ToolTree::Result result = tree.run(line);
    return result.text + "exit " + std::to_string(result.code);
  }

  ToolTree tree;
};

TEST_F(Spdx, ReportsSourcesWithoutTheLineAndAddsIt) {
  write("part/a.h", "#pragma once\n");
  write("part/CMakeLists.txt", "add_library(a a.cpp)\n");
  write("scripts/a.lua", "--- A library.\n--- Of two lines.\nreturn {}\n");
  write("tools/b", "#!/bin/sh\n# b: does nothing.\n");
  write("page.md", "no source\n");
  write("tests/fuzz/seeds/script/a.lua", "return 1\n");
  EXPECT_EQ(run("tools/spdx"),
            "part/CMakeLists.txt: no SPDX line; run: tools/spdx --add\npart/a.h: no SPDX line; run: tools/spdx --add\n"
            "scripts/a.lua: no SPDX line; run: tools/spdx --add\ntools/b: no SPDX line; run: tools/spdx --add\nexit 1");
  EXPECT_EQ(run("tools/spdx --add && tools/spdx && tools/spdx --add"), "exit 0");
  EXPECT_EQ(run("cat part/a.h"), "// SPDX-License-Identifier: MIT\n#pragma once\nexit 0");
  EXPECT_EQ(run("cat part/CMakeLists.txt"), "# SPDX-License-Identifier: MIT\nadd_library(a a.cpp)\nexit 0");
  EXPECT_EQ(run("cat scripts/a.lua"),
            "--- A library.\n--- Of two lines.\n\n-- SPDX-License-Identifier: MIT\nreturn {}\nexit 0");
  EXPECT_EQ(run("cat tools/b"), "#!/bin/sh\n# SPDX-License-Identifier: MIT\n# b: does nothing.\nexit 0");
}

TEST_F(Spdx, ReportsAnotherLicense) {
  write("a.h", "// SPDX-License-Identifier: GPL-3.0-only\n");
  write("CITATION.cff", "license: Apache-2.0\n");
  EXPECT_EQ(run("tools/spdx"),
            "CITATION.cff: no line 'license: MIT', which is the license of LICENSE\n"
            "a.h: license GPL-3.0-only (expected MIT, as in LICENSE)\nexit 1");
}

TEST_F(Spdx, RejectsAnUnknownLicense) {
  write("LICENSE", "A license\n");
  EXPECT_EQ(run("tools/spdx"), "tools/spdx: LICENSE: unknown license 'A license' (expected MIT License)\nexit 2");
}

}  // namespace
}  // namespace reorient
