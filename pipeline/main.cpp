#include "pipeline/cli/program.hpp"

int main(int argc, char** argv) { return ashimpact::run_program(argc, argv); }
