// Writes the numbers of every pair of representations as they are in memory, from attitudes and numbers of each kind.
// The bytes must not depend on what the processor has.

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include <rotconv/conversion.hpp>

namespace {

constexpr const char* specs[] = {"dcm",        "6d",     "5d",  "quat:xyzw", "axis-angle:deg", "rotvec",
                                 "rotvec:deg", "cayley", "mrp", "euler:ZYX", "euler:zxz:deg"};

rotconv::Spec spec(const std::string& text) { return std::get<rotconv::Spec>(rotconv::parse_spec(text)); }

/// Uniform, by angles down to 1e-12 and to half-turns at that distance, with components that vanish.
std::vector<double> quaternions() {
    std::mt19937_64 engine(5);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> exponent(-12, 0);
    std::vector<double> all;
    for (int i = 0; i < 1200; ++i) {
        double q[4] = {normal(engine), normal(engine), normal(engine), normal(engine)};
        if (i % 3 == 1) {
            q[0] *= std::exp2(4 * exponent(engine));
        } else if (i % 3 == 2) {
            q[0] *= std::exp2(-4 * exponent(engine));
        }
        if (i % 7 == 0) {
            q[i % 4] = 0.0;
        }
        const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (const double component : q) {
            all.push_back(component / norm);
        }
    }
    return all;
}

std::vector<double> converted(const rotconv::Spec& from, const rotconv::Spec& to, const std::vector<double>& numbers) {
    const std::size_t rows = numbers.size() / from.size();
    std::vector<double> result(rows * to.size());
    std::vector<rotconv::Report> reports;
    rotconv::Conversion(from, to, {.tolerance = 0.1}).run(numbers, result, reports);
    return result;
}

void write(const std::vector<double>& numbers) { std::fwrite(numbers.data(), sizeof(double), numbers.size(), stdout); }

} // namespace

int main() {
    const auto attitudes = quaternions();
    std::mt19937_64 engine(6);
    std::uniform_real_distribution<double> noise(-1, 1);
    for (const char* from : specs) {
        const auto clean = converted(spec("quat"), spec(from), attitudes);
        auto noisy = clean;
        for (double& number : noisy) {
            number += 1e-4 * noise(engine);
        }
        for (const char* to : specs) {
            write(converted(spec(from), spec(to), clean));
            write(converted(spec(from), spec(to), noisy));
        }
    }
}
