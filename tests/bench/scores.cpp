#include "scores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

namespace bench {

using rotconv::RepresentationId;

namespace {

std::string digits(std::span<const double> row) { return fmt::format("{:.17g}", fmt::join(row, " ")); }

/// Error in eps of one result; nan where it is no attitude.
double error_of(const Sample& sample, std::size_t i, std::span<const double> result, double& relative) {
    const bool finite = std::ranges::all_of(result, [](double v) { return std::isfinite(v); });
    if (!finite) {
        // an infinite vector without nan says that this is a half-turn
        const bool half_turn = sample.to.name == RepresentationId::cayley &&
                               std::ranges::none_of(result, [](double v) { return std::isnan(v); });
        return half_turn ? static_cast<double>(2 * abs(sample.exact[i].w())) / oracle::eps : none;
    }
    const auto attitude = oracle::attitude(sample.to, result);
    if (sample.relative && sample.exact[i].vec().norm() > 0) {
        relative = std::fmax(relative, oracle::relative_error_in_eps(sample.exact[i], attitude));
    }
    return oracle::error_in_eps(sample.exact[i], attitude);
}

} // namespace

void Score::add(const Score& other) {
    if ((other.not_finite > 0 && not_finite == 0) || (not_finite == 0 && !(other.worst <= worst))) {
        where = other.where.empty() ? where : other.where;
    }
    rows += other.rows;
    not_finite += other.not_finite;
    squares += other.squares;
    worst = std::fmax(worst, other.worst);
    relative = std::fmax(relative, other.relative);
    defect = std::fmax(defect, other.defect);
}

double Score::rms() const {
    return rows == not_finite ? none : std::sqrt(squares / static_cast<double>(rows - not_finite));
}

Score score(const Sample& sample, const Way& way) {
    Score made;
    made.rows = sample.rows.size();
    std::array<double, 9> numbers{};
    const std::span result(numbers.data(), sample.to.size());
    const Convert convert = way.between(sample.from, sample.to, sample.hostile);
    for (std::size_t i = 0; i < sample.rows.size(); ++i) {
        convert(sample.rows[i].data(), 1, numbers.data());
        const double error = error_of(sample, i, result, made.relative);
        if (std::isnan(error)) {
            if (++made.not_finite == 1) {
                made.where = digits(sample.rows[i]);
            }
            continue;
        }
        if (sample.to.name == RepresentationId::dcm) {
            made.defect = std::fmax(made.defect, static_cast<double>(oracle::defect(sample.to, result)) / oracle::eps);
        }
        made.squares += error * error;
        if (!(error <= made.worst)) {
            made.worst = error;
            made.where = made.not_finite > 0 ? made.where : digits(sample.rows[i]);
        }
    }
    return made;
}

} // namespace bench
