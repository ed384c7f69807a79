#include "program.hpp"

int main(int argc, char** argv) { return rotconv::cli::run_program(argc, argv); }
