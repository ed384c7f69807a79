#include "euler_formulas.hpp"
#include "kernel.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct Angles {
    template <class T>
    static void read(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
        const FixedAxes axes(spec.sequence);
        Column<DoubleDouble> half;
        const double half_signs[] = {0.5 * spec.sequence.sign(axes.places[0]), 0.5 * spec.sequence.sign(1),
                                     0.5 * spec.sequence.sign(axes.places[2])};
        Columns<T, 3> cosines;
        Columns<T, 3> sines;
        for (std::size_t i = 0; i < rows; ++i) {
            attitudes.error[i] = all_finite(numbers + 3 * i, 3) ? Error::none : Error::not_finite;
            attitudes.defect[i] = 0.0;
        }
        for (std::size_t turn = 0; turn < 3; ++turn) {
            for (std::size_t i = 0; i < rows; ++i) {
                half.set(i, half_signs[turn] * numbers[3 * i + axes.places[turn]]);
            }
            sine_cosine(half, rows, spec.unit, cosines[turn], sines[turn]);
        }
        Column<T>& w = attitudes.columns[0];
        Column<T>& along_i = attitudes.columns[1 + axes.i];
        Column<T>& along_j = attitudes.columns[1 + axes.j];
        Column<T>& along_k = attitudes.columns[1 + axes.k];
        for (std::size_t i = 0; i < rows; ++i) {
            const SineCosine<T> turns[3] = {
                {sines[0][i], cosines[0][i]}, {sines[1][i], cosines[1][i]}, {sines[2][i], cosines[2][i]}};
            T q[4];
            product_of_turns(axes, turns, q);
            w.set(i, q[0]);
            along_i.set(i, q[1]);
            along_j.set(i, q[2]);
            along_k.set(i, q[3]);
        }
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
        // All at once, by the functions of batches, whose vectors have room for four.
        Column<DoubleDouble> half;
        Column<double> cosine;
        Column<double> sine;
        for (std::size_t i = 0; i < 4; ++i) {
            half.set(i, i < 3 ? 0.5 * spec.sequence.sign(i) * numbers[i] : 0.0);
        }
        sine_cosine(half, 4, spec.unit, cosine, sine);
        read_by(
            spec,
            [&](std::size_t i) {
                return SineCosine<double>{sine[i], cosine[i]};
            },
            q);
        return all_finite(numbers, 3) ? Error::none : Error::not_finite;
    }

    static void read_carefully(const Spec& spec, const double* numbers, Careful (&q)[4]) noexcept {
        const auto half_angle = [&](std::size_t i) {
            return sine_cosine(Careful(spec.sequence.sign(i) * numbers[i]).shifted(-1), spec.unit);
        };
        read_by(spec, half_angle, q);
    }

    template <class T> static void write(const Spec& spec, double lock_margin, const AttitudeBatch<T>& attitudes,
                                         std::size_t rows, double* numbers, double* rest,
                                         DiagnosticSet* diagnostics) noexcept {
        const FixedAxes axes(spec.sequence);
        const LockLimit limit(lock_margin);
        // References: compilers do not vectorise access through an array of pointers.
        const Column<T>& w = attitudes.columns[0];
        const Column<T>& along_i = attitudes.columns[1 + axes.i];
        const Column<T>& along_j = attitudes.columns[1 + axes.j];
        const Column<T>& along_k = attitudes.columns[1 + axes.k];
        Columns<T, 2> first;
        Columns<T, 2> middle;
        Columns<T, 2> last;
        Columns<T, 2> lengths;
        const AngleRanges ranges(axes, spec);
        for (std::size_t i = 0; i < rows; ++i) {
            const T q[4] = {w[i], along_i[i], along_j[i], along_k[i]};
            const TurnVectors<T> vectors(axes, q);
            first.set(i, {vectors.first.x, vectors.first.y});
            middle.set(i, {vectors.middle.x, vectors.middle.y});
            last.set(i, {vectors.last.x, vectors.last.y});
            lengths.set(i, {vectors.cosine_length, vectors.sine_length});
        }
        for (std::size_t i = 0; i < rows && ranges.is_other; ++i) { // a loop of its own, for branches cost the vectors
            first.set(i, {-first[0][i], -first[1][i]});
            last.set(i, {-last[0][i], -last[1][i]});
        }
        bool upper[batch_rows];
        for (std::size_t i = 0; i < rows; ++i) {
            const Lock<T> lock(lengths[0][i], lengths[1][i], limit);
            diagnostics[i] = lock.diagnostics();
            upper[i] = lock.upper;
            if (lock.locked) {
                const T q[4] = {w[i], along_i[i], along_j[i], along_k[i]};
                TurnVectors<T> vectors(axes, q);
                vectors.give_up_one(axes, q);
                first.set(i, {vectors.first.x, vectors.first.y});
                last.set(i, {vectors.last.x, vectors.last.y});
            }
        }
        Columns<DoubleDouble, 3> angles;
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
        for (std::size_t i = 0; i < rows; ++i) {
            if (diagnostics[i].has(DiagnosticKind::gimbal_lock)) {
                angles[1].set(i, upper[i] ? ranges.upper : ranges.lower);
                numbers[3 * i + 1] = angles[1].hi[i];
            }
        }
        for (std::size_t i = 0; i < rows && rest != nullptr; ++i) {
            rest[3 * i] = ranges.rest_of(angles[0][i], numbers[3 * i]);
            rest[3 * i + 1] = angles[1].lo[i];
            rest[3 * i + 2] = ranges.rest_of(angles[2][i], numbers[3 * i + 2]);
        }
    }

    template <class T>
    static DiagnosticSet write_one(const Spec& spec, double lock_margin, const T (&q)[4], T* numbers) noexcept {
        const FixedAxes axes(spec.sequence);
        const AngleRanges ranges(axes, spec);
        const T own[4] = {q[0], q[1 + axes.i], q[1 + axes.j], q[1 + axes.k]};
        TurnVectors<T> vectors(axes, own);
        const Lock<T> lock(vectors.cosine_length, vectors.sine_length, LockLimit(lock_margin));
        if (lock.locked) {
            vectors.give_up_one(axes, own);
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

constexpr Kernel kernel_of_angles{.fast = {.read = Angles::read<double>, .write = Angles::write<double>},
                                  .exact = {.read = Angles::read<DoubleDouble>, .write = Angles::write<DoubleDouble>},
                                  .one = {.read = Angles::read_one, .write = Angles::write_one<double>},
                                  .careful = {.read = Angles::read_carefully, .write = Angles::write_one<Careful>}};

} // namespace

constinit const Kernel kernels::euler = kernel_of_angles;
constinit const Kernel kernels::rpy = kernel_of_angles;

} // namespace ROTCONV_TARGET
} // namespace rotconv
