#include <cstdint>

#include "euler_formulas.hpp"
#include "kernel.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

/// The components of attitudes along the axes of a sequence. References: compilers do not vectorise access through an
/// array of pointers.
template <class C> struct ColumnsAlong { C &w, &i, &j, &k; };
template <class Batch> ROTCONV_INLINE auto columns_along(const FixedAxes& axes, Batch& attitudes) noexcept {
    auto& columns = attitudes.columns;
    using C = std::remove_reference_t<decltype(columns[0])>;
    return ColumnsAlong<C>{columns[0], columns[1 + axes.i], columns[1 + axes.j], columns[1 + axes.k]};
}

struct Angles {
    static constexpr std::size_t size = 3;

    /// The sines and cosines of the halves of the angles, in the order of the turns about fixed axes.
    template <class T> struct Halves {
        ROTCONV_INLINE Halves(const Spec& spec, const FixedAxes& axes, const double* numbers,
                              std::size_t rows) noexcept {
            for (std::size_t turn = 0; turn < 3; ++turn) {
                const std::size_t place = axes.places[turn];
                const double half_sign = 0.5 * spec.sequence.sign(place);
                Column<DoubleDouble> half;
                for (std::size_t i = 0; i < rows; ++i) {
                    half.set(i, half_sign * numbers[3 * i + place]);
                }
                sine_cosine(half, rows, spec.unit, cosines[turn], sines[turn]);
            }
        }
        ROTCONV_INLINE void get(std::size_t i, SineCosine<T> (&turns)[3]) const noexcept {
            for (std::size_t turn = 0; turn < 3; ++turn) {
                turns[turn] = {sines[turn][i], cosines[turn][i]};
            }
        }

        Columns<T, 3> cosines, sines;
    };

    template <class T>
    static void find_errors(const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
        for (std::size_t i = 0; i < rows; ++i) {
            attitudes.error[i] = all_finite(numbers + 3 * i, 3) ? Error::none : Error::not_finite;
            attitudes.defect[i] = 0.0;
            attitudes.off[i] = 0x1p-96; // of products below 1, the most of what is cleaned
        }
    }

    template <class T>
    static void read(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
        const FixedAxes axes(spec.sequence);
        find_errors(numbers, rows, attitudes);
        const Halves<T> halves(spec, axes, numbers, rows);
        auto [w, along_i, along_j, along_k] = columns_along(axes, attitudes);
        for (std::size_t i = 0; i < rows; ++i) {
            SineCosine<T> turns[3];
            T q[4];
            halves.get(i, turns);
            product_of_turns(axes, turns, q);
            w.set(i, q[0]);
            along_i.set(i, q[1]);
            along_j.set(i, q[2]);
            along_k.set(i, q[3]);
        }
    }

    /// In Approximate. See sine_cosine() for the errors of a sine and a cosine. A component of the quaternion, which is
    /// unit, is linear in each of the three vectors of cosine and sine, with coefficients of length 1 at most: it is
    /// off by three times their errors, the absolute ones or, of the sizes of its products, the relative ones.
    /// Roundings of these are below 2^-30 of that.
    template <class Axes> static void read_first_of(const Spec& spec, const double* numbers, std::size_t rows,
                                                    AttitudeBatch<double>& attitudes, std::uint64_t* doubts) noexcept {
        const Axes axes(spec.sequence);
        find_errors(numbers, rows, attitudes);
        const Halves<Approximate> halves(spec, axes, numbers, rows);
        constexpr double absolute = 3 * 0x1.3p-69;
        double open[batch_rows]; // 0, 1 where components may be 0, else 2: with bits the loop takes half as long again
        auto [w, along_i, along_j, along_k] = columns_along(axes, attitudes);
        for (std::size_t i = 0; i < rows; ++i) {
            SineCosine<Approximate> turns[3];
            SineCosine<Magnitude> size_turns[3];
            Approximate q[4];
            Magnitude sizes[4];
            halves.get(i, turns);
            for (std::size_t turn = 0; turn < 3; ++turn) {
                size_turns[turn] = {turns[turn].sine.hi, turns[turn].cosine.hi};
            }
            product_of_turns(axes, turns, q);
            product_of_turns(axes, size_turns, sizes);
            double doubt = 0.0;
            for (std::size_t k = 0; k < 4; ++k) {
                q[k] = normalized(q[k]);
                const double relative = 3 * 0x1p-63 * sizes[k].value;
                const double error = relative < absolute ? relative : absolute;
                const double own = __builtin_fabs(q[k].hi) <= error ? 1.0 : 2.0;
                doubt = larger_of(doubt, rounds_alike({q[k].hi, q[k].lo}, error) ? 0.0 : own);
            }
            open[i] = doubt;
            w.set(i, q[0].hi);
            along_i.set(i, q[1].hi);
            along_j.set(i, q[2].hi);
            along_k.set(i, q[3].hi);
        }
        for (std::size_t i = 0; i < rows; ++i) {
            doubts[i] = open[i] == 0.0 ? 0U : other_doubt;
            for (unsigned k = 0; k < 4 && open[i] == 1.0; ++k) {
                const std::uint64_t bit = __builtin_fabs(attitudes[k].hi[i]) <= absolute ? 1U : 0U;
                doubts[i] = (doubts[i] & ~other_doubt) | bit << k;
            }
        }
    }

