#include "../numerics/power_of_two.hpp"
#include "euler_formulas.hpp"
#include "kernel.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

/// Where the angle of a fixed turn stands among the numbers.
ROTCONV_INLINE std::size_t place_of(const FixedAxes& axes, std::size_t turn) noexcept {
    return turn == 1 ? 1 : (turn == 0 ? axes.first_place : 2 - axes.first_place);
}

template <class T>
void read(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
    const FixedAxes axes(spec.sequence);
    Column<DoubleDouble> angles;
    Column<T> cosines[3];
    Column<T> sines[3];
    for (std::size_t i = 0; i < rows; ++i) {
        attitudes.error[i] = all_finite(numbers + 3 * i, 3) ? Error::none : Error::not_finite;
        attitudes.defect[i] = 0.0;
    }
    for (std::size_t turn = 0; turn < 3; ++turn) {
        const std::size_t place = place_of(axes, turn);
        for (std::size_t i = 0; i < rows; ++i) {
            angles.set(i, attitudes.error[i] == Error::none ? 0.5 * numbers[3 * i + place] : 0.0);
        }
        sine_cosine(angles, rows, spec.unit, cosines[turn], sines[turn]);
    }
    Column<T>* const along[] = {&attitudes.x, &attitudes.y, &attitudes.z};
    Column<T>& along_i = *along[axes.i];
    Column<T>& along_j = *along[axes.j];
    Column<T>& along_k = *along[axes.k];
    for (std::size_t i = 0; i < rows; ++i) {
        const SineCosine<T> turns[3] = {
            {sines[0][i], cosines[0][i]}, {sines[1][i], cosines[1][i]}, {sines[2][i], cosines[2][i]}};
        T q[4];
        product_of_turns(axes, turns, q);
        attitudes.w.set(i, q[0]);
        along_i.set(i, q[1]);
        along_j.set(i, q[2]);
        along_k.set(i, q[3]);
    }
}

/// `half_angle(i)`: the sine and cosine of half of the number i.
template <class T, class HalfAngle> void read_row(const Spec& spec, const HalfAngle& half_angle, T* q) noexcept {
    const FixedAxes axes(spec.sequence);
    const SineCosine<T> turns[3] = {half_angle(place_of(axes, 0)), half_angle(1), half_angle(place_of(axes, 2))};
    T product[4];
    product_of_turns(axes, turns, product);
    q[0] = product[0];
    q[1 + axes.i] = product[1];
    q[1 + axes.j] = product[2];
    q[1 + axes.k] = product[3];
}

Error read_one(const Spec& spec, const double* numbers, double* q, double& defect) noexcept {
    defect = 0.0;
    if (!all_finite(numbers, 3)) {
        return Error::not_finite;
    }
    read_row(
        spec, [&](std::size_t i) { return sine_cosine<double>(0.5 * numbers[i], spec.unit); }, q);
    return Error::none;
}

void read_carefully(const Spec& spec, const double* numbers, ScaledDoubleDouble* q) noexcept {
    read_row(
        spec, [&](std::size_t i) { return sine_cosine(ScaledDoubleDouble(numbers[i]).shifted(-1), spec.unit); }, q);
}

/// One of the vectors of each row.
template <class T> struct Vectors {
    Column<T> x, y;

    ROTCONV_INLINE void set(std::size_t row, const Vector<T>& vector) noexcept {
        x.set(row, vector.x);
        y.set(row, vector.y);
    }
};

