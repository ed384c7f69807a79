// Which sets of parameters serve which motion, by the survey of 20 s at 100 Hz: bench_sets OUT.csv

#include <cstdio>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include <rotconv/survey.hpp>

#include "motions.hpp"

namespace {

constexpr double limit = 1000.0; // of the condition, the program's default

rotconv::Survey survey_of(const motions::Motion& motion) {
    rotconv::Survey survey;
    for (std::size_t i = 0; i <= 2000; ++i) {
        const auto q = motion.attitude(oracle::Real(i) / 100);
        survey.add(rotconv::Rotation::from_components(static_cast<double>(q.w()), static_cast<double>(q.x()),
                                                      static_cast<double>(q.y()), static_cast<double>(q.z())),
                   i);
    }
    return survey;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2 || argv[1][0] == '-') {
        std::fputs("usage: bench_sets OUT.csv\n", stderr);
        return 2;
    }
    std::ofstream csv(argv[1]);
    if (!csv) {
        std::perror(argv[1]);
        return 1;
    }
    csv << "motion,set,numbers,least_margin,greatest_condition,jumps,serves,smallest\n";
    for (const auto& motion : motions::all()) {
        const auto survey = survey_of(motion);
        const auto* const smallest = survey.smallest(limit);
        for (const auto& set : survey.representations()) {
            csv << fmt::format("{},{},{},{:.4g},{:.4g},{},{},{}\n", motion.name, set.spec.text(), set.spec.size(),
                               set.least_margin, set.greatest_condition, set.jumps, set.serves(limit) ? 1 : 0,
                               &set == smallest ? 1 : 0);
        }
    }
    csv.close();
    return csv ? 0 : 1;
}
