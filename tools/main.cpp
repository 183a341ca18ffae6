#include "tools/specula/command_line.hpp"

int main(int argc, char** argv) { return specula::run_program(argc, argv); }
