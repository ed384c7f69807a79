#pragma once

#include <cstdio>
#include <exception>
#include <fstream>
#include <sstream>

/// The main function of a measurement, which is called as `PROGRAM OUT.csv`: `measure(stream)` writes the figures.
/// Those of an earlier run stay until there are others.
template <class Measure> int write_figures(int argc, char** argv, const Measure& measure) {
    if (argc != 2 || argv[1][0] == '-') {
        std::fprintf(stderr, "usage: %s OUT.csv\n", argv[0]);
        return 2;
    }
    std::ostringstream figures;
    try {
        if (std::ofstream(argv[1], std::ios::app)) { // else there is no need to measure for hours
            measure(figures);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
        return 1;
    }
    std::ofstream file(argv[1]);
    file << figures.str();
    file.close();
    if (!file) {
        std::perror(argv[1]);
        return 1;
    }
    return 0;
}
