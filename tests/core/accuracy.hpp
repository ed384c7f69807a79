#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/conversion.hpp>

/// The accuracy that conversions in plain double arithmetic are held to, and how it is checked: one table, one way to
/// measure. Matrices and columns have a defect of up to 1e-3, rotation vectors a length of up to 1e15.
namespace accuracy {

/// A way between the quaternion and a representation.
struct Way {
    std::string from;
    std::string to;
    double limit; ///< eps = 2^-52 radians of attitude error: the worst that is known, and 12 to 35 % more
    double worst; ///< the worst that a search found, by a Conversion or a typed call; its row is in worst_cases_test
};

/// The table. `euler` stands for all 24 sequences.
const std::vector<Way>& ways();

/// All Euler sequences with all signs, as text: 192.
std::vector<std::string> signed_sequences();
/// SPECs of every representation, as it is and with each of its modifiers; of one that takes a sequence, with a
/// sequence of each kind.
std::vector<std::string> all_specs();
/// The same with all its modifiers together that say something new, and every sequence.
std::vector<std::string> combined_specs();

/// Whether the table has ways from and to the representation. The oracle then knows its definition.
bool has_limits(rotconv::RepresentationId name);

/// The limit of the way from or to `spec` and the quaternion.
/// @pre has_limits(spec.name)
double limit_from(const rotconv::Spec& spec);
double limit_to(const rotconv::Spec& spec);

/// The worst row of a sample.
struct Worst {
    double error = 0.0; ///< eps; infinite where the result is not finite
    std::string where;
};

/// A conversion of one row of numbers.
using Convert = std::function<std::vector<double>(std::span<const double>)>;

/// rotconv's own, with a lock margin of 0 and any tolerance.
Convert own(const rotconv::Spec& from, const rotconv::Spec& to);
/// The same in plain double arithmetic, which the limits are of.
Convert fast(const rotconv::Spec& from, const rotconv::Spec& to);

/// Input rows for a way: all strata, about `size` rows in each. Rows of numbers that have no finite form in `from` are
/// left out.
std::vector<std::vector<double>> inputs(const rotconv::Spec& from, const rotconv::Spec& to, int size);

/// Attitude error of `convert` over the rows, against the oracle. An infinite result is an infinite error, but of
/// cayley without a nan, where it says that this is a half-turn: then the error is what the attitude lacks to one.
Worst worst_error(const rotconv::Spec& from, const rotconv::Spec& to, const Convert& convert,
                  const std::vector<std::vector<double>>& rows);

/// The worst of a way of the table; of `euler`, over all sequences, in radians or degrees.
Worst worst_of(const Way& way, int size, rotconv::AngleUnit unit = rotconv::AngleUnit::radians);

/// The SPEC, which must be one.
rotconv::Spec spec(std::string_view text);

/// Rows of numbers converted, and the first report, which is empty where there is nothing to tell.
struct Converted {
    std::vector<double> numbers;
    rotconv::RowReport report;
};
Converted converted(const rotconv::Spec& from, const rotconv::Spec& to, std::span<const double> rows,
                    const rotconv::ConversionSettings& settings = {});

/// The numbers in all their digits, a blank before each.
std::string text_of(std::span<const double> row);
/// A page of the project.
std::string text_of(const char* path);

/// One row of both.
std::vector<double> joined(std::vector<double> first, const std::vector<double>& second);

} // namespace accuracy
