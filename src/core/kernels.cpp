#include "kernels.hpp"

#include "numerics/quaternion_algebra.hpp"
#include "representations/kernel.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

constexpr std::size_t most_numbers = 9;

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

template <class T> T component_of(const ExactQuaternion& q, std::size_t k) noexcept {
    return rounded_to<T>(DoubleDouble(q.hi[k], q.lo[k]));
}

template <class T>
void turn(const ExactQuaternion& by, bool from_the_left, AttitudeBatch<T>& attitudes, std::size_t rows) noexcept {
    const T constant[4] = {component_of<T>(by, 0), component_of<T>(by, 1), component_of<T>(by, 2),
                           component_of<T>(by, 3)};
    for (std::size_t i = 0; i < rows; ++i) {
        T own[4];
        T product[4];
        attitudes.get(i, own);
        multiply(from_the_left ? constant : own, from_the_left ? own : constant, product);
        attitudes.set(i, product);
    }
}

template <class T> void invert(AttitudeBatch<T>& attitudes, std::size_t rows) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        attitudes.w.set(i, -attitudes.w[i]);
    }
}

/// The attitudes that rows describe.
template <class T>
void read_upright(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<T>& attitudes) noexcept {
    batch_kernel_of<T>(spec.name).read(spec, numbers, rows, attitudes);
    if (spec.passive) {
        invert(attitudes, rows);
    }
}

bool all_plain_numbers(const double* numbers, std::size_t count) noexcept {
    bool all = true;
    for (std::size_t i = 0; i < count; ++i) {
        all = all & is_plain_number(numbers[i]); // no branch: the loop vectorises
    }
    return all;
}

bool all_plain_components(const double* components, std::size_t count) noexcept {
    bool all = true;
    for (std::size_t i = 0; i < count; ++i) {
        all = all & is_plain_component(components[i]);
    }
    return all;
}

template <class T> bool is_plain(const AttitudeBatch<T>& attitudes, std::size_t row) noexcept {
    return is_plain_component(attitudes.w.hi[row]) && is_plain_component(attitudes.x.hi[row]) &&
           is_plain_component(attitudes.y.hi[row]) && is_plain_component(attitudes.z.hi[row]);
}

/// All rows of a batch, of which most have nothing but plain numbers and attitudes.
template <class T> bool all_plain(const AttitudeBatch<T>& attitudes, std::size_t rows) noexcept {
    return all_plain_components(attitudes.w.hi, rows) && all_plain_components(attitudes.x.hi, rows) &&
           all_plain_components(attitudes.y.hi, rows) && all_plain_components(attitudes.z.hi, rows);
}

/// Calls careful(i) for each row without error that the batch kernels do not serve, because one of its numbers or the
/// attitude that came of them is not plain.
template <class T, class Careful> void for_each_careful_row(const Spec& spec, const double* numbers,
                                                            const AttitudeBatch<T>& attitudes, std::size_t rows,
                                                            const Careful& careful) noexcept {
    const std::size_t size = kernel_of(spec.name).reading_is_exact ? 0 : spec.size();
    if (all_plain(attitudes, rows) && all_plain_numbers(numbers, rows * size)) {
        return;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (attitudes.error[i] == Error::none &&
            !(is_plain(attitudes, i) && all_plain_numbers(numbers + i * size, size))) {
            careful(i);
        }
    }
}

using Careful = ScaledDoubleDouble;

/// The attitude of a row, or its inverse, its largest component of size 1/2 to 1.
void read_carefully(const Spec& spec, const double* numbers, bool inverse, Careful (&q)[4]) noexcept {
    kernel_of(spec.name).careful.read(spec, numbers, q);
    int largest = q[0].exponent();
    for (const Careful& component : q) {
        largest = component.exponent() > largest ? component.exponent() : largest;
    }
    for (Careful& component : q) {
        component = component.shifted(-1 - largest);
    }
    q[0] = inverse ? -q[0] : q[0];
}

