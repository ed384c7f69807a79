#include "samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "strata.hpp"

namespace bench {

using rotconv::RepresentationId;
using rotconv::Spec;

namespace {

enum class Sweep { half_turn, identity, lock, noise };

Sample sweep_at(const Spec& from, const Spec& to, Sweep sweep, int exponent) {
    static constexpr std::array names{"to half-turn", "to identity", "to lock", "noise"};
    const double distance = std::pow(10.0, -exponent);
    Sample sample{.from = from,
                  .to = to,
                  .stratum = names[static_cast<std::size_t>(sweep)],
                  .hostile = sweep == Sweep::noise,
                  .distance = distance,
                  .relative = sweep == Sweep::identity};
    strata::Source source(100 + static_cast<unsigned>(exponent));
    for (int i = 0; i < 60; ++i) {
        oracle::Quaternion q = source.attitude();
        const oracle::Vector3 axis = source.axis();
        if (sweep == Sweep::half_turn) {
            q = oracle::about(axis, oracle::pi() - distance);
        } else if (sweep == Sweep::identity) {
            q = oracle::about(axis, distance);
        } else if (sweep == Sweep::lock) {
            const oracle::Real middle = (oracle::pi() / 2 - distance) * (i % 2 == 0 ? 1 : -1);
            q = oracle::about(oracle::Vector3::UnitZ(), source.uniform(-3, 3)) *
                oracle::about(oracle::Vector3::UnitY(), middle) *
                oracle::about(oracle::Vector3::UnitX(), source.uniform(-3, 3));
        }
        auto row = oracle::numbers(from, q);
        if (sweep == Sweep::noise) {
            for (double& v : row) {
                v += distance * source.uniform(-1, 1);
            }
        }
        sample.add(std::move(row));
    }
    return sample;
}

std::vector<Sweep> kinds_of(RepresentationId from, RepresentationId to) {
    if (from == RepresentationId::dcm && to == RepresentationId::quat) {
        return {Sweep::half_turn, Sweep::noise};
    }
    if (from == RepresentationId::dcm && to == RepresentationId::rotvec) {
        return {Sweep::half_turn, Sweep::identity};
    }
    if ((from == RepresentationId::quat && to == RepresentationId::rotvec) ||
        (from == RepresentationId::rotvec && to == RepresentationId::quat)) {
        return {Sweep::identity};
    }
    return to == RepresentationId::euler ? std::vector{Sweep::lock} : std::vector<Sweep>{};
}

void add_strata(const Spec& from, const Spec& to, std::vector<Sample>& samples) {
    for (auto& stratum : strata::strata_of(from, to, 400)) {
        Sample sample{.from = from,
                      .to = to,
                      .stratum = std::string(name_of(stratum.kind)),
                      .hostile = stratum.hostile,
                      .relative = stratum.kind == rotconv::SampleKind::small};
        for (auto& row : stratum.rows) {
            sample.add(std::move(row));
        }
        samples.push_back(std::move(sample));
    }
}

} // namespace

void Sample::add(std::vector<double> row) {
    if (std::ranges::all_of(row, [](double v) { return std::isfinite(v); })) {
        exact.push_back(oracle::attitude(from, row));
        rows.push_back(std::move(row));
    }
}

std::vector<Sample> strata_of(const Pair& pair) {
    std::vector<Sample> samples;
    add_strata(pair.source(), pair.target(), samples);
    if (pair.from == RepresentationId::euler || pair.to == RepresentationId::euler) {
        add_strata(pair.source("ZXZ"), pair.target("ZXZ"), samples);
    }
    return samples;
}

std::vector<Sample> sweeps_of(const Pair& pair) {
    std::vector<Sample> samples;
    for (const Sweep sweep : kinds_of(pair.from, pair.to)) {
        for (int exponent = 1; exponent <= 16; ++exponent) {
            samples.push_back(sweep_at(pair.source(), pair.target(), sweep, exponent));
        }
    }
    return samples;
}

} // namespace bench
