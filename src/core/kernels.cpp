#include "kernels.hpp"

#include <cstdint>

#include <rotconv/version.hpp>

#include "numerics/elementary.hpp"
#include "numerics/quaternion_algebra.hpp"
#include "representations/kernel.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

// NOLINTBEGIN(*-avoid-c-arrays): nothing inline of the standard library goes into sources of several targets

const Kernel& kernel_of(RepresentationId name) noexcept {
#define ROTCONV_LINE(id) &kernels::id,
    static constexpr const Kernel* table[] = {ROTCONV_REPRESENTATIONS(ROTCONV_LINE)};
#undef ROTCONV_LINE
    return *table[static_cast<std::size_t>(name)];
}

template <class T> const BatchKernel<T>& batch_kernel_of(RepresentationId name) noexcept {
    if constexpr (std::is_same_v<T, double>) {
        return kernel_of(name).fast;
    } else {
        return kernel_of(name).exact;
    }
}

// Functions of one attitude, in any scalar.

/// b q or q b.
template <class T> ROTCONV_INLINE void turn(const T (&by)[4], bool from_the_left, T (&q)[4]) noexcept {
    const T own[4] = {q[0], q[1], q[2], q[3]};
    multiply(from_the_left ? by : own, from_the_left ? own : by, q);
}
template <class T> ROTCONV_INLINE void turn(const ExactQuaternion& by, bool from_the_left, T (&q)[4]) noexcept {
    T constant[4];
    for (std::size_t k = 0; k < 4; ++k) {
        constant[k] = rounded_to<T>(DoubleDouble(by.hi[k], by.lo[k]));
    }
    turn(constant, from_the_left, q);
}
/// By what there may be.
template <class T> ROTCONV_INLINE void turn(const Turns& by, T (&q)[4]) noexcept {
    if (by.has_left) {
        turn(by.left, true, q);
    }
    if (by.has_right) {
        turn(by.right, false, q);
    }
}
/// R_REF' R.
template <class T> ROTCONV_INLINE void relate(const T (&reference)[4], T (&q)[4]) noexcept {
    turn({-reference[0], reference[1], reference[2], reference[3]}, true, q);
}

template <class T> ROTCONV_INLINE void rotate(const T (&q)[4], const Given<T> (&vector)[3], T (&rotated)[3]) noexcept {
    T m[9];
    scaled_matrix_of(q, m);
    for (std::size_t k = 0; k < 3; ++k) {
        rotated[k] = (m[3 * k] * vector[0] + m[3 * k + 1] * vector[1]) + m[3 * k + 2] * vector[2];
    }
    divide(rotated, squared_norm(q));
}

// Functions of a batch.

template <class T> void turn(const Turns& by, AttitudeBatch<T>& attitudes, std::size_t rows) noexcept {
    for (std::size_t i = 0; i < rows && (by.has_left || by.has_right); ++i) {
        T q[4];
        attitudes.get(i, q);
        turn(by, q);
        attitudes.set(i, q);
    }
}

template <class T> void invert_if(bool inverse, AttitudeBatch<T>& attitudes, std::size_t rows) noexcept {
    for (std::size_t i = 0; i < rows && inverse; ++i) {
        attitudes[0].set(i, -attitudes[0][i]);
    }
}

/// R_REF' R.
void relate(const AttitudeBatch<double>& attitudes, const AttitudeBatch<double>& references, std::size_t rows,
            AttitudeBatch<double>& relative) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        double q[4];
        double reference[4];
        attitudes.get(i, q);
        references.get(i, reference);
        relate(reference, q);
        relative.set(i, q);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        relative.error[i] = attitudes.error[i] != Error::none ? attitudes.error[i] : references.error[i];
    }
}

template <class T>
void round(const AttitudeBatch<T>& attitudes, std::size_t rows, AttitudeBatch<double>& rounded) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            rounded[k].set(i, attitudes[k].hi[i]);
        }
        rounded.defect[i] = attitudes.defect[i];
        rounded.error[i] = attitudes.error[i];
    }
}

