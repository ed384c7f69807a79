#include "kernels.hpp"

namespace rotconv {

extern const KernelTable kernels_of_any_processor;
#ifdef ROTCONV_HAS_FMA_TARGET
extern const KernelTable kernels_of_avx2_fma;
#endif

const KernelTable& kernel_table() noexcept {
#ifdef ROTCONV_HAS_FMA_TARGET
    static const bool has_fma =
        static_cast<bool>(__builtin_cpu_supports("avx2")) && static_cast<bool>(__builtin_cpu_supports("fma"));
    return has_fma ? kernels_of_avx2_fma : kernels_of_any_processor;
#else
    return kernels_of_any_processor;
#endif
}

Reading read_row(const Spec& spec, const double* numbers) noexcept {
    double q[4];
    double defect = 0.0;
    const Error error = kernel_table().read_one(spec, numbers, q, defect);
    return error == Error::none
               ? Reading(Rotation::near_unit(alone(q[0]), alone(q[1]), alone(q[2]), alone(q[3])), defect)
               : Reading(error);
}

DiagnosticSet write_row(const Spec& spec, const Rotation& rotation, double* numbers, double lock_margin) noexcept {
    // As it is: stored again it would have to be waited for.
    // NOLINTNEXTLINE(*-reinterpret-cast)
    const auto& q = *reinterpret_cast<const double(*)[4]>(rotation.components().data());
    return kernel_table().write_one(spec, lock_margin, q, numbers);
}

} // namespace rotconv
