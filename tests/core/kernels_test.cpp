// The kernels for every processor and those for fused multiply-add, called side by side: the same bits.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include <rotconv/conversion.hpp>

#include "../../src/core/conversion/kernels.hpp"
#include "../../src/core/representations/codec.hpp"
#include "accuracy.hpp"
#include "catch.hpp"

#if defined(__x86_64__)

namespace rotconv {
extern const KernelTable kernels_of_any_processor;
extern const KernelTable kernels_of_avx2_fma;
} // namespace rotconv

namespace {

using rotconv::batch_rows;
using rotconv::KernelTable;
using rotconv::Spec;

constexpr std::size_t all_rows = tried(100'000); // half of them with numbers of sizes that take 50 us a row and more

bool has_fma() { return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0; }

/// Numbers of every size in one row; some are 0, and some of the sizes that attitudes have.
class Numbers {
public:
    double any() {
        const std::uint64_t bits = engine_();
        const double sign = (bits & 1U) != 0 ? -1.0 : 1.0;
        switch (bits >> 1U & 7U) {
        case 0: return 0.0;
        case 1: return sign * std::exp2(uniform(-1074, 1000));
        case 2: return sign * std::exp2(uniform(-540, -440));
        case 3: return sign * std::round(uniform(0, 400)) * std::pow(10, std::round(uniform(-324, 3)));
        case 4: return sign * 90 * std::round(uniform(0, 8));
        default: return uniform(-3.2, 3.2);
        }
    }
    /// A row of the representation: half of them near an attitude, as matrices have to be.
    void fill(const Spec& spec, double* row) {
        const std::size_t size = spec.size();
        if (uniform(0, 1) < 0.5) {
            std::generate(row, row + size, [this] { return any(); });
            return;
        }
        const auto rotation =
            rotconv::Rotation::from_components(1 + uniform(-1, 1), any() / 4, uniform(-1, 1), uniform(-1, 1));
        rotconv::write_row(spec, rotation, row);
        if (uniform(0, 1) < 0.5) {
            double& number = row[engine_() % size];
            number += 1e-3 * any();
        }
    }
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

private:
    std::mt19937_64 engine_{21};
};

struct Answers {
    std::array<double, batch_rows * 9> numbers{};
    std::array<double, batch_rows * 9> rest{};
    std::array<rotconv::DiagnosticSet, batch_rows> diagnostics{};
    rotconv::AttitudeBatch<double> attitudes{};
};

/// Only what rows without an error have is promised.
bool are_same(const Answers& a, const Answers& b, std::size_t row, std::size_t size) {
    if (a.attitudes.error[row] != b.attitudes.error[row]) {
        return false;
    }
    const auto same = [](double x, double y) { return std::memcmp(&x, &y, sizeof x) == 0 || (x == 0.0 && y == 0.0); };
    bool all = a.attitudes.error[row] != rotconv::Error::none ||
               (same(a.attitudes.defect[row], b.attitudes.defect[row]) &&
                same(a.attitudes[0].hi[row] * b.attitudes[1].hi[row], // but for a power of two
                     b.attitudes[0].hi[row] * a.attitudes[1].hi[row]));
    for (std::size_t k = 0; k < size && a.attitudes.error[row] == rotconv::Error::none; ++k) {
        all = all && same(a.numbers.at(row * size + k), b.numbers.at(row * size + k));
    }
    return all;
}

} // namespace

// Catches a product whose low part underflows, by which Dekker's way and a fused one differ; numbers that one
// target takes for plain and the other not; in plain double as well.
TEST_CASE("both targets give the same bits for numbers of every size, row for row") {
    if (!has_fma()) {
        WARN("this processor has no fused multiply-add");
        return;
    }
    const std::vector<std::string> specs{"dcm",        "6d",     "5d",  "quat",      "axis-angle:deg", "rotvec",
                                         "rotvec:deg", "cayley", "mrp", "euler:ZXZ", "euler:zyx:deg",  "rpy:passive"};
    Numbers numbers;
    std::vector<double> rows(batch_rows * 9);
    std::size_t compared = 0;
    std::size_t without_error = 0;
    std::size_t different = 0;
    for (std::size_t batch = 0; compared < all_rows; ++batch) {
        const Spec from = accuracy::spec(specs[batch % specs.size()]);
        const Spec to = accuracy::spec(specs[batch / specs.size() % specs.size()]);
        for (std::size_t i = 0; i < batch_rows; ++i) {
            numbers.fill(from, rows.data() + i * from.size());
        }
        const rotconv::ExactQuaternion turn{{0.6, 0.0, 1e-170, 0.8}, {1e-20, 0.0, 0.0, 0.0}, 0.0};
        const rotconv::FixedFactor factor{.numbers = {0.6, 0.0, 1e-170, 0.8}, .rest = {1e-20}};
        const rotconv::FixedRotations turns{{turn, &factor, batch % 5 == 0 ? 1U : 0U}, {}};
        rotconv::ZeroTable zeros;
        const rotconv::Task task{&from, &to, 1e-15, &turns, &zeros};
        for (const auto convert : {&KernelTable::run, &KernelTable::run_fast}) {
            Answers plain;
            Answers fused;
            const auto run = [&](const KernelTable& table, Answers& answers) {
                (table.*convert)(task, {rows.data()}, batch_rows, {answers.attitudes}, answers.numbers.data(),
                                 batch % 2 == 0 ? answers.rest.data() : nullptr, answers.diagnostics.data());
            };
            run(rotconv::kernels_of_any_processor, plain);
            run(rotconv::kernels_of_avx2_fma, fused);
            for (std::size_t i = 0; i < batch_rows; ++i) {
                ++compared;
                without_error += plain.attitudes.error[i] == rotconv::Error::none ? 1 : 0;
                if (!are_same(plain, fused, i, to.size()) && ++different < 4) {
                    UNSCOPED_INFO(specs[batch % specs.size()]
                                  << " to " << specs[batch / specs.size() % specs.size()] << ":"
                                  << accuracy::text_of({&rows[i * from.size()], from.size()}));
                }
            }
        }
    }
    CHECK(different == 0);
    CHECK(without_error > compared / 2);
}

#endif
