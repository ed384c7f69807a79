#include "kernels.hpp"

#include <rotconv/version.hpp>

#include "../numerics/elementary.hpp"
#include "known_numbers.hpp"

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
        const double off = by.has_left ? off_of_product(by.left.off, attitudes.off[i]) : attitudes.off[i];
        attitudes.off[i] = by.has_right ? off_of_product(by.right.off, off) : off;
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
                                        DiagnosticSet* diagnostics, std::uint64_t* doubts) noexcept {
    const Spec& from = *batch.from;
    const Spec& to = *batch.to;
    read_plainly(from, from.passive != to.passive, *batch.fixed, in, rows, attitudes);
    batch_kernel_of<T>(to.name).write(to, batch.lock_margin, attitudes, rows, out, rest, diagnostics, doubts);
}

CarefulTask task_of(const ConversionBatch& batch) noexcept {
    return {
        batch.from, batch.from->passive != batch.to->passive, batch.fixed, nullptr, false, batch.to, batch.lock_margin,
        batch.zeros};
}

/// Leaves open what is in doubt, and not settled.
void settle_all(const CarefulTask& task, const double* in, std::size_t rows, const DiagnosticSet* diagnostics,
                const std::uint64_t* doubts, AttitudeBatch<double>& rounded, double* out, double* rest,
                bool* open) noexcept {
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < rows; ++i) {
        all |= doubts[i];
        open[i] = false;
    }
    const std::size_t from_size = task.first->size();
    const std::size_t to_size = task.to->size();
    for (std::size_t i = 0; i < rows && all != 0; ++i) {
        if (doubts[i] == 0 || rounded.error[i] != Error::none) {
            continue;
        }
        open[i] = !settle(task, {in + i * from_size, nullptr}, diagnostics[i], doubts[i], out + i * to_size,
                          rest == nullptr ? nullptr : rest + i * to_size);
        for (std::size_t k = 0; k < 4 && task.to->name == RepresentationId::quat; ++k) {
            rounded[k].set(i, (doubts[i] >> k & 1U) != 0 ? 0.0 : rounded[k][i]);
        }
    }
}

/// -0 becomes 0. Of a rest, which may be null, 106 bits do not tell that there is nothing.
void forget_negative_zeros(double* numbers, std::size_t count) noexcept {
    for (std::size_t k = 0; k < count && numbers != nullptr; ++k) {
        numbers[k] += 0.0;
    }
}

template <class T> void convert(const ConversionBatch& batch, const double* in, std::size_t rows,
                                AttitudeBatch<double>& rounded, double* out, double* rest,
                                DiagnosticSet* diagnostics) noexcept {
    AttitudeBatch<T> attitudes;
    const CarefulTask task = task_of(batch);
    std::uint64_t doubts[batch_rows] = {};
    bool open[batch_rows] = {};
    convert_plainly(batch, in, rows, attitudes, out, rest, diagnostics, doubts);
    forget_negative_zeros(rest, rows * batch.to->size());
    round(attitudes, rows, rounded);
    if constexpr (!std::is_same_v<T, double>) {
        settle_all(task, in, rows, diagnostics, doubts, rounded, out, rest, open);
    }
    for_each_careful_row(
        *batch.from, in, attitudes, rows,
        [&](std::size_t i) { open[i] = batch.to->name != RepresentationId::quat || !keeps_bits(attitudes, i); },
        !std::is_same_v<T, double>);
    const std::size_t size = batch.to->size();
    for (std::size_t i = 0; i < rows; ++i) {
        if (open[i]) [[unlikely]] {
            diagnostics[i] = answer_carefully(task, {in + i * batch.from->size(), nullptr}, out + i * size,
                                              rest == nullptr ? nullptr : rest + i * size, i, rounded);
        }
    }
    forget_negative_zeros(out, rows * size);
}

