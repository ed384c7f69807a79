#include "codec.hpp"
#include "columns.hpp"
#include "matrix.hpp"
#include "rows.hpp"

namespace rotconv::ROTCONV_EXACT {
namespace {

struct TwoColumns {
    static constexpr std::size_t size = 6;

    template <class T> ROTCONV_INLINE static void apply(const T (&q)[4], T (&numbers)[6]) noexcept {
        T m[9];
        scaled_matrix_of(q, m);
        const T inverse = T(1.0) / squared_norm(q);
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[k] = m[3 * k] * inverse;
            numbers[3 + k] = m[3 * k + 1] * inverse;
        }
    }

    /// The columns themselves.
    template <class T> ROTCONV_INLINE static void directions(const T (&m)[6], T (&first)[3], T (&second)[3]) noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            first[k] = m[k];
            second[k] = m[3 + k];
        }
    }
};

void write(const Spec& /*spec*/, double /*lock_margin*/, const Rotations& rotations, std::size_t rows, double* numbers,
           DiagnosticSet* /*diagnostics*/) noexcept {
    write_rows<TwoColumns>(rotations, rows, numbers);
}

} // namespace

constinit const ExactCodec codecs::two_column{.read = read_columns<TwoColumns>, .write = write};

} // namespace rotconv::ROTCONV_EXACT
