#include "kernels.hpp"

#include <rotconv/version.hpp>

#include "careful_rows.hpp"
#include "numerics/elementary.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

// Functions of a batch.

template <class T> void multiply_by(const FixedRotations& by, AttitudeBatch<T>& attitudes, std::size_t rows) noexcept {
    for (std::size_t i = 0; i < rows && (by.has_left || by.has_right); ++i) {
        T q[4];
        attitudes.get(i, q);
        multiply_by(by, q);
        attitudes.set(i, q);
    }
}

template <class T> void invert_if(bool inverse, AttitudeBatch<T>& attitudes, std::size_t rows) noexcept {
    for (std::size_t i = 0; i < rows && inverse; ++i) {
        attitudes[0].set(i, -attitudes[0][i]);
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

// The functions of the table.

/// The attitudes of plain rows, or their inverses, between the fixed rotations.
template <class T> void read_plainly(const Spec& spec, bool inverse, const FixedRotations& all, const double* numbers,
                                     std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
    double moved[2][9 * batch_rows];
    const FixedRotations fixed = move_axes(spec, inverse, all, numbers, rows, moved);
    batch_kernel_of<T>(spec.name).read(spec, numbers, rows, attitudes);
    invert_if(inverse, attitudes, rows);
    multiply_by(fixed, attitudes, rows);
}

template <class T> void convert_plainly(const ConversionBatch& batch, const double* in, std::size_t rows,
                                        AttitudeBatch<T>& attitudes, double* out, double* rest,
                                        DiagnosticSet* diagnostics) noexcept {
    const Spec& from = *batch.from;
    const Spec& to = *batch.to;
    read_plainly(from, from.passive != to.passive, *batch.fixed, in, rows, attitudes);
    batch_kernel_of<T>(to.name).write(to, batch.lock_margin, attitudes, rows, out, rest, diagnostics);
}

/// One row.
void convert_carefully(const ConversionBatch& batch, const double* in, std::size_t i, AttitudeBatch<double>& rounded,
                       double* out, double* rest, DiagnosticSet* diagnostics) noexcept {
    const Spec& from = *batch.from;
    const Spec& to = *batch.to;
    Careful q[4];
    read_carefully(from, in + i * from.size(), from.passive != to.passive, *batch.fixed, q);
    diagnostics[i] = write_carefully(to, batch.lock_margin, q, out, rest, i);
    set_rounded(q, i, rounded);
}

/// Converts to 106 bits the rows that are open and have no error, the plain ones together.
void convert_open(const ConversionBatch& batch, const double* in, std::size_t rows, const bool* open,
                  AttitudeBatch<double>& rounded, double* out, DiagnosticSet* diagnostics) noexcept {
    const Spec& from = *batch.from;
    const std::size_t from_size = from.size();
    const std::size_t to_size = batch.to->size();
    std::size_t count = 0;
    std::size_t places[batch_rows];
    double numbers[most_numbers * batch_rows];
    for (std::size_t i = 0; i < rows; ++i) {
        if (!open[i] || rounded.error[i] != Error::none) {
            continue;
        }
        const double* const own = in + i * from_size;
        if (!(all_plain(rounded, i, 1) && all_plain_numbers(from, own, 1, true))) {
            convert_carefully(batch, in, i, rounded, out, nullptr, diagnostics);
            continue;
        }
        for (std::size_t k = 0; k < from_size; ++k) {
            numbers[count * from_size + k] = own[k];
        }
        places[count++] = i;
    }
    if (count == 0) {
        return;
    }
    double results[most_numbers * batch_rows];
    AttitudeBatch<DoubleDouble> attitudes;
    DiagnosticSet found[batch_rows];
    convert_plainly(batch, numbers, count, attitudes, results, nullptr, found);
    for (std::size_t n = 0; n < count; ++n) {
        const std::size_t i = places[n];
        for (std::size_t k = 0; k < to_size; ++k) {
            out[i * to_size + k] = results[n * to_size + k];
        }
        rounded.set(i, {attitudes[0].hi[n], attitudes[1].hi[n], attitudes[2].hi[n], attitudes[3].hi[n]});
        diagnostics[i] = found[n];
    }
}

template <class T> void convert(const ConversionBatch& batch, const double* in, std::size_t rows,
                                AttitudeBatch<double>& rounded, double* out, double* rest,
                                DiagnosticSet* diagnostics) noexcept {
    AttitudeBatch<T> attitudes;
    convert_plainly(batch, in, rows, attitudes, out, rest, diagnostics);
    round(attitudes, rows, rounded);
    const auto careful = [&](std::size_t i) {
        if (batch.to->name != RepresentationId::quat || !keeps_bits(attitudes, i)) {
            convert_carefully(batch, in, i, rounded, out, rest, diagnostics);
        }
    };
    for_each_careful_row(*batch.from, in, attitudes, rows, careful, !std::is_same_v<T, double>);
}

bool convert_first(const ConversionBatch& batch, const double* in, std::size_t rows, AttitudeBatch<double>& rounded,
                   double* out, bool* open) noexcept {
    const Spec& from = *batch.from;
    const Spec& to = *batch.to;
    const bool inverse = from.passive != to.passive;
    const auto set_open = [open](std::size_t i) { open[i] = true; };
    const auto read_first = kernel_of(from.name).read_first;
    if (to.name == RepresentationId::quat && read_first != nullptr && !batch.fixed->has_left &&
        !batch.fixed->has_right) {
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
        for_each_careful_row(from, in, rounded, rows, set_open);
        return true;
    }
    const auto write_first = kernel_of(to.name).write_first;
    if (write_first == nullptr) {
        return false;
    }
    AttitudeBatch<DoubleDouble> attitudes;
    read_plainly(from, inverse, *batch.fixed, in, rows, attitudes);
    write_first(to, batch.lock_margin, attitudes, rows, out, open);
    round(attitudes, rows, rounded);
    for_each_careful_row(from, in, attitudes, rows, set_open);
    return true;
}

/// The rows that the first phase leaves open, together.
void convert_in_phases(const ConversionBatch& batch, const double* in, std::size_t rows, AttitudeBatch<double>& rounded,
                       double* out, double* rest, DiagnosticSet* diagnostics) noexcept {
    bool open[batch_rows];
    if (rest != nullptr || !convert_first(batch, in, rows, rounded, out, open)) {
        convert<DoubleDouble>(batch, in, rows, rounded, out, rest, diagnostics);
    } else {
        convert_open(batch, in, rows, open, rounded, out, diagnostics);
    }
}

/// The attitudes that rows describe, between the fixed rotations, to 106 bits.
void read_upright(const Spec& spec, const FixedRotations& fixed, const double* numbers, std::size_t rows,
                  AttitudeBatch<DoubleDouble>& attitudes) noexcept {
    read_plainly(spec, spec.passive, fixed, numbers, rows, attitudes);
    for_each_careful_row(spec, numbers, attitudes, rows, [&](std::size_t i) {
        Careful q[4];
        read_carefully(spec, numbers + i * spec.size(), spec.passive, fixed, q);
        attitudes.set(i, {q[0].rounded_parts(), q[1].rounded_parts(), q[2].rounded_parts(), q[3].rounded_parts()});
    });
}

void read(const Spec& spec, const FixedRotations& fixed, const double* numbers, std::size_t rows,
          AttitudeBatch<double>& rounded) noexcept {
    AttitudeBatch<DoubleDouble> attitudes;
    read_upright(spec, fixed, numbers, rows, attitudes);
    round(attitudes, rows, rounded);
}

void read_exactly(const Spec& spec, const double* numbers, ExactQuaternion& attitude) noexcept {
    AttitudeBatch<DoubleDouble> attitudes;
    read_upright(spec, no_rotations, numbers, 1, attitudes);
    for (std::size_t k = 0; k < 4; ++k) {
        attitude.hi[k] = attitudes[k].hi[0];
        attitude.lo[k] = attitudes[k].lo[0];
    }
}

void relate_rounded(const AttitudeBatch<double>& attitudes, const AttitudeBatch<double>& references, std::size_t rows,
                    AttitudeBatch<double>& relative, double* angles) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        double q[4];
        double reference[4];
        attitudes.get(i, q);
        references.get(i, reference);
        make_relative(reference, q);
        relative.set(i, q);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        relative.error[i] = attitudes.error[i] != Error::none ? attitudes.error[i] : references.error[i];
    }
    const bool are_plain = all_plain(attitudes, 0, rows) && all_plain(references, 0, rows);
    for (std::size_t i = 0; i < rows && !are_plain; ++i) {
        if (!all_plain(attitudes, i, 1) || !all_plain(references, i, 1)) {
            Careful q[4] = {attitudes[0][i], attitudes[1][i], attitudes[2][i], attitudes[3][i]};
            const Careful other[4] = {references[0][i], references[1][i], references[2][i], references[3][i]};
            make_relative(other, q);
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
    read_upright(*batch.first, *batch.fixed, first, rows, left);
    read_upright(*batch.second, no_rotations, second, rows, right);
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble q[4];
        DoubleDouble other[4];
        left.get(i, q);
        right.get(i, other);
        multiply_from_side(other, false, q);
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
        read_carefully(*batch.first, first + i * batch.first->size(), batch.first->passive, *batch.fixed, q);
        read_carefully(*batch.second, second + i * batch.second->size(), batch.second->passive, no_rotations, other);
        multiply_from_side(other, false, q);
        set_rounded(q, i, *rounded[2]);
        q[0] = to.passive ? -q[0] : q[0];
        diagnostics[i] = write_carefully(to, batch.lock_margin, q, out, rest, i);
    };
    for_each_careful_row(*batch.first, first, product, rows, careful);
    for_each_careful_row(*batch.second, second, product, rows, careful);
}

void rotate(const Spec& spec, const double* numbers, const double* vectors, std::size_t rows,
            AttitudeBatch<double>& rounded, double* out) noexcept {
    AttitudeBatch<DoubleDouble> attitudes;
    read_upright(spec, no_rotations, numbers, rows, attitudes);
    round(attitudes, rows, rounded);
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble q[4];
        DoubleDouble rotated[3];
        double vector[3];
        attitudes.get(i, q);
        take(vectors + 3 * i, vector);
        rotate_vector(q, vector, rotated);
        put(rotated, out + 3 * i);
    }
    const auto careful = [&](std::size_t i) {
        Careful q[4];
        Careful rotated[3];
        Careful vector[3];
        read_carefully(spec, numbers + i * spec.size(), spec.passive, no_rotations, q);
        take(vectors + 3 * i, vector);
        rotate_vector(q, vector, rotated);
        put(rotated, out + 3 * i);
    };
    for_each_careful_row(spec, numbers, attitudes, rows, careful);
    for (std::size_t i = 0; i < rows; ++i) {
        if (!all(vectors + 3 * i, 3, [](double number) { return is_plain_number(number); }) &&
            all_finite(vectors + 3 * i, 3) && attitudes.error[i] == Error::none) {
            careful(i);
        }
    }
}

