#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include <rotconv/sampling.hpp>

#include "oracle.hpp"

/// Rows on which conversions are tried. Their kinds are those with which the program lets others be tried.
namespace strata {

/// Random attitudes and axes from one seed.
class Source {
public:
    explicit Source(std::uint64_t seed) : engine_(seed) {}

    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    double normal() { return std::normal_distribution<double>()(engine_); }
    int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
    oracle::Vector3 axis();
    oracle::Quaternion attitude();

private:
    std::mt19937_64 engine_;
};

using rotconv::SampleKind;
using Numbers = std::vector<std::vector<double>>;

/// The first rows that the program's `sample` writes of a kind.
Numbers sampled(const rotconv::Spec& spec, SampleKind kind, int size);
/// Of its rows near gimbal lock, and on it, those of a sequence. `spec` is no Euler angles, whose rows are all their
/// own.
Numbers near_lock(const rotconv::Spec& spec, rotconv::EulerSequence sequence, int size);

/// The same attitude in other numbers, or numbers that are harder to read: scaled, noisy by up to 5e-4, long, by more
/// than a turn. False where the representation has no such numbers; then the row stays.
bool make_hostile(const rotconv::Spec& spec, std::span<double> row, Source& source);

struct Stratum {
    SampleKind kind{};
    bool hostile = false;
    Numbers rows;
};

/// The input of a conversion: the kinds of rows that every representation has, near lock where `from` or `to` has one,
/// then each of them made hostile. Rows that have no finite form are left out.
std::vector<Stratum> strata_of(const rotconv::Spec& from, const rotconv::Spec& to, int size);

} // namespace strata
