#include "strata.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace strata {
namespace {

using oracle::Quaternion;
using oracle::Real;
using oracle::Vector3;

Real power_of_ten(double exponent) { return pow(Real(10), Real(exponent)); }

Stratum uniform(int size) {
    Source source(1);
    Stratum stratum{"uniform", {}};
    for (int i = 0; i < size; ++i) {
        stratum.attitudes.push_back(source.attitude());
    }
    return stratum;
}

Stratum small(int size) {
    Source source(2);
    Stratum stratum{"small angles", {}};
    for (int i = 0; i < size; ++i) {
        const double exponent = i % 3 == 0 ? source.uniform(-300, 0) : source.uniform(-20, 0);
        stratum.attitudes.push_back(oracle::about(source.axis(), power_of_ten(exponent)));
    }
    return stratum;
}

Stratum half_turns(int size) {
    Source source(3);
    Stratum stratum{"half-turns", {}};
    for (int i = 0; i < size; ++i) {
        const Real distance =
            i % 8 == 0 ? Real(0) : power_of_ten(i % 3 == 0 ? source.uniform(-300, 0) : source.uniform(-20, 0));
        Vector3 axis = source.axis();
        if (i % 5 == 0) {
            axis = Vector3::Unit(source.integer(0, 2));
        } else if (i % 5 == 1) {
            axis[source.integer(0, 2)] = 0;
        }
        stratum.attitudes.push_back(oracle::about(axis, oracle::pi() - distance));
    }
    return stratum;
}

/// Two, three or four components of equal size, or some that vanish, off by 10^-k.
Stratum borders(int size) {
    Source source(4);
    Stratum stratum{"borders", {}};
    for (int i = 0; i < size; ++i) {
        std::array<Real, 4> q;
        for (Real& component : q) {
            component = source.integer(-2, 2);
            if (source.integer(0, 1) == 1) {
                component += power_of_ten(source.uniform(-18, -1)) * source.integer(-1, 1);
            }
        }
        Quaternion attitude(q[0], q[1], q[2], q[3]);
        if (attitude.norm() == 0) {
            attitude = Quaternion::Identity();
        }
        attitude.normalize();
        stratum.attitudes.push_back(attitude);
    }
    return stratum;
}

Stratum cube() {
    Stratum stratum{"cube rotations", {}};
    const oracle::Real quarter = oracle::pi() / 2;
    for (int first = 0; first < 4; ++first) {
        for (int second = 0; second < 4; ++second) {
            for (int third = 0; third < 4; ++third) {
                stratum.attitudes.push_back(oracle::about(Vector3::UnitZ(), quarter * first) *
                                            oracle::about(Vector3::UnitY(), quarter * second) *
                                            oracle::about(Vector3::UnitX(), quarter * third));
            }
        }
    }
    return stratum;
}

void scale(std::span<double> row, double factor) {
    for (double& v : row) {
        v *= factor;
    }
}

bool finite(const std::vector<double>& row) {
    return std::ranges::all_of(row, [](double v) { return std::isfinite(v); });
}

} // namespace

Vector3 Source::axis() {
    const Vector3 v(normal(), normal(), normal());
    return v.normalized();
}

Quaternion Source::attitude() {
    Quaternion q(normal(), normal(), normal(), normal());
    q.normalize();
    return q;
}

std::vector<Stratum> attitudes(int size) {
    return {uniform(size), small(size), half_turns(size), borders(size), cube()};
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
    default: return false;
    }
}

std::vector<Rows> rows_of(const rotconv::Spec& from, const rotconv::Spec& to, int size) {
    auto strata = attitudes(size);
    if (to.name == rotconv::RepresentationId::euler || to.name == rotconv::RepresentationId::rpy) {
        strata.push_back(near_lock(to.sequence, 2 * size));
    }
    std::vector<Rows> all;
    for (const Stratum& stratum : strata) {
        Rows& made = all.emplace_back(Rows{stratum.name, false, {}});
        for (const auto& attitude : stratum.attitudes) {
            made.rows.push_back(oracle::numbers(from, attitude));
        }
        std::erase_if(made.rows, std::not_fn(finite));
    }
    Source source(11);
    for (std::size_t i = 0; i < strata.size(); ++i) {
        Rows changed{all[i].name, true, {}};
        for (auto row : all[i].rows) {
            if (make_hostile(from, row, source) && finite(row)) {
                changed.rows.push_back(std::move(row));
            }
        }
        all.push_back(std::move(changed));
    }
    return all;
}

std::vector<std::vector<double>> euler_angles(const rotconv::Spec& spec, int size) {
    Source source(5);
    const bool degrees = spec.unit == rotconv::AngleUnit::degrees;
    const double half = degrees ? 180.0 : std::numbers::pi;
    const double lock = spec.sequence.proper() ? 0.0 : 0.5 * half;
    std::vector<std::vector<double>> rows;
    for (int i = 0; i < size; ++i) {
        std::vector<double> row{source.uniform(-half, half), source.uniform(-half, half), source.uniform(-half, half)};
        switch (i % 6) {
        case 0: row[1] = lock; break;
        case 1: row[1] = lock + std::pow(10.0, source.uniform(-18, 0)); break;
        case 2: row[1] = lock + half - std::pow(10.0, source.uniform(-18, 0)); break;
        case 3:
            for (double& angle : row) {
                angle = 0.5 * half * source.integer(-8, 8);
            }
            break;
        case 4:
            for (double& angle : row) {
                angle *= std::pow(10.0, source.uniform(0, 15));
            }
            break;
        default: break;
        }
        rows.push_back(row);
    }
    return rows;
}

Stratum near_lock(rotconv::EulerSequence sequence, int size) {
    Source source(6);
    Stratum stratum{"near lock", {}};
    const auto axis = [&](std::size_t position) { return Vector3::Unit(sequence.axis(position)); };
    for (int i = 0; i < size; ++i) {
        const Real distance =
            i % 8 == 0 ? Real(0) : power_of_ten(i % 3 == 0 ? source.uniform(-300, 0) : source.uniform(-20, 0));
        Real middle = (sequence.proper() ? Real(0) : Real(oracle::pi() / 2)) + distance;
        if (i % 2 == 1) {
            middle = (sequence.proper() ? Real(oracle::pi()) : Real(-oracle::pi() / 2)) + distance;
        }
        const Quaternion first = oracle::about(axis(0), source.uniform(-3, 3));
        const Quaternion second = oracle::about(axis(1), middle);
        const Quaternion third = oracle::about(axis(2), source.uniform(-3, 3));
        stratum.attitudes.push_back(sequence.intrinsic() ? first * second * third : third * second * first);
    }
    return stratum;
}

} // namespace strata
