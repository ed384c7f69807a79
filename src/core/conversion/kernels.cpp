#include "kernels.hpp"

#include <rotconv/version.hpp>

#include "../numerics/elementary.hpp"
#include "known_numbers.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

// Functions of a batch.

bool has_rotations(const FixedRotations& by) noexcept { return by.left.count + by.right.count > 0; }

template <class T> void multiply_by(const FixedRotations& by, AttitudeBatch<T>& attitudes, std::size_t rows) noexcept {
    for (std::size_t i = 0; i < rows && has_rotations(by); ++i) {
        T q[4];
        attitudes.get(i, q);
        multiply_by(by, q);
        attitudes.set(i, q);
        const double off =
            by.left.count > 0 ? off_of_product(by.left.rotation.off, attitudes.off[i]) : attitudes.off[i];
        attitudes.off[i] = by.right.count > 0 ? off_of_product(by.right.rotation.off, off) : off;
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

/// The attitudes of plain rows, between the fixed rotations.
template <class T> void read_plainly(const Spec& spec, const FixedRotations& all, const double* numbers,
                                     std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
    double moved[2][9 * batch_rows];
    const FixedRotations fixed = move_axes(spec, spec.passive, all, numbers, rows, moved);
    batch_kernel_of<T>(spec.name).read(spec, numbers, rows, attitudes);
    invert_if(spec.passive, attitudes, rows);
    multiply_by(fixed, attitudes, rows);
}

/// The same of all rows, to 106 bits.
void read_upright(const Spec& spec, const FixedRotations& fixed, const double* numbers, std::size_t rows,
                  AttitudeBatch<DoubleDouble>& attitudes) noexcept {
    read_plainly(spec, fixed, numbers, rows, attitudes);
    for_each_careful_row(spec, numbers, attitudes, rows, [&](std::size_t i) {
        Careful q[4];
        read_carefully(spec, numbers + i * spec.size(), fixed, q);
        attitudes.set(i, {rounded_parts(q[0]), rounded_parts(q[1]), rounded_parts(q[2]), rounded_parts(q[3])});
        attitudes.off[i] = 0x1p-98; // of the smallest numbers, too, which have no other place
    });
}

/// The second attitudes of products.
void read_second(const Task& task, const TaskNumbers& numbers, std::size_t rows,
                 AttitudeBatch<DoubleDouble>& attitudes) noexcept {
    read_upright(*task.second, no_rotations, numbers.second, rows, attitudes);
    if (numbers.later == nullptr || numbers.fractions == nullptr) {
        return;
    }
    AttitudeBatch<DoubleDouble> later;
    read_upright(*task.second, no_rotations, numbers.later, rows, later);
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble p[4];
        DoubleDouble q[4];
        attitudes.get(i, p);
        later.get(i, q);
        interpolate(numbers.fractions + 6 * i, q, p);
        attitudes.set(i, p);
        attitudes.off[i] = 4.0 * (attitudes.off[i] + later.off[i]) + 0x1p-96; // both are at least 1/2 long
        attitudes.error[i] = attitudes.error[i] != Error::none ? attitudes.error[i] : later.error[i];
    }
}

void read_product(const Task& task, const TaskNumbers& numbers, std::size_t rows, const TaskAttitudes& rounded,
                  AttitudeBatch<DoubleDouble>& product) noexcept {
    AttitudeBatch<DoubleDouble> first;
    AttitudeBatch<DoubleDouble> second;
    read_upright(*task.first, *task.fixed, numbers.first, rows, first);
    read_second(task, numbers, rows, second);
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble q[4];
        DoubleDouble other[4];
        first.get(i, q);
        second.get(i, other);
        multiply_from_side(other, false, q);
        product.set(i, q);
        product.defect[i] = 0.0;
        product.off[i] = off_of_product(first.off[i], second.off[i]);
        product.error[i] = first.error[i] != Error::none ? first.error[i] : second.error[i];
    }
    if (rounded.first != nullptr && rounded.second != nullptr) { // as of all products
        round(first, rows, *rounded.first);
        round(second, rows, *rounded.second);
    }
}

/// The attitudes that are written.
template <class T> void read_written(const Task& task, const TaskNumbers& numbers, std::size_t rows,
                                     const TaskAttitudes& rounded, AttitudeBatch<T>& attitudes) noexcept {
    if constexpr (std::is_same_v<T, double>) {
        read_plainly(*task.first, *task.fixed, numbers.first, rows, attitudes);
    } else {
        task.second == nullptr ? read_plainly(*task.first, *task.fixed, numbers.first, rows, attitudes)
                               : read_product(task, numbers, rows, rounded, attitudes);
    }
    for (std::size_t i = 0; i < rows && task.to == nullptr && numbers.second != nullptr; ++i) {
        const bool fails = attitudes.error[i] == Error::none && !all_finite(numbers.second + 3 * i, 3);
        attitudes.error[i] = fails ? Error::not_finite : attitudes.error[i];
    }
    invert_if(task.inverts(), attitudes, rows);
    round(attitudes, rows, rounded.written);
}

