// Every method against the exact attitude and against Eigen's own conversion: bench_methods OUT.csv

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "figures.hpp"
#include "samples.hpp"
#include "scores.hpp"
#include "times.hpp"
#include "ways.hpp"

namespace {

using namespace bench;

std::string field(double value) { return std::isnan(value) ? "" : fmt::format("{:.4g}", value); }

void write(std::ostream& csv, const Pair& pair, const Way& way, const std::string& stratum, bool hostile,
           double distance, const Score& s, const std::array<double, 4>& times) {
    csv << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", text_of(pair.from), text_of(pair.to),
                       way.name, stratum, hostile ? 1 : 0, field(distance), s.rows, s.not_finite, field(s.worst),
                       field(s.rms()), field(s.relative), field(s.defect), field(times[0]), field(times[1]),
                       field(times[2]), field(times[3]), s.where);
}

/// One score a stratum, where it has several samples for both together.
std::vector<std::pair<const Sample*, Score>> scores_of(const std::vector<Sample>& samples, const Way& way) {
    std::vector<std::pair<const Sample*, Score>> scores;
    for (const Sample& sample : samples) {
        const Score made = score(sample, way);
        const auto same = std::ranges::find_if(scores, [&](const auto& other) {
            return other.first->stratum == sample.stratum && other.first->hostile == sample.hostile;
        });
        if (same == scores.end()) {
            scores.emplace_back(&sample, made);
        } else {
            same->second.add(made);
        }
    }
    return scores;
}

void write_pair(std::ostream& csv, const Pair& pair, const Times& times) {
    const auto samples = strata_of(pair);
    const auto sweeps = sweeps_of(pair);
    for (const Way& way : pair.ways) {
        std::array<Score, 2> totals;
        // The times of the way on those rows, also in those of Eigen's.
        const auto times_on = [&](const std::string& rows) -> std::array<double, 4> {
            std::array<double, 4> all{};
            for (const bool million : {false, true}) {
                const double time = times.of(pair, way.name, rows, million);
                all.at(million ? 1 : 0) = time;
                all.at(million ? 3 : 2) = time / times.of(pair, "Eigen", rows, million);
            }
            return all;
        };
        for (const auto& [sample, made] : scores_of(samples, way)) {
            write(csv, pair, way, sample->stratum, sample->hostile, none, made,
                  times_on(sample->hostile ? "" : sample->stratum));
            totals[sample->hostile ? 1 : 0].add(made);
        }
        for (const Sample& sample : sweeps) {
            write(csv, pair, way, sample.stratum, sample.hostile, sample.distance, score(sample, way), times_on(""));
        }
        for (const bool hostile : {false, true}) {
            const std::string rows = hostile ? "hostile" : "clean";
            write(csv, pair, way, rows, hostile, none, totals[hostile ? 1 : 0], times_on(rows));
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    return write_figures(argc, argv, [](std::ostream& csv) {
        const auto all = pairs();
        const Times times(all);
        csv << "from,to,method,stratum,hostile,distance,rows,not_finite,worst,rms,relative,defect,ns,ns_million,"
               "x_eigen,x_eigen_million,where\n";
        for (const Pair& pair : all) {
            write_pair(csv, pair, times);
        }
    });
}