void turn_carefully(const ExactQuaternion* by, bool from_the_left, Careful (&q)[4]) noexcept {
    if (by == nullptr) {
        return;
    }
    const Careful constant[4] = {component_of<Careful>(*by, 0), component_of<Careful>(*by, 1),
                                 component_of<Careful>(*by, 2), component_of<Careful>(*by, 3)};
    const Careful own[4] = {q[0], q[1], q[2], q[3]};
    multiply(from_the_left ? constant : own, from_the_left ? own : constant, q);
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

void set_rounded(AttitudeBatch<double>& attitudes, std::size_t row, const Careful (&q)[4]) noexcept {
    attitudes.set(row, q[0].rounded(), q[1].rounded(), q[2].rounded(), q[3].rounded());
}

template <class T>
void round(const AttitudeBatch<T>& attitudes, std::size_t rows, AttitudeBatch<double>& rounded) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        rounded.set(i, attitudes.w.hi[i], attitudes.x.hi[i], attitudes.y.hi[i], attitudes.z.hi[i]);
        rounded.defect[i] = attitudes.defect[i];
        rounded.error[i] = attitudes.error[i];
    }
}

template <class T> void convert(const ConversionBatch& batch, const double* in, std::size_t rows,
                                AttitudeBatch<double>& rounded, double* out, double* rest,
                                DiagnosticSet* diagnostics) noexcept {
    const Spec& from = *batch.from;
    const Spec& to = *batch.to;
    const bool inverse = from.passive != to.passive;
    AttitudeBatch<T> attitudes;
    batch_kernel_of<T>(from.name).read(from, in, rows, attitudes);
    if (inverse) {
        invert(attitudes, rows);
    }
    if (batch.left != nullptr) {
        turn(*batch.left, true, attitudes, rows);
    }
    if (batch.right != nullptr) {
        turn(*batch.right, false, attitudes, rows);
    }
    batch_kernel_of<T>(to.name).write(to, batch.lock_margin, attitudes, rows, out, rest, diagnostics);
    round(attitudes, rows, rounded);
    for_each_careful_row(from, in, attitudes, rows, [&](std::size_t i) {
        if (to.name == RepresentationId::quat && keeps_bits(attitudes, i)) {
            return;
        }
        Careful q[4];
        read_carefully(from, in + i * from.size(), inverse, q);
        turn_carefully(batch.left, true, q);
        turn_carefully(batch.right, false, q);
        diagnostics[i] = write_carefully(to, batch.lock_margin, q, out + i * to.size(),
                                         rest == nullptr ? nullptr : rest + i * to.size());
        set_rounded(rounded, i, q);
    });
}

void read(const Spec& spec, const double* numbers, std::size_t rows, AttitudeBatch<double>& rounded) noexcept {
    AttitudeBatch<DoubleDouble> attitudes;
    read_upright(spec, numbers, rows, attitudes);
    round(attitudes, rows, rounded);
    for_each_careful_row(spec, numbers, attitudes, rows, [&](std::size_t i) {
        Careful q[4];
        read_carefully(spec, numbers + i * spec.size(), spec.passive, q);
        set_rounded(rounded, i, q);
    });
}

/// The factors of R_REF' R or R R_REF', of which the reference's is inverted.
template <class T> void relate_row(const T (&own)[4], T (&reference)[4], Frame frame, T (&relative)[4]) noexcept {
    reference[0] = -reference[0];
    const bool from_the_left = frame == Frame::body;
    multiply(from_the_left ? reference : own, from_the_left ? own : reference, relative);
}

void relate(const AttitudeBatch<double>& attitudes, const AttitudeBatch<double>& references, Frame frame,
            std::size_t rows, AttitudeBatch<double>& relative) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        double own[4];
        double reference[4];
        double product[4];
        attitudes.get(i, own);
        references.get(i, reference);
        relate_row(own, reference, frame, product);
        relative.set(i, product);
    }
    if (all_plain(attitudes, rows) && all_plain(references, rows)) {
        return;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (!is_plain(attitudes, i) || !is_plain(references, i)) {
            Careful own[4] = {attitudes.w[i], attitudes.x[i], attitudes.y[i], attitudes.z[i]};
            Careful reference[4] = {references.w[i], references.x[i], references.y[i], references.z[i]};
            Careful product[4];
            relate_row(own, reference, frame, product);
            set_rounded(relative, i, product);
        }
    }
}