/// Lets a turn that but moves and negates axes do so to matrices, or to those whose inverses it turns. No other turn.
bool move_axes(const Spec& spec, const ExactQuaternion& by, bool from_the_left, bool inverse, const double*& in,
               std::size_t rows, double* out) noexcept {
    double m[9];
    scaled_matrix_of({inverse ? -by.hi[0] : by.hi[0], by.hi[1], by.hi[2], by.hi[3]}, m);
    const double norm = squared_norm(by.hi);
    bool moves = spec.name == RepresentationId::dcm && largest_magnitude(by.lo[0], by.lo[1], by.lo[2], by.lo[3]) == 0.0;
    for (double& entry : m) {
        moves = moves && (entry == 0.0 || __builtin_fabs(entry) == norm);
        entry /= norm;
    }
    for (std::size_t k = 0; k < 9 * rows && moves; ++k) {
        const double* const a = in + k / 9 * 9;
        const std::size_t i = k % 9 / 3 * 3;
        const std::size_t j = k % 3;
        out[k] = from_the_left != inverse ? (m[i] * a[j] + m[i + 1] * a[3 + j]) + m[i + 2] * a[6 + j]
                                          : (a[i] * m[j] + a[i + 1] * m[3 + j]) + a[i + 2] * m[6 + j];
    }
    in = moves ? out : in;
    return moves;
}
/// What is left of the turns when matrices have taken those that they take without a sum, which would cost small
/// numbers digits.
Turns move_axes(const Spec& spec, bool inverse, Turns turns, const double*& in, std::size_t rows,
                double (&moved)[2][9 * batch_rows]) noexcept {
    turns.has_left = turns.has_left && !move_axes(spec, turns.left, true, inverse, in, rows, moved[0]);
    turns.has_right = turns.has_right && !move_axes(spec, turns.right, false, inverse, in, rows, moved[1]);
    return turns;
}

// Rows that the batch kernels do not serve, because a number or the attitude that came of them is not plain.

bool all_plain_numbers(const Spec& spec, const double* numbers, std::size_t rows, bool exactly) noexcept {
    const Kernel& kernel = kernel_of(spec.name);
    const double least = exactly ? kernel.least_plain_number : 0x1p-112;
    return kernel.reading_is_exact ||
           all(numbers, rows * spec.size(), [least](double number) { return is_plain_number(number, least); });
}

template <class T> bool all_plain(const AttitudeBatch<T>& attitudes, std::size_t first, std::size_t rows) noexcept {
    const auto is_plain = [&](std::size_t k) { return all(attitudes[k].hi + first, rows, is_plain_component); };
    return is_plain(0) && is_plain(1) && is_plain(2) && is_plain(3);
}

/// Calls careful(i) for each row without error that is one of them.
template <class T, class Function> void for_each_careful_row(const Spec& spec, const double* numbers,
                                                             const AttitudeBatch<T>& attitudes, std::size_t rows,
                                                             const Function& careful, bool exactly = true) noexcept {
    if (all_plain(attitudes, 0, rows) && all_plain_numbers(spec, numbers, rows, exactly)) {
        return;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (attitudes.error[i] == Error::none &&
            !(all_plain(attitudes, i, 1) && all_plain_numbers(spec, numbers + i * spec.size(), 1, exactly))) {
            careful(i);
        }
    }
}

/// The attitude of a row, or its inverse, turned; its largest component was of size 1/2 to 1.
void read_carefully(const Spec& spec, const double* numbers, bool inverse, const Turns& turns,
                    Careful (&q)[4]) noexcept {
    kernel_of(spec.name).careful.read(spec, numbers, q);
    int largest = q[0].exponent();
    for (const Careful& component : q) {
        largest = component.exponent() > largest ? component.exponent() : largest;
    }
    for (Careful& component : q) {
        component = component.shifted(-1 - largest);
    }
    q[0] = inverse ? -q[0] : q[0];
    turn(turns, q);
}

DiagnosticSet write_carefully(const Spec& spec, double lock_margin, const Careful (&q)[4], double* numbers,
                              double* rest) noexcept {
    Careful results[most_numbers];
    const DiagnosticSet diagnostics = kernel_of(spec.name).careful.write(spec, lock_margin, q, results);
    for (std::size_t k = 0; k < spec.size(); ++k) {
        const DoubleDouble parts = results[k].rounded_parts();
        numbers[k] = parts.hi;
        if (rest != nullptr) {
            rest[k] = parts.lo;
        }
    }
    return diagnostics;
}

void set_rounded(const Careful (&q)[4], std::size_t row, AttitudeBatch<double>& attitudes) noexcept {
    attitudes.set(row, {q[0].rounded(), q[1].rounded(), q[2].rounded(), q[3].rounded()});
}

// The functions of the table.