/// Converts to 106 bits, together, the rows that are open and have no error.
void convert_open(const ConversionBatch& batch, const double* in, std::size_t rows, const bool* open,
                  AttitudeBatch<double>& rounded, double* out, DiagnosticSet* diagnostics) noexcept {
    bool are_open = false;
    for (std::size_t i = 0; i < rows; ++i) {
        are_open |= open[i];
    }
    if (!are_open) {
        return;
    }
    const std::size_t from_size = batch.from->size();
    const std::size_t to_size = batch.to->size();
    std::size_t count = 0;
    std::size_t places[batch_rows];
    double numbers[most_numbers * batch_rows];
    for (std::size_t i = 0; i < rows; ++i) {
        if (open[i] && rounded.error[i] == Error::none) {
            for (std::size_t k = 0; k < from_size; ++k) {
                numbers[count * from_size + k] = in[i * from_size + k];
            }
            places[count++] = i;
        }
    }
    double results[most_numbers * batch_rows];
    AttitudeBatch<double> attitudes;
    DiagnosticSet found[batch_rows];
    convert<DoubleDouble>(batch, numbers, count, attitudes, results, nullptr, found);
    for (std::size_t n = 0; n < count; ++n) {
        const std::size_t i = places[n];
        for (std::size_t k = 0; k < to_size; ++k) {
            out[i * to_size + k] = results[n * to_size + k];
        }
        rounded.set(i, {attitudes[0][n], attitudes[1][n], attitudes[2][n], attitudes[3][n]});
        rounded.defect[i] = attitudes.defect[n];
        rounded.error[i] = attitudes.error[n];
        diagnostics[i] = found[n];
    }
}

bool convert_first(const ConversionBatch& batch, const double* in, std::size_t rows, AttitudeBatch<double>& rounded,
                   double* out, bool* open) noexcept {
    const Spec& from = *batch.from;
    const Spec& to = *batch.to;
    const CarefulTask task = task_of(batch);
    std::uint64_t doubts[batch_rows] = {};
    const DiagnosticSet unlocked[batch_rows] = {}; // others are left open
    const auto set_open = [open](std::size_t i) { open[i] = true; };
    const auto read_first = kernel_of(from.name).read_first;
    if (to.name == RepresentationId::quat && read_first != nullptr && !batch.fixed->has_left &&
        !batch.fixed->has_right) {
        if (!read_first(from, in, rows, rounded, doubts)) {
            return false;
        }
        invert_if(task.inverts_first, rounded, rows);
        for (std::size_t i = 0; i < rows; ++i) {
            double q[4];
            rounded.get(i, q);
            const double sign = canonical_sign(q);
            for (std::size_t k = 0; k < 4; ++k) {
                out[4 * i + k] = sign * q[k] + 0.0;
            }
        }
        settle_all(task, in, rows, unlocked, doubts, rounded, out, nullptr, open);
        if (!kernel_of(from.name).first_takes_any_size) {
            for_each_careful_row(from, in, rounded, rows, set_open);
        }
        return true;
    }
    const auto write_first = kernel_of(to.name).write_first;
    if (write_first == nullptr) {
        return false;
    }
    AttitudeBatch<DoubleDouble> attitudes;
    read_plainly(from, task.inverts_first, *batch.fixed, in, rows, attitudes);
    write_first(to, batch.lock_margin, attitudes, rows, out, doubts);
    round(attitudes, rows, rounded);
    settle_all(task, in, rows, unlocked, doubts, rounded, out, nullptr, open);
    if (!kernel_of(to.name).first_takes_any_size || !kernel_of(from.name).reading_is_exact) {
        for_each_careful_row(from, in, attitudes, rows, set_open);
    }
    return true;
}

/// Whether all numbers of a row are sums of its angles, or 0, with what they have beside those written.
bool are_known(const CarefulTask& task, const CarefulRow& row, double* numbers, double* rest,
               std::size_t rest_size) noexcept {
    bool known = true;
    for (unsigned k = 0; k < task.to->size() && known; ++k) {
        double* const own = rest + k * rest_size;
        for (std::size_t i = 0; i < rest_size; ++i) {
            own[i] = -0.0;
        }
        known = numbers[k] == 0.0 ? are_zeros(task, row, std::uint64_t{1} << k, true)
                                  : round_sum(task, row, k, numbers[k], own, rest_size);
    }
    return known;
}

