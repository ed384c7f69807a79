// The oracle itself, against vectors that another program made with 60-digit arithmetic.

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"

namespace {

struct Vector {
    rotconv::Spec spec;
    std::vector<double> numbers;
    oracle::Quaternion exact;
};

/// Rows of spec, stratum, up to nine numbers, and the quaternion to 34 digits.
std::vector<Vector> vectors() {
    std::ifstream file(ROTCONV_TEST_DATA "/attitudes.csv");
    std::vector<Vector> all;
    std::string line;
    std::getline(file, line); // the header
    while (std::getline(file, line)) {
        std::vector<std::string> fields;
        std::istringstream row(line);
        for (std::string field; std::getline(row, field, ',');) {
            fields.push_back(field);
        }
        Vector vector{accuracy::spec(fields.at(0)), {}, {}};
        for (std::size_t i = 0; i < vector.spec.size(); ++i) {
            vector.numbers.push_back(std::stod(fields.at(2 + i)));
        }
        vector.exact = oracle::Quaternion(oracle::Real(fields.at(11)), oracle::Real(fields.at(12)),
                                          oracle::Real(fields.at(13)), oracle::Real(fields.at(14)));
        all.push_back(std::move(vector));
    }
    return all;
}

} // namespace

// Catches an oracle that shares an error with the code.
TEST_CASE("the oracle agrees with vectors from elsewhere to a thousandth of eps") {
    const auto all = vectors();
    CHECK(all.size() == 904);
    double worst = 0.0;
    for (const auto& vector : all) {
        worst = std::max(worst, oracle::error_in_eps(vector.exact, oracle::attitude(vector.spec, vector.numbers)));
    }
    CHECK(worst < 0.002);
}

// Catches a defect that is measured in another norm.
TEST_CASE("the oracle's defect is the largest deviation of a singular value") {
    const std::vector<double> stretched{2, 0, 0, 0, 0.5, 0, 0, 0, 1};
    CHECK(static_cast<double>(oracle::defect(accuracy::spec("dcm"), stretched)) == Approx(1.0));
    const std::vector<double> pair{3, 0, 0, 0, 0.25, 0};
    CHECK(static_cast<double>(oracle::defect(accuracy::spec("6d"), pair)) == Approx(2.0));
}
