#include "euler.hpp"

#include "codec.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

template <class T>
void read(const Spec& spec, const double* numbers, std::size_t rows, BasicReadings<T>& readings) noexcept {
    const FixedAxes axes(spec.sequence);
    Column<Real> angles;
    Column<T> cosines[3];
    Column<T> sines[3];
    for (std::size_t i = 0; i < rows; ++i) {
        const bool finite = all_finite(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
        readings.error[i] = finite ? Error::none : Error::not_finite;
        readings.defect[i] = 0.0;
    }
    for (std::size_t turn = 0; turn < 3; ++turn) {
        const std::size_t place = turn == 1 ? 1 : (turn == 0 ? axes.first_place : 2 - axes.first_place);
        for (std::size_t i = 0; i < rows; ++i) {
            angles.set(i, readings.error[i] == Error::none ? 0.5 * numbers[3 * i + place] : 0.0);
        }
        sine_cosine(angles, rows, spec.unit, cosines[turn], sines[turn]);
    }
    Column<T>* const along[] = {&readings.x, &readings.y, &readings.z};
    Column<T>& along_i = *along[axes.i];
    Column<T>& along_j = *along[axes.j];
    Column<T>& along_k = *along[axes.k];
    for (std::size_t i = 0; i < rows; ++i) {
        const SineCosine<T> turns[3] = {
            {sines[0][i], cosines[0][i]}, {sines[1][i], cosines[1][i]}, {sines[2][i], cosines[2][i]}};
        T q[4];
        product_of_turns(axes, turns, q);
        readings.w.set(i, q[0]);
        along_i.set(i, q[1]);
        along_j.set(i, q[2]);
        along_k.set(i, q[3]);
    }
}

/// One of the vectors of each row.
template <class T> struct Vectors {
    Column<T> x, y;

    ROTCONV_INLINE void set(std::size_t row, const Vector<T>& vector) noexcept {
        x.set(row, vector.x);
        y.set(row, vector.y);
    }
};

template <class T> void write(const Spec& spec, double lock_margin, const BasicRotations<T>& rotations,
                              std::size_t rows, double* numbers, DiagnosticSet* diagnostics) noexcept {
    const FixedAxes axes(spec.sequence);
    const double lock_tangent = tangent_of_half(lock_margin);
    const Column<T>* const along[] = {&rotations.x, &rotations.y, &rotations.z};
    const Column<T>& along_i = *along[axes.i];
    const Column<T>& along_j = *along[axes.j];
    const Column<T>& along_k = *along[axes.k];
    Vectors<T> first;
    Vectors<T> middle;
    Vectors<T> third;
    double sine_length[batch_rows];
    double cosine_length[batch_rows];
    for (std::size_t i = 0; i < rows; ++i) {
        const T q[4] = {rotations.w[i], along_i[i], along_j[i], along_k[i]};
        const TurnVectors<T> vectors(axes, q);
        first.set(i, vectors.first);
        middle.set(i, vectors.middle);
        third.set(i, vectors.third);
        cosine_length[i] = vectors.cosine_length;
        sine_length[i] = vectors.sine_length;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const Lock lock(cosine_length[i], sine_length[i], lock_tangent);
        diagnostics[i] = lock.diagnostics();
        if (lock.locked) {
            const T q[4] = {rotations.w[i], along_i[i], along_j[i], along_k[i]};
            TurnVectors<T> vectors(axes, q);
            vectors.give_up_one(axes, spec.sequence.intrinsic(), q);
            first.set(i, vectors.first);
            third.set(i, vectors.third);
        }
    }
    const AngleUnit unit = spec.unit;
    Column<Real> angles[3];
    angles_of(first.x, first.y, rows, unit, angles[axes.first_place]);
    angles_of(middle.x, middle.y, rows, unit, angles[1]);
    angles_of(third.x, third.y, rows, unit, angles[2 - axes.first_place]);
    const AngleRanges ranges(axes, unit);
    for (std::size_t i = 0; i < rows; ++i) {
        numbers[3 * i] = ranges.outer(angles[0].hi[i]);
        numbers[3 * i + 1] = ranges.middle_factor * angles[1].hi[i];
        numbers[3 * i + 2] = ranges.outer(angles[2].hi[i]);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (diagnostics[i].has(DiagnosticKind::gimbal_lock)) {
            numbers[3 * i + 1] = ranges.locked_middle(cosine_length[i] <= sine_length[i]);
        }
    }
}

Error read_one(const Spec& spec, const double* numbers, double* q) noexcept {
    if (!all_finite(numbers[0], numbers[1], numbers[2])) {
        return Error::not_finite;
    }
    const FixedAxes axes(spec.sequence);
    const SineCosine<double> turns[3] = {sine_cosine<double>(0.5 * numbers[axes.first_place], spec.unit),
                                         sine_cosine<double>(0.5 * numbers[1], spec.unit),
                                         sine_cosine<double>(0.5 * numbers[2 - axes.first_place], spec.unit)};
    double product[4];
    product_of_turns(axes, turns, product);
    q[0] = product[0];
    q[1 + axes.i] = product[1];
    q[1 + axes.j] = product[2];
    q[1 + axes.k] = product[3];
    return Error::none;
}

DiagnosticSet write_one(const Spec& spec, double lock_margin, const double* q, double* numbers) noexcept {
    const FixedAxes axes(spec.sequence);
    const double own[4] = {q[0], q[1 + axes.i], q[1 + axes.j], q[1 + axes.k]};
    TurnVectors<double> vectors(axes, own);
    const Lock lock(vectors.cosine_length, vectors.sine_length, tangent_of_half(lock_margin));
    if (lock.locked) {
        vectors.give_up_one(axes, spec.sequence.intrinsic(), own);
    }
    const AngleRanges ranges(axes, spec.unit);
    numbers[axes.first_place] = ranges.outer(angle_of(vectors.first.x, vectors.first.y, spec.unit).hi);
    numbers[1] = lock.locked ? ranges.locked_middle(vectors.cosine_length <= vectors.sine_length)
                             : ranges.middle_factor * angle_of(vectors.middle.x, vectors.middle.y, spec.unit).hi;
    numbers[2 - axes.first_place] = ranges.outer(angle_of(vectors.third.x, vectors.third.y, spec.unit).hi);
    return lock.diagnostics();
}

} // namespace

constinit const BatchCodec batch_codecs::euler{.fast = {.read = read<double>, .write = write<double>},
                                               .exact = {.read = read<Real>, .write = write<Real>},
                                               .one = {.read = read_one, .write = write_one}};
constinit const BatchCodec batch_codecs::rpy{.fast = {.read = read<double>, .write = write<double>},
                                             .exact = {.read = read<Real>, .write = write<Real>},
                                             .one = {.read = read_one, .write = write_one}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