    static bool read_first(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<double>& attitudes,
                           std::uint64_t* doubts) noexcept {
        spec.sequence.proper() ? read_first_of<AxesOfKind<true>>(spec, numbers, rows, attitudes, doubts)
                               : read_first_of<AxesOfKind<false>>(spec, numbers, rows, attitudes, doubts);
        return true;
    }

    /// `half_angle(i)`: the sine and cosine of half of the number i.
    template <class T, class HalfAngle>
    static void read_by(const Spec& spec, const HalfAngle& half_angle, T (&q)[4]) noexcept {
        const FixedAxes axes(spec.sequence);
        const SineCosine<T> turns[3] = {half_angle(axes.places[0]), half_angle(1), half_angle(axes.places[2])};
        T product[4];
        product_of_turns(axes, turns, product);
        q[0] = product[0];
        q[1 + axes.i] = product[1];
        q[1 + axes.j] = product[2];
        q[1 + axes.k] = product[3];
    }

    static Error read_one(const Spec& spec, const double* numbers, double (&q)[4], double& defect) noexcept {
        defect = 0.0;
        const auto half_angle = [&](std::size_t i) {
            const double angle = spec.sequence.sign(i) * alone(numbers[i]);
            return spec.unit == AngleUnit::radians && __builtin_fabs(angle) < 0x1p12
                       ? half_sine_cosine(angle)
                       : sine_cosine<double>(0.5 * angle, spec.unit);
        };
        read_by(spec, half_angle, q);
        return all_finite(numbers, 3) ? Error::none : Error::not_finite;
    }

    static void read_carefully(const Spec& spec, const double* numbers, Careful (&q)[4]) noexcept {
        const auto half_angle = [&](std::size_t i) {
            return sine_cosine(Careful(spec.sequence.sign(i) * numbers[i]).shifted(-1), spec.unit);
        };
        read_by(spec, half_angle, q);
    }

    /// The vectors of rows.
    template <class T> struct Vectors {
        template <class Axes, class Q> ROTCONV_INLINE Vectors(const Axes& axes, const AngleRanges& ranges,
                                                              const AttitudeBatch<Q>& attitudes,
                                                              std::size_t rows) noexcept {
            const auto [w, along_i, along_j, along_k] = columns_along(axes, attitudes);
            for (std::size_t i = 0; i < rows; ++i) {
                const T q[4] = {w[i], along_i[i], along_j[i], along_k[i]};
                const TurnVectors<T> vectors(axes, q);
                set(i, vectors);
                middle.set(i, {normalized(vectors.middle.x), normalized(vectors.middle.y)});
                lengths.set(i, {vectors.cosine_length, vectors.sine_length});
            }
            for (std::size_t i = 0; i < rows && ranges.is_other; ++i) { // a loop of its own: branches cost the vectors
                first.set(i, {-first[0][i], -first[1][i]});
                last.set(i, {-last[0][i], -last[1][i]});
            }
        }
        ROTCONV_INLINE void set(std::size_t i, const TurnVectors<T>& vectors) noexcept {
            first.set(i, {normalized(vectors.first.x), normalized(vectors.first.y)});
            last.set(i, {normalized(vectors.last.x), normalized(vectors.last.y)});
        }
        /// The angles, and as they are printed where no row is locked.
        void get_angles(const Spec& spec, const FixedAxes& axes, const AngleRanges& ranges, std::size_t rows,
                        Columns<DoubleDouble, 3>& angles, double* numbers) const noexcept {
            angles_of(first[0], first[1], rows, spec.unit, angles[axes.places[0]]);
            angles_of(middle[0], middle[1], rows, spec.unit, angles[1]);
            angles_of(last[0], last[1], rows, spec.unit, angles[axes.places[2]]);
            for (std::size_t i = 0; i < rows; ++i) {
                angles[1].set(i, scaled(angles[1][i], ranges.middle_factor));
            }
            for (std::size_t i = 0; i < rows && spec.sequence.has_signs(); ++i) {
                angles[0].set(i, scaled(angles[0][i], spec.sequence.sign(0)));
                angles[2].set(i, scaled(angles[2][i], spec.sequence.sign(2)));
            }
            for (std::size_t i = 0; i < rows; ++i) {
                numbers[3 * i] = ranges.outer(angles[0].hi[i]);
                numbers[3 * i + 1] = angles[1].hi[i];
                numbers[3 * i + 2] = ranges.outer(angles[2].hi[i]);
            }
            for (std::size_t i = 0; i < rows && spec.positive; ++i) {
                numbers[3 * i] = ranges.positive(angles[0][i]).hi;
                numbers[3 * i + 2] = ranges.positive(angles[2][i]).hi;
            }
        }

        Columns<T, 2> first, middle, last, lengths;
    };

