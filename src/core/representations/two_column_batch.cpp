#include "columns_batch.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

struct FirstTwoColumns : ReadByColumns<FirstTwoColumns, 6>, WrittenByFormula<FirstTwoColumns, 6> {
    ROTCONV_INLINE static ErrorBound error_of(const double (&/*q*/)[4], double off) noexcept {
        return error_of_entries(off);
    }
    template <class T> ROTCONV_INLINE static void numbers_of(const T (&q)[4], T (&numbers)[6]) noexcept {
        T m[9];
        scaled_matrix_of(q, m);
        for (std::size_t k = 0; k < 3; ++k) {
            numbers[k] = m[3 * k];
            numbers[3 + k] = m[3 * k + 1];
        }
        divide_entries(numbers, squared_norm(q));
    }

    template <class T> ROTCONV_INLINE static void directions(const T (&m)[6], T (&first)[3], T (&second)[3]) noexcept {
        load(m, first);
        load(m + 3, second);
    }
    ROTCONV_INLINE static double lost_by_directions(const double (&/*m*/)[6]) noexcept { return 1.0; }
    ROTCONV_INLINE static void columns(const double (&numbers)[6], double (&m)[6]) noexcept { load(numbers, m); }
};

} // namespace

constinit const Kernel kernels::two_column = []() noexcept {
    Kernel kernel = kernel_of_formula<FirstTwoColumns>;
    kernel.column = 3;
    return kernel;
}();

} // namespace ROTCONV_TARGET
} // namespace rotconv