/// A sum of three products of an entry of a matrix, off by 16 times what the attitude is and by 2^-96, and a number.
void turn_vectors(const AttitudeBatch<DoubleDouble>& attitudes, const double* vectors, std::size_t rows, double* out,
                  std::uint64_t* doubts) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble q[4];
        DoubleDouble turned[3];
        double vector[3];
        attitudes.get(i, q);
        load(vectors + 3 * i, vector);
        rotate_vector(q, vector, turned);
        store(turned, out + 3 * i);
        const double size = (__builtin_fabs(vector[0]) + __builtin_fabs(vector[1])) + __builtin_fabs(vector[2]);
        for (unsigned k = 0; k < 3; ++k) {
            doubts[i] |= doubt_of(turned[k], (16.0 * attitudes.off[i] + 0x1p-95) * size, k);
        }
        doubts[i] |= all(vector, 3, [](double number) { return is_plain_number(number); }) ? 0U : other_doubt;
    }
}

/// Calls answer(i, row) for each row without an error of which something is in doubt, and not settled.
template <class Function> void for_each_unsettled(const Task& task, const TaskNumbers& numbers, std::size_t rows,
                                                  const Error* errors, const DiagnosticSet* diagnostics,
                                                  const std::uint64_t* doubts, double* out, double* rest,
                                                  const Function& answer) noexcept {
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < rows; ++i) {
        all |= doubts[i];
    }
    const std::size_t size = task.out_size();
    for (std::size_t i = 0; i < rows && all != 0; ++i) {
        if (doubts[i] == 0 || errors[i] != Error::none) {
            continue;
        }
        const TaskNumbers row = numbers.of_row(task, i);
        if (!settle(task, row, diagnostics[i], doubts[i], out + i * size,
                    rest == nullptr ? nullptr : rest + i * size)) {
            answer(i, row);
        }
    }
}

/// -0 becomes 0. Of a rest, which may be null, 106 bits do not tell that there is nothing.
void forget_negative_zeros(double* numbers, std::size_t count) noexcept {
    for (std::size_t k = 0; k < count && numbers != nullptr; ++k) {
        numbers[k] += 0.0;
    }
}

/// Whether all numbers of a row are sums of its angles, or 0, with what they have beside those written.
bool are_known(const Task& task, const TaskNumbers& row, double* numbers, double* rest) noexcept {
    bool known = true;
    for (unsigned k = 0; k < task.to->size() && known; ++k) {
        double* const own = rest + k * task.rest_size;
        for (std::size_t i = 0; i < task.rest_size; ++i) {
            own[i] = -0.0;
        }
        known = numbers[k] == 0.0 ? are_zeros(task, row, std::uint64_t{1} << k, true)
                                  : round_sum(task, row, k, numbers[k], own, task.rest_size);
    }
    return known;
}

template <class T> void run(const Task& task, const TaskNumbers& numbers, std::size_t rows,
                            const TaskAttitudes& rounded, double* out, double* rest,
                            DiagnosticSet* diagnostics) noexcept {
    AttitudeBatch<T> attitudes;
    std::uint64_t doubts[batch_rows] = {};
    const auto set_careful = [&](std::size_t i) { doubts[i] = other_doubt; };
    const std::size_t size = task.out_size();
    double* const one_rest = task.rest_size == 1 ? rest : nullptr;
    read_written(task, numbers, rows, rounded, attitudes);
    for_each_careful_row(*task.first, numbers.first, attitudes, rows, set_careful, !std::is_same_v<T, double>);
    if (task.second != nullptr) {
        for_each_careful_row(*task.second, numbers.second, attitudes, rows, set_careful);
    }
    if (task.second != nullptr && numbers.later != nullptr) {
        for_each_careful_row(*task.second, numbers.later, attitudes, rows, set_careful);
    }
    if (task.to != nullptr) {
        batch_kernel_of<T>(task.to->name)
            .write(*task.to, task.lock_margin, attitudes, rows, out, one_rest, diagnostics, doubts);
    } else if constexpr (!std::is_same_v<T, double>) {
        turn_vectors(attitudes, numbers.second, rows, out, doubts);
    }
    forget_negative_zeros(one_rest, rows * size);
    for_each_unsettled(task, numbers, rows, attitudes.error, diagnostics, doubts, out, one_rest,
                       [&](std::size_t i, const TaskNumbers& row) {
                           diagnostics[i] = answer_carefully(task, row, out + i * size,
                                                             one_rest == nullptr ? nullptr : one_rest + i * size, i,
                                                             rounded.written);
                       });
    for (std::size_t i = 0; i < rows && task.rest_size > 1 && rest != nullptr; ++i) { // once more, in Wide
        const TaskNumbers row = numbers.of_row(task, i);
        double* const own = out + i * size;
        double* const own_rest = rest + i * size * task.rest_size;
        if (attitudes.error[i] == Error::none &&
            !are_known(at_lock(task, diagnostics[i], own[1]), row, own, own_rest)) {
            const Wide::Bits enough(Wide::bits_of_rest);
            answer_once(task, row, own, own_rest, task.rest_size, i, rounded.written, diagnostics[i]);
        }
    }
    forget_negative_zeros(out, rows * size);
}

