#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <rotconv/reading.hpp>
#include <rotconv/spec.hpp>

namespace rotconv {

/// An attitude that others are turned by, to 106 bits.
struct ConstantTurn {
    ConstantTurn(const Rotation& constant, const std::array<double, 4>& more = {}) noexcept
        : rotation(constant), rest(more) {}

    /// That of one row of numbers.
    /// @pre read_attitude() has a rotation of it
    [[nodiscard]] static ConstantTurn of_numbers(const Spec& spec, std::span<const double> numbers) noexcept;

    [[nodiscard]] ConstantTurn inverse() const noexcept {
        return {rotation.inverse(), {rest[0], -rest[1], -rest[2], -rest[3]}};
    }

    Rotation rotation;
    std::array<double, 4> rest; ///< what w, x, y, z have more than those of the rotation
};

/// What a conversion gives up, what it looks for, and how it turns the attitudes.
struct Settings {
    double tolerance = 1e-3; ///< largest defect that is accepted, from 0 to infinity; see Reading::defect
    double lock_margin = euler::default_lock_margin; ///< radians, from 0; see euler::from_rotation()
    bool sensitivity = false;                        ///< margin, condition and the exact defect for every row
    std::optional<ConstantTurn> left{};              ///< R becomes left R: other reference axes...
    std::optional<ConstantTurn> right{};             ///< ...or R right: other body axes
    bool fast = false; ///< plain double arithmetic, right to a few eps, in the place of numbers rounded once
};

/// What is to be told of one converted row.
struct Report {
    std::size_t row = 0; ///< its index among the rows of the run
    Error error = Error::none;
    bool of_reference = false; ///< where rows hold two attitudes: the error, and its defect, are those of the second
    DiagnosticSet diagnostics{};
    double defect = 0.0;           ///< below `reported_defect` and without Settings::sensitivity only an upper bound
    Sensitivity sensitivity{};     ///< of a row with diagnostics of its result, or with Settings::sensitivity
    double reference_defect = 0.0; ///< of the second attitude, where rows hold two
    double deviation = 0.0; ///< angle in radians by which the numbers may be off, where whoever made them says so
};

/// The attitude of one row of numbers, with all that the spec says of them.
/// @pre numbers.size() >= spec.size()
[[nodiscard]] Reading read_attitude(const Spec& spec, std::span<const double> numbers) noexcept;

struct Codec;
class ReadBatch;

/// A way from one representation to another, resolved once and then run over batches of rows.
/// Thread-safe: running it changes nothing in it.
class Conversion {
public:
    Conversion(const Spec& from, const Spec& to, const Settings& settings = {});

    [[nodiscard]] const Spec& from() const noexcept { return from_; }
    [[nodiscard]] const Spec& to() const noexcept { return to_; }
    [[nodiscard]] const Settings& settings() const noexcept { return settings_; }

    /// Converts rows of from().size() numbers each into rows of to().size() numbers. The numbers of a row with an error
    /// become nan. But with Settings::fast each number is the double nearest to the exact function of the numbers read.
    /// No number becomes -0.
    /// @param reports become those of the rows with an error or diagnostics, or with Settings::sensitivity of all rows,
    /// in their order. Most rows have none; a vector that is used again is not allocated again
    /// @pre out.size() >= rows * to().size()
    void run(std::span<const double> in, std::span<double> out, std::vector<Report>& reports) const;

private:
    /// At most `batch_rows` rows, of which the first is row `first` of the run.
    void run_batch(const double* in, std::size_t first, std::size_t rows, double* out,
                   std::vector<Report>& reports) const;

    /// Reads them, and writes their numbers in the representation's own order.
    void convert(ReadBatch& readings, std::size_t rows, double* numbers, DiagnosticSet* diagnostics) const;

    Spec from_;
    Spec to_;
    Settings settings_;
    const Codec* out_codec_;
};

} // namespace rotconv
