// As a user's own flags may compile the headers: with multiplications and additions contracted.

#include <array>
#include <cmath>
#include <cstdio>

#include <rotconv/dcm.hpp>
#include <rotconv/quaternion.hpp>

int main() {
    constexpr int skipped = 77;
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
        return skipped;
    }
    int failures = 0;
    for (const double c : {0.7071067811865476, 0.3, 1e-5}) {
        for (const double s : {c, -c}) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                std::array<double, 3> v{};
                v.at(axis) = s;
                const auto m = rotconv::dcm::from_rotation(*rotconv::quaternion::to_rotation({c, v[0], v[1], v[2]}));
                int ones = 0;
                int zeros = 0;
                for (Eigen::Index i = 0; i < 9; ++i) {
                    ones += std::fabs(m(i / 3, i % 3)) == 1.0 ? 1 : 0;
                    zeros += m(i / 3, i % 3) == 0.0 ? 1 : 0;
                }
                if (ones != 3 || zeros != 6) {
                    std::printf("a quarter turn about axis %zu, w = %g, is not exact\n", axis, c);
                    ++failures;
                }
            }
        }
    }
    return failures == 0 ? 0 : 1;
}
