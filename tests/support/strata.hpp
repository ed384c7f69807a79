#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "oracle.hpp"

/// The kinds of attitude on which conversions are tried, each of a fixed seed.
namespace strata {

struct Stratum {
    std::string name;
    std::vector<oracle::Quaternion> attitudes;
};

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

/// Uniform; angles 10^-k to 1e-300; pi - 10^-k; equal and vanishing quaternion components; the 24 cube rotations;
/// half-turns. About `size` attitudes in each.
std::vector<Stratum> attitudes(int size);

/// The same attitude in other numbers, or numbers that are harder to read: scaled, noisy by up to 5e-4, long, by more
/// than a turn. False where the representation has no such numbers; then the row stays.
bool make_hostile(const rotconv::Spec& spec, std::span<double> row, Source& source);

/// Rows of numbers on one stratum.
struct Rows {
    std::string name;
    bool hostile = false;
    std::vector<std::vector<double>> rows;
};

/// The input of a conversion: every stratum, with lock where `to` has one, then each of them made hostile. Rows that
/// have no finite form in `from` are left out. `from` is neither euler nor rpy, whose angles are chosen.
std::vector<Rows> rows_of(const rotconv::Spec& from, const rotconv::Spec& to, int size);

/// Angles of a sequence, radians or degrees: uniform, at 10^-k from lock, at lock, multiples of 90 degrees, many turns.
std::vector<std::vector<double>> euler_angles(const rotconv::Spec& spec, int size);

/// Attitudes at 10^-k from gimbal lock of a sequence, and on it.
Stratum near_lock(rotconv::EulerSequence sequence, int size);

} // namespace strata
