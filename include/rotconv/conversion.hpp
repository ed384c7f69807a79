#pragma once

#include <cstddef>
#include <span>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// What a conversion gives up, and what it looks for.
struct Settings {
    double tolerance = 1e-3; ///< largest defect that is accepted, from 0 to infinity; see Reading::defect
    double lock_margin = euler::default_lock_margin; ///< radians, from 0; see euler::from_rotation()
    bool sensitivity = false;                        ///< margin, condition and the exact defect for every row
};

/// What is known of one converted row.
struct Report {
    Error error = Error::none;
    DiagnosticSet diagnostics;
    double defect = 0.0;       ///< below `reported_defect` and without Settings::sensitivity only an upper bound
    Sensitivity sensitivity{}; ///< where there are diagnostics or Settings::sensitivity asks for them
    double deviation = 0.0;    ///< angle in radians by which the numbers may be off, where whoever made them says so
};

struct Codec;

/// A way from one representation to another, resolved once and then run over batches of rows.
/// Thread-safe: running it changes nothing in it.
class Conversion {
public:
    Conversion(const Spec& from, const Spec& to, const Settings& settings = {});

    [[nodiscard]] const Spec& from() const noexcept { return from_; }
    [[nodiscard]] const Spec& to() const noexcept { return to_; }

    /// Converts reports.size() rows of from().size() numbers each into rows of to().size() numbers. The numbers of a
    /// row with a error become nan. No number becomes -0.
    /// @pre in.size() >= rows * from().size() and out.size() >= rows * to().size()
    void run(std::span<const double> in, std::span<double> out, std::span<Report> reports) const noexcept;

private:
    void run_batch(const double* in, double* out, std::span<Report> reports) const noexcept;
    [[nodiscard]] Report report(const Reading& reading, DiagnosticSet diagnostics,
                                const double* numbers) const noexcept;

    Spec from_;
    Spec to_;
    Settings settings_;
    const Codec* in_codec_;
    const Codec* out_codec_;
};

} // namespace rotconv
