#include "codec.hpp"
#include "columns.hpp"
#include "matrix.hpp"
#include "rows.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct TwoColumns {
    static constexpr std::size_t size = 6;

    template <class T> ROTCONV_INLINE static void apply(const T (&q)[4], T (&numbers)[6]) noexcept {
        T m[9];
        scaled_matrix_of(q, m);
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[k] = m[3 * k];
            numbers[3 + k] = m[3 * k + 1];
        }
        divide_entries(numbers, squared_norm(q));
    }

    /// The columns themselves.
    template <class T> ROTCONV_INLINE static void directions(const T (&m)[6], T (&first)[3], T (&second)[3]) noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            first[k] = m[k];
            second[k] = m[3 + k];
        }
    }
};

template <class T> void write(const Spec& /*spec*/, double /*lock_margin*/, const BasicRotations<T>& rotations,
                              std::size_t rows, double* numbers, DiagnosticSet* /*diagnostics*/) noexcept {
    write_rows<TwoColumns>(rotations, rows, numbers);
}

} // namespace

constinit const BatchCodec batch_codecs::two_column{.fast = {.read = nullptr, .write = write<double>},
                                                    .exact = {.read = read_columns<TwoColumns>, .write = write<Real>}};

} // namespace ROTCONV_TARGET
} // namespace rotconv