/// A row that has been answered to 106 bits once more, with a rest of several doubles: in Wide, unless it is known.
void answer_with_rest(const CarefulTask& task, const CarefulRow& row, double* numbers, double* rest,
                      std::size_t rest_size, std::size_t place, AttitudeBatch<double>& rounded,
                      DiagnosticSet& diagnostics) noexcept {
    if (rounded.error[place] == Error::none &&
        !are_known(at_lock(task, diagnostics, numbers[1]), row, numbers, rest, rest_size)) {
        const Wide::Bits enough(Wide::bits_of_rest);
        answer_once(task, row, numbers, rest, rest_size, place, rounded, diagnostics);
    }
}

void convert_with_rest(const ConversionBatch& batch, const double* in, std::size_t rows, AttitudeBatch<double>& rounded,
                       double* out, double* rest, DiagnosticSet* diagnostics) noexcept {
    const CarefulTask task = task_of(batch);
    const std::size_t size = batch.to->size();
    convert<DoubleDouble>(batch, in, rows, rounded, out, nullptr, diagnostics);
    for (std::size_t i = 0; i < rows; ++i) {
        answer_with_rest(task, {in + i * batch.from->size(), nullptr}, out + i * size,
                         rest + i * size * batch.rest_size, batch.rest_size, i, rounded, diagnostics[i]);
    }
    forget_negative_zeros(out, rows * size);
}

/// The rows that the first phase leaves open, together.
void convert_in_phases(const ConversionBatch& batch, const double* in, std::size_t rows, AttitudeBatch<double>& rounded,
                       double* out, double* rest, DiagnosticSet* diagnostics) noexcept {
    bool open[batch_rows];
    if (batch.rest_size > 1 && rest != nullptr) {
        convert_with_rest(batch, in, rows, rounded, out, rest, diagnostics);
    } else if (rest != nullptr || !convert_first(batch, in, rows, rounded, out, open)) {
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
        attitudes.set(i, {rounded_parts(q[0]), rounded_parts(q[1]), rounded_parts(q[2]), rounded_parts(q[3])});
        attitudes.off[i] = 0x1p-98; // of the smallest numbers, too, which have no other place
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
    attitude.off = attitudes.off[0] + 0x1p-98;
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

/// The second attitudes of products.
void read_second(const ProductBatch& batch, const double* second, std::size_t rows,
                 AttitudeBatch<DoubleDouble>& attitudes) noexcept {
    read_upright(*batch.second, no_rotations, second, rows, attitudes);
    if (batch.later == nullptr) {
        return;
    }
    AttitudeBatch<DoubleDouble> later;
    read_upright(*batch.second, no_rotations, batch.later, rows, later);
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble p[4];
        DoubleDouble q[4];
        attitudes.get(i, p);
        later.get(i, q);
        interpolate(batch.fractions + i * batch.row_size, q, p);
        attitudes.set(i, p);
        attitudes.off[i] = 4.0 * (attitudes.off[i] + later.off[i]) + 0x1p-96; // both are at least 1/2 long
        attitudes.error[i] = attitudes.error[i] != Error::none ? attitudes.error[i] : later.error[i];
    }
}

void multiply(const ProductBatch& batch, const double* first, const double* second, std::size_t rows,
              AttitudeBatch<double>* const (&rounded)[3], double* out, double* rest,
              DiagnosticSet* diagnostics) noexcept {
    const Spec& to = *batch.to;
    const CarefulTask task{batch.first, batch.first->passive, batch.fixed, batch.second, to.passive,
                           &to,         batch.lock_margin,    batch.zeros};
    AttitudeBatch<DoubleDouble> attitudes[3];
    auto& [left, right, product] = attitudes;
    read_upright(*batch.first, *batch.fixed, first, rows, left);
    read_second(batch, second, rows, right);
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble q[4];
        DoubleDouble other[4];
        left.get(i, q);
        right.get(i, other);
        multiply_from_side(other, false, q);
        product.set(i, q);
        product.defect[i] = 0.0;
        product.off[i] = off_of_product(left.off[i], right.off[i]);
        product.error[i] = left.error[i] != Error::none ? left.error[i] : right.error[i];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        round(attitudes[k], rows, *rounded[k]);
    }
    invert_if(to.passive, product, rows);
    std::uint64_t doubts[batch_rows] = {};
    kernel_of(to.name).exact.write(to, batch.lock_margin, product, rows, out, batch.rest_size > 1 ? nullptr : rest,
                                   diagnostics, doubts);
    forget_negative_zeros(rest, batch.rest_size > 1 ? 0 : rows * to.size());
    const auto set_open = [&](std::size_t i) { doubts[i] = other_doubt; };
    for_each_careful_row(*batch.first, first, product, rows, set_open);
    for_each_careful_row(*batch.second, second, product, rows, set_open);
    if (batch.later != nullptr) {
        for_each_careful_row(*batch.second, batch.later, product, rows, set_open);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const std::size_t place = i * batch.second->size();
        const CarefulRow row{first + i * batch.first->size(), second + place,
                             batch.later == nullptr ? nullptr : batch.later + place,
                             batch.fractions + i * batch.row_size};
        double* const own_rest = rest == nullptr ? nullptr : rest + i * to.size() * batch.rest_size;
        if (batch.rest_size > 1 && own_rest != nullptr) {
            answer_with_rest(task, row, out + i * to.size(), own_rest, batch.rest_size, i, *rounded[2], diagnostics[i]);
        } else if (doubts[i] != 0 && product.error[i] == Error::none &&
                   !settle(task, row, diagnostics[i], doubts[i], out + i * to.size(), own_rest)) {
            diagnostics[i] = answer_carefully(task, row, out + i * to.size(), own_rest, i, *rounded[2]);
        }
    }
}

