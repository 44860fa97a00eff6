// SPDX-License-Identifier: MIT
#include <clocale>
#include <csignal>
#include <iostream>

#include "program/program.h"

int main(int argc, char** argv) {
  // Whoever reads our output may go away (as head does), a file may grow beyond what is allowed: errors to be told,
  // with which nothing else that a run writes must be lost.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // libedit converts letters by the locale. Before there are threads; numbers stay as they are.
  std::setlocale(LC_CTYPE, "C.UTF-8");
  return reorient::run_program(argc, argv, std::cout, std::cerr);
}
