#include <cstdio>
#include <cstdlib>

#include "accuracy.hpp"

int main(int argc, char** argv) {
    const int size = argc > 1 ? std::atoi(argv[1]) : 20000;
    std::puts("| from | to | limit | worst, radians | worst, degrees |");
    for (const auto& way : accuracy::ways()) {
        const auto radians = accuracy::worst_of(way, size);
        const auto degrees = accuracy::worst_of(way, size, rotconv::AngleUnit::degrees);
        std::printf("| %s | %s | %g | %.2f | %.2f |\n    %s\n    %s\n", way.from.c_str(), way.to.c_str(), way.limit,
                    radians.error, degrees.error, radians.where.c_str(), degrees.where.c_str());
        std::fflush(stdout);
    }
}