ROTCONV_NOINLINE Error read_one_carefully(const Spec& spec, const double* numbers, double (&q)[4],
                                          double& defect) noexcept {
    const Error error = kernel_of(spec.name).one.read(spec, numbers, q, defect);
    if (error == Error::none) {
        Careful careful[4];
        read_carefully(spec, numbers, false, no_rotations, careful);
        take(careful, q);
    }
    return error;
}

Error read_one(const Spec& spec, const double* numbers, double (&q)[4], double& defect) noexcept {
    const Kernel& kernel = kernel_of(spec.name);
    const auto is_plain = [](const double& number) { return is_plain_number(alone(number)); };
    if (!(kernel.reading_is_exact || all(numbers, kernel.size, is_plain))) [[unlikely]] {
        return read_one_carefully(spec, numbers, q, defect);
    }
    return kernel.one.read(spec, numbers, q, defect);
}

ROTCONV_NOINLINE DiagnosticSet write_one_carefully(const Spec& spec, double lock_margin, const double (&q)[4],
                                                   double* numbers) noexcept {
    return write_carefully(spec, lock_margin, {q[0], q[1], q[2], q[3]}, numbers, nullptr, 0);
}

DiagnosticSet write_one(const Spec& spec, double lock_margin, const double (&q)[4], double* numbers) noexcept {
    if (!(is_plain_component(alone(q[0])) && is_plain_component(alone(q[1])) && is_plain_component(alone(q[2])) &&
          is_plain_component(alone(q[3])))) [[unlikely]] {
        return write_one_carefully(spec, lock_margin, q, numbers);
    }
    return kernel_of(spec.name).one.write(spec, lock_margin, q, numbers);
}

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
