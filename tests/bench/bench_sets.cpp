// Which sets of parameters serve which motion, by the survey of 20 s at 100 Hz: bench_sets OUT.csv

#include <string>

#include <fmt/format.h>

#include "../../src/core/kinematics/survey.hpp"
#include "figures.hpp"
#include "motions.hpp"

namespace {

constexpr double limit = 1000.0; // of the condition, the program's default

rotconv::Survey survey_of(const motions::Motion& motion) {
    rotconv::Survey survey;
    for (std::size_t i = 0; i <= 2000; ++i) {
        survey.add(oracle::rotation(motion.attitude(oracle::Real(i) / 100)), i);
    }
    return survey;
}

void measure(std::ostream& csv) {
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
}

} // namespace

int main(int argc, char** argv) { return write_figures(argc, argv, measure); }
