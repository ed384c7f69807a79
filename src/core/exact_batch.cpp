#include "exact_batch.hpp"

namespace rotconv {

namespace exact_plain {
ConvertExactly convert;
} // namespace exact_plain

#ifdef ROTCONV_EXACT_FMA
namespace exact_fma {
ConvertExactly convert;
} // namespace exact_fma
#endif

ConvertExactly* exact_conversion() noexcept {
#ifdef ROTCONV_EXACT_FMA
    static const bool has_fma = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
    return has_fma ? exact_fma::convert : exact_plain::convert;
#else
    return exact_plain::convert;
#endif
}

} // namespace rotconv