/// The attitudes of plain rows, or their inverses, turned. Of matrices whose axes were moved `numbers` become those;
/// returns the turns that are left.
template <class T> Turns read_plainly(const Spec& spec, bool inverse, const Turns& all, const double*& numbers,
                                      std::size_t rows, double (&moved)[2][9 * batch_rows],
                                      AttitudeBatch<T>& attitudes) noexcept {
    const Turns turns = move_axes(spec, inverse, all, numbers, rows, moved);
    batch_kernel_of<T>(spec.name).read(spec, numbers, rows, attitudes);
    invert_if(inverse, attitudes, rows);
    turn(turns, attitudes, rows);
    return turns;
}

/// The row i, turned by `turns`.
void convert_carefully(const ConversionBatch& batch, const Turns& turns, const double* in, std::size_t i,
                       AttitudeBatch<double>& rounded, double* out, double* rest, DiagnosticSet* diagnostics) noexcept {
    const Spec& from = *batch.from;
    const Spec& to = *batch.to;
    Careful q[4];
    read_carefully(from, in + i * from.size(), from.passive != to.passive, turns, q);
    diagnostics[i] = write_carefully(to, batch.lock_margin, q, out + i * to.size(),
                                     rest == nullptr ? nullptr : rest + i * to.size());
    set_rounded(q, i, rounded);
}

template <class T> void convert(const ConversionBatch& batch, const double* in, std::size_t rows,
                                AttitudeBatch<double>& rounded, double* out, double* rest,
                                DiagnosticSet* diagnostics) noexcept {
    const Spec& from = *batch.from;
    const Spec& to = *batch.to;
    const bool inverse = from.passive != to.passive;
    double moved[2][9 * batch_rows];
    AttitudeBatch<T> attitudes;
    const Turns turns = read_plainly(from, inverse, *batch.turns, in, rows, moved, attitudes);
    batch_kernel_of<T>(to.name).write(to, batch.lock_margin, attitudes, rows, out, rest, diagnostics);
    round(attitudes, rows, rounded);
    const auto careful = [&](std::size_t i) {
        if (to.name != RepresentationId::quat || !keeps_bits(attitudes, i)) {
            convert_carefully(batch, turns, in, i, rounded, out, rest, diagnostics);
        }
    };
    for_each_careful_row(from, in, attitudes, rows, careful, !std::is_same_v<T, double>);
}

bool convert_first(const ConversionBatch& batch, const double* in, std::size_t rows, AttitudeBatch<double>& rounded,
                   double* out, DiagnosticSet* diagnostics, bool* open) noexcept {
    const Spec& from = *batch.from;
    const Spec& to = *batch.to;
    const bool inverse = from.passive != to.passive;
    Turns turns = *batch.turns;
    const auto careful = [&](std::size_t i) {
        convert_carefully(batch, turns, in, i, rounded, out, nullptr, diagnostics);
        open[i] = false;
    };
    const auto read_first = kernel_of(from.name).read_first;
    if (to.name == RepresentationId::quat && read_first != nullptr && !turns.has_left && !turns.has_right) {
        read_first(from, in, rows, rounded, open);
        invert_if(inverse, rounded, rows);
        for (std::size_t i = 0; i < rows; ++i) {
            double q[4];
            rounded.get(i, q);
            const double sign = canonical_sign(q);
            for (std::size_t k = 0; k < 4; ++k) {
                out[4 * i + k] = sign * q[k];
            }
        }
        for_each_careful_row(from, in, rounded, rows, careful);
        return true;
    }
    const auto write_first = kernel_of(to.name).write_first;
    if (write_first == nullptr) {
        return false;
    }
    double moved[2][9 * batch_rows];
    AttitudeBatch<DoubleDouble> attitudes;
    turns = read_plainly(from, inverse, turns, in, rows, moved, attitudes);
    write_first(to, batch.lock_margin, attitudes, rows, out, open);
    round(attitudes, rows, rounded);
    for_each_careful_row(from, in, attitudes, rows, careful);
    return true;
}

