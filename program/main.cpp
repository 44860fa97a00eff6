#include <iostream>

#include "program/program.h"

int main(int argc, char** argv) { return reorient::run_program(argc, argv, std::cout, std::cerr); }
