#include "exact_batch.hpp"

namespace rotconv {

namespace exact_plain {
extern const ExactFunctions functions;
} // namespace exact_plain

#ifdef ROTCONV_EXACT_FMA
namespace exact_fma {
extern const ExactFunctions functions;
} // namespace exact_fma
#endif

const ExactFunctions& exact_functions() noexcept {
#ifdef ROTCONV_EXACT_FMA
    static const bool has_fma =
        static_cast<bool>(__builtin_cpu_supports("avx2")) && static_cast<bool>(__builtin_cpu_supports("fma"));
    return has_fma ? exact_fma::functions : exact_plain::functions;
#else
    return exact_plain::functions;
#endif
}

} // namespace rotconv