/// The rows that the first phase leaves open, together.
void convert_in_phases(const ConversionBatch& batch, const double* in, std::size_t rows, AttitudeBatch<double>& rounded,
                       double* out, double* rest, DiagnosticSet* diagnostics) noexcept {
    bool open[batch_rows];
    if (rest != nullptr || !convert_first(batch, in, rows, rounded, out, diagnostics, open)) {
        convert<DoubleDouble>(batch, in, rows, rounded, out, rest, diagnostics);
        return;
    }
    const std::size_t from_size = batch.from->size();
    const std::size_t to_size = batch.to->size();
    std::size_t places[batch_rows + 1];
    std::size_t count = 0;
    for (std::size_t i = 0; i < rows; ++i) {
        places[count] = i;
        count += open[i] && rounded.error[i] == Error::none ? 1U : 0U;
    }
    if (count == 0) {
        return;
    }
    double numbers[most_numbers * batch_rows];
    double results[most_numbers * batch_rows];
    AttitudeBatch<double> attitudes;
    DiagnosticSet found[batch_rows];
    for (std::size_t k = 0; k < count * from_size; ++k) {
        numbers[k] = in[places[k / from_size] * from_size + k % from_size];
    }
    convert<DoubleDouble>(batch, numbers, count, attitudes, results, nullptr, found);
    for (std::size_t k = 0; k < count * to_size; ++k) {
        out[places[k / to_size] * to_size + k % to_size] = results[k];
    }
    for (std::size_t k = 0; k < count; ++k) {
        double q[4];
        attitudes.get(k, q);
        rounded.set(places[k], q);
        diagnostics[places[k]] = found[k];
    }
}

/// The attitudes that rows describe, turned, to 106 bits.
void read_upright(const Spec& spec, const Turns& all, const double* numbers, std::size_t rows,
                  AttitudeBatch<DoubleDouble>& attitudes) noexcept {
    double moved[2][9 * batch_rows];
    const Turns turns = read_plainly(spec, spec.passive, all, numbers, rows, moved, attitudes);
    for_each_careful_row(spec, numbers, attitudes, rows, [&](std::size_t i) {
        Careful q[4];
        read_carefully(spec, numbers + i * spec.size(), spec.passive, turns, q);
        attitudes.set(i, {q[0].rounded_parts(), q[1].rounded_parts(), q[2].rounded_parts(), q[3].rounded_parts()});
    });
}

void read(const Spec& spec, const Turns& turns, const double* numbers, std::size_t rows,
          AttitudeBatch<double>& rounded) noexcept {
    AttitudeBatch<DoubleDouble> attitudes;
    read_upright(spec, turns, numbers, rows, attitudes);
    round(attitudes, rows, rounded);
}

void read_exactly(const Spec& spec, const double* numbers, ExactQuaternion& attitude) noexcept {
    AttitudeBatch<DoubleDouble> attitudes;
    read_upright(spec, no_turns, numbers, 1, attitudes);
    for (std::size_t k = 0; k < 4; ++k) {
        attitude.hi[k] = attitudes[k].hi[0];
        attitude.lo[k] = attitudes[k].lo[0];
    }
}

void relate_rounded(const AttitudeBatch<double>& attitudes, const AttitudeBatch<double>& references, std::size_t rows,
                    AttitudeBatch<double>& relative, double* angles) noexcept {
    relate(attitudes, references, rows, relative);
    const bool are_plain = all_plain(attitudes, 0, rows) && all_plain(references, 0, rows);
    for (std::size_t i = 0; i < rows && !are_plain; ++i) {
        if (!all_plain(attitudes, i, 1) || !all_plain(references, i, 1)) {
            Careful q[4] = {attitudes[0][i], attitudes[1][i], attitudes[2][i], attitudes[3][i]};
            const Careful other[4] = {references[0][i], references[1][i], references[2][i], references[3][i]};
            relate(other, q);
            set_rounded(q, i, relative);
        }
    }
    Column<double> scalars;
    Column<double> lengths;
    Column<DoubleDouble> halves;
    const auto& [w, x, y, z] = relative.columns;
    for (std::size_t i = 0; i < rows; ++i) {
        scalars.set(i, __builtin_fabs(w[i]));
        lengths.set(i, __builtin_sqrt((x[i] * x[i] + y[i] * y[i]) + z[i] * z[i]));
    }
    angles_of(scalars, lengths, rows, AngleUnit::radians, halves);
    for (std::size_t i = 0; i < rows; ++i) {
        angles[i] = 2.0 * halves.hi[i];
    }
}

