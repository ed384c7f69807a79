#include "strata.hpp"

#include <algorithm>
#include <cmath>

namespace strata {
namespace {

void scale(std::span<double> row, double factor) {
    for (double& v : row) {
        v *= factor;
    }
}

bool finite(const std::vector<double>& row) {
    return std::ranges::all_of(row, [](double v) { return std::isfinite(v); });
}

Numbers rows_at(const rotconv::Spec& spec, SampleKind kind, int size, std::size_t first, std::size_t step) {
    rotconv::Sampler sampler(spec, {.kinds = {kind}});
    Numbers rows(static_cast<std::size_t>(size), std::vector<double>(spec.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto index = static_cast<double>(first + i * step);
        sampler.run({&index, 1}, rows[i]);
    }
    return rows;
}

} // namespace

oracle::Vector3 Source::axis() {
    const oracle::Vector3 v(normal(), normal(), normal());
    return v.normalized();
}

oracle::Quaternion Source::attitude() {
    oracle::Quaternion q(normal(), normal(), normal(), normal());
    q.normalize();
    return q;
}

Numbers sampled(const rotconv::Spec& spec, SampleKind kind, int size) { return rows_at(spec, kind, size, 0, 1); }

Numbers near_lock(const rotconv::Spec& spec, rotconv::EulerSequence sequence, int size) {
    const auto all = rotconv::EulerSequence::all(); // which take turns
    const auto place = static_cast<std::size_t>(std::ranges::find(all, sequence) - all.begin());
    return rows_at(spec, SampleKind::lock, size, place, all.size());
}

bool make_hostile(const rotconv::Spec& spec, std::span<double> row, Source& source) {
    using rotconv::RepresentationId;
    const auto ten_to = [&](double low, double high) { return std::pow(10.0, source.uniform(low, high)); };
    const auto either_sign = [&] { return source.integer(0, 1) == 0 ? -1.0 : 1.0; };
    switch (spec.name) {
    case RepresentationId::quat: {
        const double size = ten_to(-150, 150);
        scale(row, size * either_sign());
        return true;
    }
    case RepresentationId::dcm:
    case RepresentationId::two_column:
    case RepresentationId::five_d: {
        const double noise = ten_to(-17, -3.3);
        for (double& v : row) {
            v += noise * source.uniform(-1, 1);
        }
        return true;
    }
    case RepresentationId::axis_angle: {
        scale(row.first(3), ten_to(-150, 150));
        const double turns = ten_to(0, 15);
        row[3] *= turns * either_sign();
        return true;
    }
    case RepresentationId::rotvec: scale(row, ten_to(0, 14.4)); return true;
    case RepresentationId::euler:
    case RepresentationId::rpy: scale(row, ten_to(0, 15)); return true;
    case RepresentationId::cayley: scale(row, ten_to(-150, 150)); return true;
    case RepresentationId::mrp: {
        const double square = row[0] * row[0] + row[1] * row[1] + row[2] * row[2];
        for (double& v : row) {
            v /= -std::max(square, 1e-200); // the shadow, of any length
        }
        return true;
    }
    }
    return false;
}

std::vector<Stratum> strata_of(const rotconv::Spec& from, const rotconv::Spec& to, int size) {
    const auto locks = [](const rotconv::Spec& spec) { return rotconv::representation(spec.name).has_gimbal_lock; };
    std::vector<Stratum> all;
    for (const SampleKind kind : {SampleKind::uniform, SampleKind::small, SampleKind::half_turn, SampleKind::border}) {
        all.push_back({kind, false, sampled(from, kind, size)});
    }
    all.push_back({SampleKind::cube, false, sampled(from, SampleKind::cube, std::min(24, 2 * size))});
    if (locks(from)) {
        all.push_back({SampleKind::lock, false, sampled(from, SampleKind::lock, 2 * size)});
    } else if (locks(to)) {
        all.push_back({SampleKind::lock, false, near_lock(from, to.sequence, 2 * size)});
    }
    Source source(11);
    for (std::size_t i = 0, clean = all.size(); i < clean; ++i) {
        Stratum changed{all[i].kind, true, {}};
        for (auto row : all[i].rows) {
            if (make_hostile(from, row, source) && finite(row)) {
                changed.rows.push_back(std::move(row));
            }
        }
        all.push_back(std::move(changed));
    }
    return all;
}

} // namespace strata
