// SPDX-License-Identifier: MIT
// Paths of the project and of the programs that tests start. The values are in a generated source
// (tests/CMakeLists.txt) and not in command lines, so that a compiler cache works for every clone.
#pragma once

namespace reorient {

extern const char* const kSourceFolder;  ///< the top of the tree

// Paths by which a test starts a program; an emulator runs programs for another type of processor.
extern const char* const kProgram;  ///< reorient
extern const char* const kGuard;    ///< reorient-nao-guard
extern const char* const kLolaTwin;
extern const char* const kRealTimeJob;  ///< nao_real_time_job
extern const char* const kTestRobot;
extern const char* const kCompanionClient;  ///< the example client in C
extern const char* const kSyncShim;         ///< a library to preload
extern const char* const kDecoder;          ///< the library that decodes footage; empty if it was not built

}  // namespace reorient