void multiply(const ProductBatch& batch, const double* first, const double* second, std::size_t rows,
              AttitudeBatch<double>* const (&rounded)[3], double* out, double* rest,
              DiagnosticSet* diagnostics) noexcept {
    const Spec& to = *batch.to;
    AttitudeBatch<DoubleDouble> attitudes[3];
    auto& [left, right, product] = attitudes;
    read_upright(*batch.first, *batch.turns, first, rows, left);
    read_upright(*batch.second, no_turns, second, rows, right);
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble q[4];
        DoubleDouble other[4];
        left.get(i, q);
        right.get(i, other);
        turn(other, false, q);
        product.set(i, q);
        product.defect[i] = 0.0;
        product.error[i] = left.error[i] != Error::none ? left.error[i] : right.error[i];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        round(attitudes[k], rows, *rounded[k]);
    }
    invert_if(to.passive, product, rows);
    kernel_of(to.name).exact.write(to, batch.lock_margin, product, rows, out, rest, diagnostics);
    const auto careful = [&](std::size_t i) {
        Careful q[4];
        Careful other[4];
        read_carefully(*batch.first, first + i * batch.first->size(), batch.first->passive, *batch.turns, q);
        read_carefully(*batch.second, second + i * batch.second->size(), batch.second->passive, no_turns, other);
        turn(other, false, q);
        set_rounded(q, i, *rounded[2]);
        q[0] = to.passive ? -q[0] : q[0];
        diagnostics[i] = write_carefully(to, batch.lock_margin, q, out + i * to.size(),
                                         rest == nullptr ? nullptr : rest + i * to.size());
    };
    for_each_careful_row(*batch.first, first, product, rows, careful);
    for_each_careful_row(*batch.second, second, product, rows, careful);
}

void rotate(const Spec& spec, const double* numbers, const double* vectors, std::size_t rows,
            AttitudeBatch<double>& rounded, double* out) noexcept {
    AttitudeBatch<DoubleDouble> attitudes;
    read_upright(spec, no_turns, numbers, rows, attitudes);
    round(attitudes, rows, rounded);
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble q[4];
        DoubleDouble rotated[3];
        double vector[3];
        attitudes.get(i, q);
        take(vectors + 3 * i, vector);
        rotate(q, vector, rotated);
        for (std::size_t k = 0; k < 3; ++k) {
            out[3 * i + k] = rotated[k].hi;
        }
    }
    const auto careful = [&](std::size_t i) {
        Careful q[4];
        Careful rotated[3];
        Careful vector[3];
        read_carefully(spec, numbers + i * spec.size(), spec.passive, no_turns, q);
        take(vectors + 3 * i, vector);
        rotate(q, vector, rotated);
        for (std::size_t k = 0; k < 3; ++k) {
            out[3 * i + k] = rotated[k].rounded();
        }
    };
    for_each_careful_row(spec, numbers, attitudes, rows, careful);
    for (std::size_t i = 0; i < rows; ++i) {
        if (!all(vectors + 3 * i, 3, [](double number) { return is_plain_number(number); }) &&
            all_finite(vectors + 3 * i, 3) && attitudes.error[i] == Error::none) {
            careful(i);
        }
    }
}

Error read_one(const Spec& spec, const double* numbers, double (&q)[4], double& defect) noexcept {
    const Error error = kernel_of(spec.name).one.read(spec, numbers, q, defect);
    if (error == Error::none && !all_plain_numbers(spec, numbers, 1, false)) [[unlikely]] {
        Careful careful[4];
        read_carefully(spec, numbers, false, no_turns, careful);
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = careful[k].rounded();
        }
    }
    return error;
}

DiagnosticSet write_one(const Spec& spec, double lock_margin, const double (&q)[4], double* numbers) noexcept {
    if (!all(q, 4, is_plain_component)) [[unlikely]] {
        return write_carefully(spec, lock_margin, {q[0], q[1], q[2], q[3]}, numbers, nullptr);
    }
    return kernel_of(spec.name).one.write(spec, lock_margin, q, numbers);
}

// NOLINTEND(*-avoid-c-arrays)

} // namespace
} // namespace ROTCONV_TARGET

#define ROTCONV_KERNELS_OF(target) ROTCONV_JOINED(kernels_of_, target)
#define ROTCONV_JOINED(a, b) a##b

extern const KernelTable ROTCONV_KERNELS_OF(ROTCONV_TARGET);
constinit const KernelTable ROTCONV_KERNELS_OF(ROTCONV_TARGET){.target = ROTCONV_DETAIL_TEXT(ROTCONV_TARGET),
                                                               .convert = convert_in_phases,
                                                               .convert_first = convert_first,
                                                               .convert_fast = convert<double>,
                                                               .read = read,
                                                               .relate = relate_rounded,
                                                               .multiply = multiply,
                                                               .rotate = rotate,
                                                               .read_exactly = read_exactly,
                                                               .read_one = read_one,
                                                               .write_one = write_one};

} // namespace rotconv