void write_relative(const RelativeBatch& batch, const double* in, const double* reference, std::size_t rows,
                    double* out, DiagnosticSet* diagnostics) noexcept {
    const Spec& to = *batch.to;
    AttitudeBatch<DoubleDouble> attitudes;
    AttitudeBatch<DoubleDouble> references;
    AttitudeBatch<DoubleDouble> relative;
    read_upright(*batch.from, in, rows, attitudes);
    read_upright(*batch.reference, reference, rows, references);
    for (std::size_t i = 0; i < rows; ++i) {
        DoubleDouble own[4];
        DoubleDouble other[4];
        DoubleDouble product[4];
        attitudes.get(i, own);
        references.get(i, other);
        relate_row(own, other, batch.frame, product);
        relative.set(i, product);
        relative.error[i] = attitudes.error[i] != Error::none ? attitudes.error[i] : references.error[i];
    }
    if (to.passive) {
        invert(relative, rows);
    }
    batch_kernel_of<DoubleDouble>(to.name).write(to, batch.lock_margin, relative, rows, out, nullptr, diagnostics);
    const auto careful = [&](std::size_t i) {
        Careful own[4];
        Careful other[4];
        Careful product[4];
        read_carefully(*batch.from, in + i * batch.from->size(), batch.from->passive, own);
        read_carefully(*batch.reference, reference + i * batch.reference->size(), batch.reference->passive, other);
        relate_row(own, other, batch.frame, product);
        product[0] = to.passive ? -product[0] : product[0];
        diagnostics[i] = write_carefully(to, batch.lock_margin, product, out + i * to.size(), nullptr);
    };
    for_each_careful_row(*batch.from, in, relative, rows, careful);
    for_each_careful_row(*batch.reference, reference, relative, rows, careful);
}

void read_exactly(const Spec& spec, const double* numbers, ExactQuaternion& attitude) noexcept {
    AttitudeBatch<DoubleDouble> attitudes;
    read_upright(spec, numbers, 1, attitudes);
    DoubleDouble q[4];
    attitudes.get(0, q);
    for_each_careful_row(spec, numbers, attitudes, 1, [&](std::size_t /*row*/) {
        Careful careful[4];
        read_carefully(spec, numbers, spec.passive, careful);
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = careful[k].rounded_parts();
        }
    });
    for (std::size_t k = 0; k < 4; ++k) {
        attitude.hi[k] = q[k].hi;
        attitude.lo[k] = q[k].lo;
    }
}

Error read_one(const Spec& spec, const double* numbers, double* q, double& defect) noexcept {
    const Kernel& kernel = kernel_of(spec.name);
    const Error error = kernel.one.read(spec, numbers, q, defect);
    const bool is_plain = kernel.reading_is_exact || all_plain_numbers(numbers, spec.size());
    if (error == Error::none && !is_plain) [[unlikely]] {
        Careful careful[4];
        read_carefully(spec, numbers, false, careful);
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = careful[k].rounded();
        }
    }
    return error;
}

DiagnosticSet write_one(const Spec& spec, double lock_margin, const double* q, double* numbers) noexcept {
    if (!all_plain_components(q, 4)) [[unlikely]] {
        return write_carefully(spec, lock_margin, {q[0], q[1], q[2], q[3]}, numbers, nullptr);
    }
    return kernel_of(spec.name).one.write(spec, lock_margin, q, numbers);
}

} // namespace
} // namespace ROTCONV_TARGET

#define ROTCONV_KERNELS_OF(target) ROTCONV_JOINED(kernels_of_, target)
#define ROTCONV_JOINED(a, b) a##b

extern const KernelTable ROTCONV_KERNELS_OF(ROTCONV_TARGET);
constinit const KernelTable ROTCONV_KERNELS_OF(ROTCONV_TARGET){.convert = convert<DoubleDouble>,
                                                               .convert_fast = convert<double>,
                                                               .read = read,
                                                               .relate = relate,
                                                               .write_relative = write_relative,
                                                               .read_exactly = read_exactly,
                                                               .read_one = read_one,
                                                               .write_one = write_one};

} // namespace rotconv
