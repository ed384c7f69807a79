// Another library's conversion, held against rotconv's reading of both sides: Eigen's matrix to quaternion.

#include <algorithm>
#include <iostream>
#include <vector>

#include <rotconv/rotconv.hpp>

using namespace rotconv;

int main() {
    constexpr std::size_t count = 7000;
    const Spec spec = eigen_matrix;
    Sampler sampler(spec, {.kinds = sample_kinds_of(spec.name), .noise = 0.0}); // rows on which conversions fail
    std::vector<double> rows(count);
    std::generate(rows.begin(), rows.end(), [i = 0]() mutable { return i++; });
    std::vector<double> matrices(count * spec.size());
    sampler.run(rows, matrices);

    std::vector<double> pairs; // the matrix, then what Eigen makes of it
    for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Map<const Eigen::Matrix3d> matrix(matrices.data() + 9 * i);
        const Eigen::Quaterniond q(matrix);
        pairs.insert(pairs.end(), matrix.data(), matrix.data() + 9);
        pairs.insert(pairs.end(), q.coeffs().data(), q.coeffs().data() + 4);
    }
    std::vector<double> angles(count);
    std::vector<RowReport> reports;
    Comparison(spec, eigen_quaternion).run(pairs, angles, reports);
    const double worst = *std::max_element(angles.begin(), angles.end());
    std::cout << "worst angle below 1e-14 rad: " << (worst < 1e-14 ? "yes" : "no") << '\n';
}
