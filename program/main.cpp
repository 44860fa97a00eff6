// SPDX-License-Identifier: MIT
#include <clocale>
#include <csignal>
#include <iostream>

#include "program/program.h"

int main(int argc, char** argv) {
  // A reader of the output may end early (as head does), and a file may exceed its size limit. The other outputs of a
  // run must not be lost, so the program continues: see run_program().
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // libedit converts characters by the locale. Set it before any thread starts; the format of numbers is unchanged.
  std::setlocale(LC_CTYPE, "C.UTF-8");
  return reorient::run_program(argc, argv, std::cout, std::cerr);
}