/// A sum of three products of an entry of a matrix, off by 16 times what the attitude is and by 2^-96, and a number.
void rotate(const Spec& spec, ZeroTable* zeros, const double* numbers, const double* vectors, std::size_t rows,
            AttitudeBatch<double>& rounded, double* out) noexcept {
    const CarefulTask task{&spec, spec.passive, &no_rotations, nullptr, false, nullptr, 0.0, zeros};
    AttitudeBatch<DoubleDouble> attitudes;
    read_upright(spec, no_rotations, numbers, rows, attitudes);
    round(attitudes, rows, rounded);
    std::uint64_t doubts[batch_rows] = {};
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble q[4];
        DoubleDouble rotated[3];
        double vector[3];
        attitudes.get(i, q);
        load(vectors + 3 * i, vector);
        rotate_vector(q, vector, rotated);
        store(rotated, out + 3 * i);
        const double size = (__builtin_fabs(vector[0]) + __builtin_fabs(vector[1])) + __builtin_fabs(vector[2]);
        for (unsigned k = 0; k < 3; ++k) {
            doubts[i] |= doubt_of(rotated[k], (16.0 * attitudes.off[i] + 0x1p-95) * size, k);
        }
    }
    for_each_careful_row(spec, numbers, attitudes, rows, [&](std::size_t i) { doubts[i] = other_doubt; });
    for (std::size_t i = 0; i < rows; ++i) {
        const CarefulRow row{numbers + i * spec.size(), vectors + 3 * i};
        if (!all(row.second, 3, [](double number) { return is_plain_number(number); })) {
            doubts[i] = other_doubt;
        }
        if (doubts[i] != 0 && attitudes.error[i] == Error::none && all_finite(row.second, 3) &&
            !settle(task, row, {}, doubts[i], out + 3 * i, nullptr)) {
            answer_carefully(task, row, out + 3 * i, nullptr, i, rounded);
        }
    }
}

ROTCONV_NOINLINE Error read_one_carefully(const Spec& spec, const double* numbers, double (&q)[4],
                                          double& defect) noexcept {
    const Error error = kernel_of(spec.name).one.read(spec, numbers, q, defect);
    if (error == Error::none) {
        Careful careful[4];
        read_carefully(spec, numbers, false, no_rotations, careful);
        load(careful, q);
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
    Careful results[most_numbers];
    const DiagnosticSet found =
        kernel_of(spec.name).careful.write(spec, lock_margin, {q[0], q[1], q[2], q[3]}, results);
    for (std::size_t k = 0; k < spec.size(); ++k) {
        numbers[k] = results[k].rounded();
    }
    return found;
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
