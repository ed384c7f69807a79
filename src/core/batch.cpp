#include "batch.hpp"

namespace rotconv {

extern const BatchFunctions functions_of_any_processor;
#ifdef ROTCONV_HAS_FMA_TARGET
extern const BatchFunctions functions_of_avx2_fma;
#endif

const BatchFunctions& batch_functions() noexcept {
#ifdef ROTCONV_HAS_FMA_TARGET
    static const bool has_fma =
        static_cast<bool>(__builtin_cpu_supports("avx2")) && static_cast<bool>(__builtin_cpu_supports("fma"));
    return has_fma ? functions_of_avx2_fma : functions_of_any_processor;
#else
    return functions_of_any_processor;
#endif
}

Reading read_row(const Spec& spec, const double* numbers) noexcept {
    Readings one; // NOLINT(*-member-init)
    batch_functions().read(spec, numbers, 1, one);
    return one.reading(0);
}

DiagnosticSet write_row(const Spec& spec, const Rotation& rotation, double* numbers, double lock_margin) noexcept {
    Rotations one; // NOLINT(*-member-init): the other rows
    one.set(0, rotation);
    DiagnosticSet diagnostics;
    batch_functions().write(spec, lock_margin, one, 1, numbers, &diagnostics);
    return diagnostics;
}

} // namespace rotconv