    template <class T> static void write(const Spec& spec, double lock_margin, const AttitudeBatch<T>& attitudes,
                                         std::size_t rows, double* numbers, double* rest, DiagnosticSet* diagnostics,
                                         std::uint64_t* doubts) noexcept {
        const FixedAxes axes(spec.sequence);
        const LockLimit limit(lock_margin);
        const AngleRanges ranges(axes, spec);
        Vectors<T> vectors(axes, ranges, attitudes, rows);
        bool upper[batch_rows];
        double bound[batch_rows];
        for (std::size_t i = 0; i < rows; ++i) {
            const Lock<T> lock(vectors.lengths[0][i], vectors.lengths[1][i], limit);
            diagnostics[i] = lock.diagnostics();
            upper[i] = lock.upper;
            bound[i] = bound_of(spec, vectors.lengths[0].hi[i], vectors.lengths[1].hi[i], attitudes.off[i]);
            if (lock.locked) {
                const T q[4] = {attitudes[0][i], attitudes.columns[1 + axes.i][i], attitudes.columns[1 + axes.j][i],
                                attitudes.columns[1 + axes.k][i]};
                TurnVectors<T> given_up(axes, q);
                given_up.give_up_one(axes, q, lock.upper);
                vectors.set(i, given_up);
            }
        }
        Columns<DoubleDouble, 3> angles;
        vectors.get_angles(spec, axes, ranges, rows, angles, numbers);
        for (std::size_t i = 0; i < rows; ++i) {
            if (diagnostics[i].has(DiagnosticKind::gimbal_lock)) {
                angles[1].set(i, upper[i] ? ranges.upper : ranges.lower);
                numbers[3 * i + 1] = angles[1].hi[i];
            }
        }
        if constexpr (!std::is_same_v<T, double>) {
            find_doubts(spec, ranges, angles, bound, 0x1p-95, rows, doubts);
            for (std::size_t i = 0; i < rows; ++i) {
                const double off = attitudes.off[i] + 0x1p-96;
                if (diagnostics[i].has(DiagnosticKind::gimbal_lock)) {
                    // twice the angle of a vector of at least |q|, whose components are off by 2 off
                    const double error = unit_size(spec) * 16.0 * off;
                    doubts[i] = (doubts[i] & other_doubt) | doubt_of(angles[0][i], error, 0);
                    doubts[i] |= spec.positive ? doubt_of(ranges.positive(angles[0][i]), error, 0) : 0U;
                }
                doubts[i] |=
                    limit.is_doubtful(vectors.lengths[0].hi[i], vectors.lengths[1].hi[i], 4.0 * off) ? other_doubt : 0U;
            }
        }
        for (std::size_t i = 0; i < rows && rest != nullptr; ++i) {
            rest[3 * i] = ranges.rest_of(angles[0][i], numbers[3 * i]);
            rest[3 * i + 1] = angles[1].lo[i];
            rest[3 * i + 2] = ranges.rest_of(angles[2][i], numbers[3 * i + 2]);
        }
    }

    /// At least what a radian is.
    static double unit_size(const Spec& spec) noexcept { return spec.unit == AngleUnit::degrees ? 64.0 : 1.0; }

    /// How far the vectors of TurnVectors are turned at most, in the unit. With Q = |q|, at least 1/2, C^2 + S^2 = 2
    /// Q^2, and r = max(C, S)/min(C, S), so that 1/min(C, S) <= 2 r:
    ///
    /// A sum of two components is off by e = 2 off + 2^-95: by their errors, from the sum of their low parts, and from
    /// what it is cleaned of. A vector of length C S, a product, is turned by 1.5 e/C + 1.5 e/S <= 6 e r, and by 2^-96
    /// by what its own sums are cleaned of and its products rounded. The middle one is turned by less.
    ROTCONV_INLINE static double bound_of(const Spec& spec, double cosine, double sine, double off) noexcept {
        const double larger = larger_of(cosine, sine);
        const double smaller = -larger_of(-cosine, -sine);
        return unit_size(spec) * (12.0 * off + 0x1p-92) * (larger / smaller);
    }

