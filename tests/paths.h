// SPDX-License-Identifier: MIT
// Paths of the project and of the programs that tests start. tests/CMakeLists.txt writes the values to a separate
// source, so that no command line of the compiler contains a path of this machine, and all clones can use the compiler
// cache.
#pragma once

namespace reorient {

extern const char* const kSourceFolder;  ///< the top of the tree

// Paths with which a test starts a program; an emulator runs programs for another type of processor.
extern const char* const kProgram;  ///< reorient
extern const char* const kGuard;    ///< reorient-nao-guard
extern const char* const kLolaTwin;
extern const char* const kRealTimeJob;  ///< nao_real_time_job
extern const char* const kTestRobot;
extern const char* const kCompanionClient;     ///< the example client in C
extern const char* const kApplicationExample;  ///< examples/application
extern const char* const kSyncShim;            ///< a library to preload
extern const char* const kDecoder;             ///< the library that decodes images of footage; empty: it was not built

}  // namespace reorient
