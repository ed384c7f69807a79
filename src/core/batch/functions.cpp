#include "../batch.hpp"

#include "../representations/codec.hpp"
#include "codec.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

const BatchCodec& batch_codec_of(RepresentationId name) noexcept {
#define ROTCONV_LINE(id) &batch_codecs::id,
    static constexpr const BatchCodec* table[] = {ROTCONV_REPRESENTATIONS(ROTCONV_LINE)};
#undef ROTCONV_LINE
    return *table[static_cast<std::size_t>(name)];
}

template <class T> void read_by(const ScalarCodec<T>& codec, const Spec& spec, const double* numbers, std::size_t rows,
                                BasicReadings<T>& readings) noexcept {
    (codec.read != nullptr ? codec.read : read_plain<T>)(spec, numbers, rows, readings);
}

void read(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept {
    read_by(batch_codec_of(spec.name).fast, spec, numbers, rows, readings);
}

void write(const Spec& spec, double lock_margin, const Rotations& rotations, std::size_t rows, double* numbers,
           DiagnosticSet* diagnostics) noexcept {
    batch_codec_of(spec.name).fast.write(spec, lock_margin, rotations, rows, numbers, diagnostics);
}

Error read_one(const Spec& spec, const double* numbers, double* q, double& defect) noexcept {
    const BatchCodec& codec = batch_codec_of(spec.name);
    if (codec.one.read != nullptr) {
        return codec.one.read(spec, numbers, q);
    }
    Readings readings;
    read_by(codec.fast, spec, numbers, 1, readings);
    q[0] = readings.w[0];
    q[1] = readings.x[0];
    q[2] = readings.y[0];
    q[3] = readings.z[0];
    defect = readings.defect[0];
    return readings.error[0];
}

DiagnosticSet write_one(const Spec& spec, double lock_margin, const double* q, double* numbers) noexcept {
    const BatchCodec& codec = batch_codec_of(spec.name);
    if (codec.one.write != nullptr) {
        return codec.one.write(spec, lock_margin, q, numbers);
    }
    Rotations rotations;
    rotations.set(0, q[0], q[1], q[2], q[3]);
    DiagnosticSet diagnostics;
    codec.fast.write(spec, lock_margin, rotations, 1, numbers, &diagnostics);
    return diagnostics;
}

/// A product of quaternions to 2^-100 of its length, its own kept in [1/4, 4) by a power of two.
void multiply(const Real (&a)[4], const Real (&b)[4], Real (&product)[4]) noexcept {
    product[0] = (a[0] * b[0] - a[1] * b[1]) - (a[2] * b[2] + a[3] * b[3]);
    product[1] = (a[0] * b[1] + a[1] * b[0]) + (a[2] * b[3] - a[3] * b[2]);
    product[2] = (a[0] * b[2] + a[2] * b[0]) + (a[3] * b[1] - a[1] * b[3]);
    product[3] = (a[0] * b[3] + a[3] * b[0]) + (a[1] * b[2] - a[2] * b[1]);
    const double square = (product[0].hi * product[0].hi + product[1].hi * product[1].hi) +
                          (product[2].hi * product[2].hi + product[3].hi * product[3].hi);
    const double factor = square < 0.25 ? 2.0 : (square >= 4.0 ? 0.5 : 1.0);
    for (Real& component : product) {
        component = scaled(component, factor);
    }
}

void turn(const ExactQuaternion& by, bool from_the_left, BasicRotations<Real>& rotations, std::size_t rows) noexcept {
    const Real constant[4] = {{by.hi[0], by.lo[0]}, {by.hi[1], by.lo[1]}, {by.hi[2], by.lo[2]}, {by.hi[3], by.lo[3]}};
    for (std::size_t i = 0; i < rows; ++i) {
        Real own[4];
        Real product[4];
        rotations.get(i, own);
        multiply(from_the_left ? constant : own, from_the_left ? own : constant, product);
        rotations.set(i, product);
    }
}

void invert(BasicRotations<Real>& rotations, std::size_t rows) noexcept {
    for (std::size_t i = 0; i < rows; ++i) {
        rotations.w.set(i, -rotations.w[i]);
    }
}

void convert(const ExactBatch& batch, const double* in, std::size_t rows, Readings& rounded, double* out,
             DiagnosticSet* diagnostics) noexcept {
    BasicReadings<Real> readings;
    read_by(batch_codec_of(batch.from->name).exact, *batch.from, in, rows, readings);
    if (batch.from->passive != batch.to->passive) {
        invert(readings, rows);
    }
    if (batch.left != nullptr) {
        turn(*batch.left, true, readings, rows);
    }
    if (batch.right != nullptr) {
        turn(*batch.right, false, readings, rows);
    }
    batch_codec_of(batch.to->name).exact.write(*batch.to, batch.lock_margin, readings, rows, out, diagnostics);
    for (std::size_t i = 0; i < rows; ++i) {
        rounded.set(i, readings.w.hi[i], readings.x.hi[i], readings.y.hi[i], readings.z.hi[i]);
        rounded.defect[i] = readings.defect[i];
        rounded.error[i] = readings.error[i];
    }
}

void read_upright(const Spec& spec, const double* numbers, std::size_t rows, BasicReadings<Real>& readings) noexcept {
    read_by(batch_codec_of(spec.name).exact, spec, numbers, rows, readings);
    if (spec.passive) {
        invert(readings, rows);
    }
}

void relate(const RelativeBatch& batch, const double* in, const double* reference, std::size_t rows, double* out,
            DiagnosticSet* diagnostics) noexcept {
    BasicReadings<Real> readings;
    BasicReadings<Real> references;
    read_upright(*batch.from, in, rows, readings);
    read_upright(*batch.reference, reference, rows, references);
    invert(references, rows);
    BasicRotations<Real> relative;
    for (std::size_t i = 0; i < rows; ++i) {
        Real own[4];
        Real other[4];
        Real product[4];
        readings.get(i, own);
        references.get(i, other);
        const bool from_the_left = batch.frame == Frame::body;
        multiply(from_the_left ? other : own, from_the_left ? own : other, product);
        relative.set(i, product);
    }
    if (batch.to->passive) {
        invert(relative, rows);
    }
    batch_codec_of(batch.to->name).exact.write(*batch.to, batch.lock_margin, relative, rows, out, diagnostics);
}

void read_exactly(const Spec& spec, const double* numbers, ExactQuaternion& attitude) noexcept {
    BasicReadings<Real> readings;
    read_by(batch_codec_of(spec.name).exact, spec, numbers, 1, readings);
    Real q[4];
    readings.get(0, q);
    for (std::size_t k = 0; k < 4; ++k) {
        attitude.hi[k] = q[k].hi;
        attitude.lo[k] = q[k].lo;
    }
}

} // namespace