    /// Of angles that are off by the bound and as much of themselves, as they are printed.
    ROTCONV_INLINE static void find_doubts(const Spec& spec, const AngleRanges& ranges,
                                           const Columns<DoubleDouble, 3>& angles, const double (&bound)[batch_rows],
                                           double relative, std::size_t rows, std::uint64_t* doubts) noexcept {
        for (unsigned k = 0; k < 3; ++k) {
            for (std::size_t i = 0; i < rows; ++i) {
                const DoubleDouble angle = angles[k][i];
                doubts[i] |= doubt_of(angle, bound[i] + relative * __builtin_fabs(angle.hi), k);
            }
        }
        for (unsigned k = 0; k < 3 && spec.positive; k += 2) {
            for (std::size_t i = 0; i < rows; ++i) {
                const DoubleDouble angle = angles[k][i];
                doubts[i] |= doubt_of(ranges.positive(angle), bound[i] + relative * __builtin_fabs(angle.hi), k);
            }
        }
    }

    /// In Approximate, whose sums and products are off by far less than the bound. angles_of() adds 2^-65 of the angle
    /// at most, degrees and whole turns 2^-102.
    template <class Axes> static void write_first_of(const Spec& spec, double lock_margin,
                                                     const AttitudeBatch<DoubleDouble>& attitudes, std::size_t rows,
                                                     double* numbers, std::uint64_t* doubts) noexcept {
        const Axes axes(spec.sequence);
        const LockLimit limit(lock_margin);
        const AngleRanges ranges(axes, spec);
        const Vectors<Approximate> vectors(axes, ranges, attitudes, rows);
        Columns<DoubleDouble, 3> angles;
        vectors.get_angles(spec, axes, ranges, rows, angles, numbers);
        const double unlocked = limit.locks_all ? __builtin_inf() : limit.tangent.hi + 0x1p-16; // nor nearly locked
        double bound[batch_rows];
        for (std::size_t i = 0; i < rows; ++i) {
            const double cosine = vectors.lengths[0].hi[i];
            const double sine = vectors.lengths[1].hi[i];
            const double larger = larger_of(cosine, sine);
            const double smaller = -larger_of(-cosine, -sine);
            doubts[i] |= smaller > unlocked * larger ? 0U : other_doubt; // of nan too
            bound[i] = bound_of(spec, cosine, sine, attitudes.off[i]);
        }
        find_doubts(spec, ranges, angles, bound, 0x1p-65, rows, doubts);
    }

    static void write_first(const Spec& spec, double lock_margin, const AttitudeBatch<DoubleDouble>& attitudes,
                            std::size_t rows, double* numbers, std::uint64_t* doubts) noexcept {
        spec.sequence.proper() ? write_first_of<AxesOfKind<true>>(spec, lock_margin, attitudes, rows, numbers, doubts)
                               : write_first_of<AxesOfKind<false>>(spec, lock_margin, attitudes, rows, numbers, doubts);
    }

    template <class T>
    static DiagnosticSet write_one(const Spec& spec, double lock_margin, const T (&q)[4], T* numbers) noexcept {
        const FixedAxes axes(spec.sequence);
        const AngleRanges ranges(axes, spec);
        const T own[4] = {q[0], q[1 + axes.i], q[1 + axes.j], q[1 + axes.k]};
        TurnVectors<T> vectors(axes, own);
        const Lock<T> lock(vectors.cosine_length, vectors.sine_length, LockLimit(lock_margin));
        if (lock.locked) {
            vectors.give_up_one(axes, own, lock.upper);
        } else if (ranges.is_other) {
            vectors.take_other();
        }
        const auto angle = [&](const Vector<T>& vector) { return angle_of(vector.x, vector.y, spec.unit); };
        const auto outer = [&](const Vector<T>& vector, std::size_t place) {
            const auto canonical = ranges.outer(scaled(angle(vector), spec.sequence.sign(place)));
            return rounded_to<T>(spec.positive ? ranges.positive(canonical) : canonical);
        };
        const auto middle = lock.locked ? Precise<T>(lock.upper ? ranges.upper : ranges.lower)
                                        : scaled(angle(vectors.middle), ranges.middle_factor);
        numbers[axes.places[0]] = outer(vectors.first, axes.places[0]);
        numbers[1] = rounded_to<T>(middle);
        numbers[axes.places[2]] = outer(vectors.last, axes.places[2]);
        return lock.diagnostics();
    }
};

constexpr Kernel kernel_of_angles() noexcept {
    Kernel kernel = kernel_of_formula<Angles>;
    if (ROTCONV_HAS_FMA != 0) { // elsewhere they gain nothing
        kernel.read_first = Angles::read_first;
        kernel.write_first = Angles::write_first;
    }
    kernel.least_plain_number = 0x1p-300; // the sines of three halves are multiplied, which are 2^-7 of degrees
    return kernel;
}

} // namespace

constinit const Kernel kernels::euler = kernel_of_angles();
constinit const Kernel kernels::rpy = kernel_of_angles();

} // namespace ROTCONV_TARGET
} // namespace rotconv
