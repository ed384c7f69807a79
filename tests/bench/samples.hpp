#pragma once

#include <string>
#include <vector>

#include "oracle.hpp"
#include "ways.hpp"

namespace bench {

/// Rows with the attitudes that they exactly stand for.
struct Sample {
    rotconv::Spec from;
    rotconv::Spec to;
    std::string stratum;
    bool hostile = false;
    double distance = none; ///< from the singularity, of a sweep
    bool relative = false;  ///< small angles, whose relative error counts
    std::vector<std::vector<double>> rows{};
    std::vector<oracle::Quaternion> exact{};

    void add(std::vector<double> row);
};

/// The strata of the tests, each as it is and hostile; two sequences of Euler angles.
std::vector<Sample> strata_of(const Pair& pair);

/// Attitudes at 10^-1 to 10^-16 from the singularities that the pair's methods are known to fail at.
std::vector<Sample> sweeps_of(const Pair& pair);

} // namespace bench