template <> void read_plain(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept {
    codec_of(spec.name).read(spec, numbers, rows, readings);
}

template <>
void read_plain(const Spec& spec, const double* numbers, std::size_t rows, BasicReadings<Real>& readings) noexcept {
    Readings plain;
    codec_of(spec.name).read(spec, numbers, rows, plain);
    for (std::size_t i = 0; i < rows; ++i) {
        readings.set(i, plain.w[i], plain.x[i], plain.y[i], plain.z[i]);
        readings.defect[i] = plain.defect[i];
        readings.error[i] = plain.error[i];
    }
    readings.as_given = plain.as_given;
}

} // namespace ROTCONV_TARGET

#define ROTCONV_FUNCTIONS_OF(target) ROTCONV_JOINED(functions_of_, target)
#define ROTCONV_JOINED(a, b) a##b
extern const BatchFunctions ROTCONV_FUNCTIONS_OF(ROTCONV_TARGET);
constinit const BatchFunctions ROTCONV_FUNCTIONS_OF(ROTCONV_TARGET){.read = read,
                                                                    .write = write,
                                                                    .read_one = read_one,
                                                                    .write_one = write_one,
                                                                    .convert = convert,
                                                                    .relate = relate,
                                                                    .read_exactly = read_exactly};

} // namespace rotconv
