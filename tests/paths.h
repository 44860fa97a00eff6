// SPDX-License-Identifier: MIT
// Where the tests find the project and the programs that they start. The values are in a source of their own, written
// by tests/CMakeLists.txt: no path of one machine stands in a command line, so that a compiler cache serves every
// clone.
#pragma once

namespace reorient {

extern const char* const kSourceFolder;  ///< the top of the tree

// Paths by which a test starts a program; an emulator runs those for another kind of processor.
extern const char* const kProgram;  ///< reorient
extern const char* const kGuard;    ///< reorient-nao-guard
extern const char* const kLolaTwin;
extern const char* const kRealTimeJob;  ///< nao_real_time_job
extern const char* const kTestRobot;
extern const char* const kCompanionClient;  ///< the example client in C
extern const char* const kSyncShim;         ///< a library to preload
extern const char* const kDecoder;          ///< the library that decodes images of others; empty: it was not built

}  // namespace reorient
