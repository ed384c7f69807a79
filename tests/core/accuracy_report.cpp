#include <cstdio>
#include <cstdlib>

#include "accuracy.hpp"
#include "rounding.hpp"

int main(int argc, char** argv) {
    const int size = argc > 1 ? std::atoi(argv[1]) : 20000;
    accuracy::Rounding all;
    for (const auto& from : accuracy::compared_specs()) {
        for (const auto& to : accuracy::compared_specs()) {
            all += accuracy::rounding_of(from, to, size / 100); // each digit of the oracle's takes its time
        }
    }
    std::printf("correctly rounded: %zu of %zu numbers of %zu rows; %zu undecided\n", all.correct(), all.numbers,
                all.rows, all.uncertain);
    std::puts("--method fast, worst attitude error in eps = 2^-52 rad:\n"
              "| from | to | limit | radians | degrees |");
    for (const auto& way : accuracy::ways()) {
        const auto radians = accuracy::worst_of(way, size);
        const auto degrees = accuracy::worst_of(way, size, rotconv::AngleUnit::degrees);
        std::printf("| %s | %s | %g | %.2f | %.2f |\n    %s\n    %s\n", way.from.c_str(), way.to.c_str(), way.limit,
                    radians.error, degrees.error, radians.where.c_str(), degrees.where.c_str());
        std::fflush(stdout);
    }
    return all.wrong == 0 ? 0 : 1;
}