template <class T> void write(const Spec& spec, double lock_margin, const AttitudeBatch<T>& attitudes, std::size_t rows,
                              double* numbers, double* rest, DiagnosticSet* diagnostics) noexcept {
    const FixedAxes axes(spec.sequence);
    const LockLimit limit(lock_margin);
    const Column<T>* const along[] = {&attitudes.x, &attitudes.y, &attitudes.z};
    const Column<T>& along_i = *along[axes.i];
    const Column<T>& along_j = *along[axes.j];
    const Column<T>& along_k = *along[axes.k];
    Vectors<T> first;
    Vectors<T> middle;
    Vectors<T> third;
    Column<T> cosine_length;
    Column<T> sine_length;
    for (std::size_t i = 0; i < rows; ++i) {
        const T q[4] = {attitudes.w[i], along_i[i], along_j[i], along_k[i]};
        const TurnVectors<T> vectors(axes, q);
        first.set(i, vectors.first);
        middle.set(i, vectors.middle);
        third.set(i, vectors.third);
        cosine_length.set(i, vectors.cosine_length);
        sine_length.set(i, vectors.sine_length);
    }
    bool upper[batch_rows];
    for (std::size_t i = 0; i < rows; ++i) {
        const Lock<T> lock(cosine_length[i], sine_length[i], limit);
        diagnostics[i] = lock.diagnostics();
        upper[i] = lock.upper;
        if (lock.locked) {
            const T q[4] = {attitudes.w[i], along_i[i], along_j[i], along_k[i]};
            TurnVectors<T> vectors(axes, q);
            vectors.give_up_one(axes, spec.sequence.intrinsic(), q);
            first.set(i, vectors.first);
            third.set(i, vectors.third);
        }
    }
    const AngleRanges ranges(axes, spec.unit);
    Column<DoubleDouble> angles[3];
    angles_of(first.x, first.y, rows, spec.unit, angles[place_of(axes, 0)]);
    angles_of(middle.x, middle.y, rows, spec.unit, angles[1]);
    angles_of(third.x, third.y, rows, spec.unit, angles[place_of(axes, 2)]);
    for (std::size_t i = 0; i < rows; ++i) {
        numbers[3 * i] = ranges.outer(angles[0].hi[i]);
        numbers[3 * i + 1] = ranges.middle_factor * angles[1].hi[i];
        numbers[3 * i + 2] = ranges.outer(angles[2].hi[i]);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (diagnostics[i].has(DiagnosticKind::gimbal_lock)) {
            numbers[3 * i + 1] = upper[i] ? ranges.upper.hi : ranges.lower.hi;
        }
    }
    for (std::size_t i = 0; i < rows && rest != nullptr; ++i) {
        const bool is_locked = diagnostics[i].has(DiagnosticKind::gimbal_lock);
        rest[3 * i] = ranges.rest_of(angles[0][i], numbers[3 * i]);
        rest[3 * i + 1] =
            is_locked ? (upper[i] ? ranges.upper.lo : ranges.lower.lo) : ranges.middle_factor * angles[1].lo[i];
        rest[3 * i + 2] = ranges.rest_of(angles[2][i], numbers[3 * i + 2]);
    }
}

template <class T> DiagnosticSet write_row(const Spec& spec, double lock_margin, const T* q, T* numbers) noexcept {
    const FixedAxes axes(spec.sequence);
    const T own[4] = {q[0], q[1 + axes.i], q[1 + axes.j], q[1 + axes.k]};
    TurnVectors<T> vectors(axes, own);
    const Lock<T> lock(vectors.cosine_length, vectors.sine_length, LockLimit(lock_margin));
    if (lock.locked) {
        vectors.give_up_one(axes, spec.sequence.intrinsic(), own);
    }
    const AngleRanges ranges(axes, spec.unit);
    const auto angle = [&](const Vector<T>& vector) { return angle_of(vector.x, vector.y, spec.unit); };
    const auto middle = lock.locked ? Precise<T>(lock.upper ? ranges.upper : ranges.lower)
                                    : scaled(angle(vectors.middle), ranges.middle_factor);
    numbers[place_of(axes, 0)] = narrowed<T>(ranges.outer(angle(vectors.first)));
    numbers[1] = narrowed<T>(middle);
    numbers[place_of(axes, 2)] = narrowed<T>(ranges.outer(angle(vectors.third)));
    return lock.diagnostics();
}

constexpr Kernel kernel_of_angles{.fast = {.read = read<double>, .write = write<double>},
                                  .exact = {.read = read<DoubleDouble>, .write = write<DoubleDouble>},
                                  .one = {.read = read_one, .write = write_row<double>},
                                  .careful = {.read = read_carefully, .write = write_row<ScaledDoubleDouble>}};

} // namespace

constinit const Kernel kernels::euler = kernel_of_angles;
constinit const Kernel kernels::rpy = kernel_of_angles;

} // namespace ROTCONV_TARGET
} // namespace rotconv