/// Answers the rows that are open, each stretch of them together.
void run_open(const Task& task, const double* in, std::size_t rows, const bool* open, AttitudeBatch<double>& rounded,
              double* out, DiagnosticSet* diagnostics) noexcept {
    AttitudeBatch<double> own;
    std::size_t count = 0;
    for (std::size_t i = 0; i < rows; i += count + 1) {
        count = 0;
        while (i + count < rows && open[i + count]) {
            ++count;
        }
        if (count > 0) [[unlikely]] {
            run<DoubleDouble>(task, {in + i * task.first->size()}, count, {own}, out + i * task.to->size(), nullptr,
                              diagnostics + i);
        }
        for (std::size_t n = 0; n < count; ++n) {
            rounded.set(i + n, {own[0][n], own[1][n], own[2][n], own[3][n]});
            rounded.defect[i + n] = own.defect[n];
            rounded.error[i + n] = own.error[n];
        }
    }
}

bool run_first(const Task& task, const double* in, std::size_t rows, AttitudeBatch<double>& rounded, double* out,
               bool* open) noexcept {
    const Spec& from = *task.first;
    const Spec& to = *task.to;
    const Kernel& reader = kernel_of(from.name);
    const Kernel& writer = kernel_of(to.name);
    std::uint64_t doubts[batch_rows] = {};
    const bool only_reads = writer.is_quaternion && reader.read_first != nullptr && !has_rotations(*task.fixed);
    if (only_reads) {
        if (!reader.read_first(from, in, rows, rounded, doubts)) {
            return false;
        }
        invert_if(from.passive != to.passive, rounded, rows);
        for (std::size_t i = 0; i < rows; ++i) {
            double q[4];
            rounded.get(i, q);
            const double sign = canonical_sign(q);
            for (std::size_t k = 0; k < 4; ++k) {
                out[4 * i + k] = sign * q[k] + 0.0;
            }
        }
    } else if (writer.write_first != nullptr) {
        AttitudeBatch<DoubleDouble> attitudes;
        read_written(task, {in}, rows, {rounded}, attitudes);
        writer.write_first(to, task.lock_margin, attitudes, rows, out, doubts);
    } else {
        return false;
    }
    if (!(only_reads ? reader.first_takes_any_size : writer.first_takes_any_size && reader.is_quaternion)) {
        for_each_careful_row(from, in, rounded, rows, [&](std::size_t i) { doubts[i] = other_doubt; });
    }
    for (std::size_t i = 0; i < rows; ++i) {
        open[i] = false;
    }
    const DiagnosticSet unlocked[batch_rows] = {}; // others are left open
    for_each_unsettled(task, {in}, rows, rounded.error, unlocked, doubts, out, nullptr,
                       [open](std::size_t i, const TaskNumbers& /*row*/) { open[i] = true; });
    return true;
}

void run_in_phases(const Task& task, const TaskNumbers& numbers, std::size_t rows, const TaskAttitudes& rounded,
                   double* out, double* rest, DiagnosticSet* diagnostics) noexcept {
    bool open[batch_rows];
    if (rest != nullptr || numbers.second != nullptr ||
        !run_first(task, numbers.first, rows, rounded.written, out, open)) {
        run<DoubleDouble>(task, numbers, rows, rounded, out, rest, diagnostics);
    } else {
        run_open(task, numbers.first, rows, open, rounded.written, out, diagnostics);
    }
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

void relate(const AttitudeBatch<double>& attitudes, const AttitudeBatch<double>& references, std::size_t rows,
            double* angles) noexcept {
    AttitudeBatch<double> relative;
    for (std::size_t i = 0; i < rows; ++i) {
        double q[4];
        double reference[4];
        attitudes.get(i, q);
        references.get(i, reference);
        make_relative(reference, q);
        relative.set(i, q);
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
        if (!(angles[i] >= 0x1p-100)) { // the squares may have underflowed
            angles[i] = 2.0 * angle_of(scalars[i], norm_of(x[i], y[i], z[i]), AngleUnit::radians).hi;
        }
    }
}

ROTCONV_NOINLINE Error read_one_carefully(const Spec& spec, const double* numbers, double (&q)[4],
                                          double& defect) noexcept {
    const Error error = kernel_of(spec.name).one.read(spec, numbers, q, defect);
    if (error == Error::none) {
        Careful careful[4];
        kernel_of(spec.name).careful.read(spec, numbers, careful);
        scale_to_unit(careful);
        load(careful, q);
    }
    return error;
}

Error read_one(const Spec& spec, const double* numbers, double (&q)[4], double& defect) noexcept {
    const Kernel& kernel = kernel_of(spec.name);
    const auto is_plain = [](const double& number) { return is_plain_number(alone(number)); };
    if (!(kernel.is_quaternion || all(numbers, kernel.size, is_plain))) [[unlikely]] {
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
                                                               .run = run_in_phases,
                                                               .run_first = run_first,
                                                               .run_fast = run<double>,
                                                               .read = read,
                                                               .relate = relate,
                                                               .read_exactly = read_exactly,
                                                               .read_one = read_one,
                                                               .write_one = write_one};

} // namespace rotconv
