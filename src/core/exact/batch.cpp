#include "../exact_batch.hpp"

#include "../representations/codec.hpp"
#include "codec.hpp"

namespace rotconv::ROTCONV_EXACT {

extern const ExactFunctions functions;

namespace {

const ExactCodec& exact_codec_of(RepresentationId name) noexcept {
#define ROTCONV_LINE(id) &codecs::id,
    static constexpr const ExactCodec* table[] = {ROTCONV_REPRESENTATIONS(ROTCONV_LINE)};
#undef ROTCONV_LINE
    return *table[static_cast<std::size_t>(name)];
}

void write_plain(const Spec& spec, double lock_margin, const Rotations& rotations, std::size_t rows, double* numbers,
                 DiagnosticSet* diagnostics) noexcept {
    rotconv::Rotations rounded; // NOLINT(*-member-init): as many rows as there are
    for (std::size_t i = 0; i < rows; ++i) {
        rounded.w.data()[i] = rotations.w.hi[i];
        rounded.x.data()[i] = rotations.x.hi[i];
        rounded.y.data()[i] = rotations.y.hi[i];
        rounded.z.data()[i] = rotations.z.hi[i];
    }
    codec_of(spec.name).write(spec, lock_margin, rounded, rows, numbers, diagnostics);
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

void turn(const ExactQuaternion& by, bool from_the_left, Rotations& rotations, std::size_t rows) noexcept {
    const Real constant[4] = {{by.hi[0], by.lo[0]}, {by.hi[1], by.lo[1]}, {by.hi[2], by.lo[2]}, {by.hi[3], by.lo[3]}};
    for (std::size_t i = 0; i < rows; ++i) {
        const Real own[4] = {rotations.w[i], rotations.x[i], rotations.y[i], rotations.z[i]};
        Real product[4];
        multiply(from_the_left ? constant : own, from_the_left ? own : constant, product);
        rotations.set(i, product[0], product[1], product[2], product[3]);
    }
}

void read_rows(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept {
    const ExactCodec& codec = exact_codec_of(spec.name);
    (codec.read != nullptr ? codec.read : read_plain)(spec, numbers, rows, readings);
}

void convert(const ExactBatch& batch, const double* in, std::size_t rows, rotconv::Readings& rounded, double* out,
             DiagnosticSet* diagnostics) noexcept {
    Readings readings; // NOLINT(*-member-init)
    read_rows(*batch.from, in, rows, readings);
    if (batch.from->passive != batch.to->passive) {
        for (std::size_t i = 0; i < rows; ++i) {
            readings.w.set(i, -readings.w[i]);
        }
    }
    if (batch.left != nullptr) {
        turn(*batch.left, true, readings, rows);
    }
    if (batch.right != nullptr) {
        turn(*batch.right, false, readings, rows);
    }
    const ExactCodec& to = exact_codec_of(batch.to->name);
    (to.write != nullptr ? to.write : write_plain)(*batch.to, batch.lock_margin, readings, rows, out, diagnostics);
    for (std::size_t i = 0; i < rows; ++i) {
        rounded.w.data()[i] = readings.w.hi[i];
        rounded.x.data()[i] = readings.x.hi[i];
        rounded.y.data()[i] = readings.y.hi[i];
        rounded.z.data()[i] = readings.z.hi[i];
        rounded.defect.data()[i] = readings.defect[i];
        rounded.error.data()[i] = readings.error[i];
    }
}

void read_row(const Spec& spec, const double* numbers, ExactQuaternion& attitude) noexcept {
    Readings readings; // NOLINT(*-member-init)
    read_rows(spec, numbers, 1, readings);
    const Real q[4] = {readings.w[0], readings.x[0], readings.y[0], readings.z[0]};
    for (std::size_t k = 0; k < 4; ++k) {
        attitude.hi[k] = q[k].hi;
        attitude.lo[k] = q[k].lo;
    }
}

} // namespace

void read_plain(const Spec& spec, const double* numbers, std::size_t rows, Readings& readings) noexcept {
    rotconv::Readings plain; // NOLINT(*-member-init)
    codec_of(spec.name).read(spec, numbers, rows, plain);
    for (std::size_t i = 0; i < rows; ++i) {
        readings.set(i, plain.w.data()[i], plain.x.data()[i], plain.y.data()[i], plain.z.data()[i]);
        readings.defect[i] = plain.defect.data()[i];
        readings.error[i] = plain.error.data()[i];
    }
}

constinit const ExactFunctions functions{.convert = convert, .read = read_row};

} // namespace rotconv::ROTCONV_EXACT
