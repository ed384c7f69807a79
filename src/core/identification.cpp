#include <rotconv/identification.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Eigenvalues>

#include "representations/codec.hpp"
#include "representations/half_turn.hpp"

namespace rotconv {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A candidate is dropped at an angle of more than so many times the limit.
constexpr double far = 1e3;
/// A smaller part of the whole is rounding.
constexpr double rounding = 1e-7;

using Columns = std::array<std::uint8_t, 9>;

/// All SPECs of the representation, those with the fewest modifiers first; of several, `passive` last.
std::vector<Spec> specs_of(const Representation& entry) {
    constexpr std::array modifiers{Modifier::deg, Modifier::col, Modifier::xyzw, Modifier::passive};
    std::array<unsigned, 1U << modifiers.size()> choices{}; // a bit for each modifier
    std::iota(choices.begin(), choices.end(), 0U);
    std::ranges::stable_sort(choices, {}, [](unsigned choice) { return std::popcount(choice); });
    std::vector<Spec> specs;
    for (const unsigned choice : choices) {
        const auto has = [choice](std::size_t i) { return (choice >> i & 1U) != 0; };
        bool has_meaning = true;
        for (std::size_t i = 0; i < modifiers.size(); ++i) {
            has_meaning = has_meaning && (!has(i) || entry.modifiers.has(modifiers.at(i)));
        }
        if (!has_meaning) {
            continue;
        }
        Spec spec{.name = entry.name,
                  .unit = has(0) ? AngleUnit::degrees : AngleUnit::radians,
                  .passive = has(3),
                  .column_major = has(1),
                  .scalar_last = has(2)};
        if (!entry.takes_sequence) {
            specs.push_back(spec);
            continue;
        }
        for (const EulerSequence sequence : EulerSequence::all()) {
            spec.sequence = sequence;
            specs.push_back(spec);
        }
    }
    return specs;
}

/// All candidates, preferred names first.
std::vector<Candidate> candidates_of(std::size_t count, std::optional<RepresentationId> name) {
    std::vector<Candidate> candidates;
    for (const RepresentationId id : all_representations) {
        const Representation& entry = representation(id);
        const bool is_wanted = name ? id == *name : id != RepresentationId::rpy; // which is one of the sequences
        if (!is_wanted || entry.size != count) {
            continue;
        }
        const bool any_order = entry.has_gimbal_lock || id == RepresentationId::quat;
        for (const Spec& spec : specs_of(entry)) {
            Columns columns{};
            std::iota(columns.begin(), columns.end(), std::uint8_t{0});
            do {
                candidates.push_back({.spec = spec, .columns = columns});
            } while (any_order && std::next_permutation(columns.begin(), columns.begin() + static_cast<int>(count)));
        }
    }
    std::ranges::stable_sort(candidates, {}, &Candidate::columns);
    return candidates;
}

Rotation rotation_at(const std::vector<double>& quaternions, std::size_t row) noexcept {
    const double* q = quaternions.data() + 4 * row;
    return Rotation::near_unit(q[0], q[1], q[2], q[3]);
}

double angle_between(const Rotation& a, const Rotation& b) noexcept { return angle_of(a * b.inverse()); }

/// Nearer than 3e-6 radians. Generic numbers are not that near in two candidates that differ in meaning.
bool are_same(const Rotation& a, const Rotation& b) noexcept {
    const double cosine = (a.w() * b.w() + a.x() * b.x()) + (a.y() * b.y() + a.z() * b.z());
    return std::fabs(cosine) > 1.0 - 1e-12;
}

/// Two rows of numbers whose attitudes are equal only in candidates that mean the same.
std::vector<double> generic_numbers(const Spec& spec) {
    std::vector<double> numbers;
    for (const Rotation& rotation : {Rotation::near_unit(0.83, 0.31, -0.42, 0.17), //
                                     Rotation::near_unit(0.29, -0.37, 0.71, 0.53)}) {
        std::array<double, most_numbers> row{};
        write_row(spec.in_degrees(), rotation, row.data());
        numbers.insert(numbers.end(), row.begin(), row.begin() + static_cast<std::ptrdiff_t>(spec.size()));
    }
    return numbers;
}

/// Puts the unknown numbers of each row in the order of the candidate.
void order(const Candidate& candidate, const double* numbers, std::size_t width, std::size_t rows,
           std::vector<double>& ordered) {
    const std::size_t size = candidate.spec.size();
    ordered.resize(rows * size);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t i = 0; i < size; ++i) {
            ordered[row * size + i] = numbers[row * width + candidate.columns.at(i)];
        }
    }
}

} // namespace

Identification::Identification(std::size_t count, const Spec& known, std::optional<RepresentationId> name,
                               const IdentificationSettings& settings)
    : count_(count), settings_(settings), known_conversion_(known, Spec{}, {.tolerance = settings.tolerance}) {
    const auto candidates = candidates_of(count, name);
    const std::vector<double> generic =
        candidates.empty() ? std::vector<double>() : generic_numbers(candidates[0].spec);
    const std::size_t rows = generic.size() / std::max<std::size_t>(count, 1);
    std::vector<std::vector<double>> attitudes; // of the trials
    std::vector<double> own(rows * 4);
    for (const Candidate& candidate : candidates) {
        order(candidate, generic.data(), count, rows, ordered_);
        Conversion(candidate.spec, Spec{}, {.tolerance = infinity}).run(ordered_, own, found_);
        const bool is_new = std::ranges::none_of(attitudes, [&](const std::vector<double>& others) {
            bool all_same = true;
            for (std::size_t i = 0; i < rows; ++i) {
                all_same = all_same && are_same(rotation_at(own, i), rotation_at(others, i));
            }
            return all_same;
        });
        if (is_new) {
            attitudes.push_back(own);
            living_.push_back(trials_.size());
            trials_.push_back({candidate, Conversion(candidate.spec, Spec{}, {.tolerance = settings.tolerance})});
        }
    }
}

bool Identification::is_count(std::size_t count) noexcept {
    return std::ranges::any_of(all_representations,
                               [count](RepresentationId id) { return representation(id).size == count; });
}

void Identification::add(std::span<const double> numbers, std::span<const std::size_t> rows,
                         std::vector<RowReport>& reports) {
    const std::size_t width = count_ + known_conversion_.from().size();
    known_numbers_.clear();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto known = numbers.subspan(i * width + count_, width - count_);
        known_numbers_.insert(known_numbers_.end(), known.begin(), known.end());
    }
    known_.resize(4 * rows.size());
    known_conversion_.run(known_numbers_, known_, reports);
    std::ranges::for_each(reports, [](RowReport& report) {
        report.of_reference = true;
        report.reference_defect = report.error == Error::none ? std::exchange(report.defect, 0.0) : 0.0;
    });
    // Few of the first rows at a time, because most candidates are dropped there.
    for (std::size_t first = 0; first < rows.size();) {
        const std::size_t count = std::min({rows.size() - first, batch_rows, std::max<std::size_t>(rows_, 1)});
        try_rows(numbers, rows, first, count, reports);
        first += count;
    }
}

void Identification::try_rows(std::span<const double> numbers, std::span<const std::size_t> rows, std::size_t first,
                              std::size_t count, std::vector<RowReport>& reports) {
    const std::size_t width = count_ + known_conversion_.from().size();
    angles_.resize(trials_.size() * count);
    for (const std::size_t trial : living_) {
        measure(trials_[trial], numbers, first, count, angles_.data() + trial * count);
    }
    for (std::size_t row = 0; row < count; ++row) {
        const std::size_t at = first + row;
        if (std::isnan(known_[4 * at])) {
            continue;
        }
        const double* row_numbers = numbers.data() + at * width;
        const auto cannot_read = [&](std::size_t trial) { return angles_[trial * count + row] == infinity; };
        if (!living_.empty() && std::ranges::all_of(living_, cannot_read)) {
            const RowReport refused = refusal(trials_[living_.front()], row_numbers);
            auto place = std::ranges::lower_bound(reports, at, {}, &RowReport::row);
            if (place == reports.end() || place->row != at) {
                place = reports.insert(place, RowReport());
            }
            *place = {.row = at, .error = refused.error, .defect = refused.defect};
            continue;
        }
        ++rows_;
        remember(row_numbers, rotation_at(known_, at));
        std::erase_if(living_, [&](std::size_t trial) {
            Candidate& candidate = trials_[trial].candidate;
            const double angle = angles_[trial * count + row];
            if (++candidate.rows == 1 || angle > candidate.angle) {
                candidate.angle = angle;
                candidate.angle_row = rows[at];
            }
            return angle > far * settings_.within;
        });
    }
}

void Identification::measure(const Trial& trial, std::span<const double> numbers, std::size_t first, std::size_t count,
                             double* angles) {
    const std::size_t width = count_ + known_conversion_.from().size();
    order(trial.candidate, numbers.data() + first * width, width, count, ordered_);
    tried_.resize(4 * count);
    trial.conversion.run(ordered_, tried_, found_);
    for (std::size_t i = 0; i < count; ++i) {
        angles[i] = angle_between(rotation_at(tried_, i), rotation_at(known_, first + i));
    }
    for (const RowReport& report : found_) {
        if (report.error != Error::none) {
            angles[report.row] = infinity;
        }
    }
}

RowReport Identification::refusal(const Trial& trial, const double* numbers) {
    order(trial.candidate, numbers, count_, 1, ordered_);
    tried_.resize(4);
    trial.conversion.run(ordered_, tried_, found_);
    return found_.front();
}

void Identification::remember(const double* numbers, const Rotation& known) {
    first_ = rows_ == 1 ? known : first_;
    spread_ = std::max(spread_, angle_between(known, first_));
    greatest_angle_ = std::max(greatest_angle_, angle_of(known));
    const Eigen::Vector3d u(known.x(), known.y(), known.z());
    scatter_ += u * u.transpose();
    for (std::size_t i = 0; i < count_; ++i) {
        greatest_numbers_.at(i) = std::max(greatest_numbers_.at(i), std::fabs(numbers[i]));
        for (std::size_t k = i + 1; k < count_; ++k) {
            double& difference = greatest_differences_.at(i).at(k);
            difference = std::max(difference, std::fabs(numbers[i] - numbers[k]));
        }
    }
}

std::vector<Candidate> Identification::best_first() const {
    std::vector<Candidate> candidates;
    std::ranges::transform(trials_, std::back_inserter(candidates), &Trial::candidate);
    std::ranges::stable_sort(candidates, {}, [](const Candidate& candidate) {
        return std::pair(-static_cast<double>(candidate.rows), candidate.angle);
    });
    return candidates;
}

Verdict Identification::verdict() const {
    Verdict verdict;
    verdict.fitting = static_cast<std::size_t>(
        std::ranges::count_if(trials_, [this](const Trial& trial) { return fits(trial.candidate); }));
    if (verdict.fitting > 1) {
        verdict.ambiguity = ambiguity(verdict);
    }
    return verdict;
}

Verdict::Ambiguity Identification::ambiguity(Verdict& verdict) const {
    using Ambiguity = Verdict::Ambiguity;
    if (rows_ == 1) {
        return Ambiguity::rows;
    }
    if (spread_ <= settings_.within) {
        return Ambiguity::attitudes;
    }
    // SPECs of small attitudes differ by half the angle's square.
    verdict.angle = greatest_angle_;
    if (greatest_angle_ * greatest_angle_ <= 4.0 * settings_.within) {
        return Ambiguity::size;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter_ / static_cast<double>(rows_));
    const Eigen::Vector3d sines = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt(); // of half angles, increasing
    if (2.0 * sines[1] <= std::max(settings_.within, rounding)) {
        verdict.axis = solver.eigenvectors().col(2);
        Eigen::Index leader = 0;
        verdict.axis.cwiseAbs().maxCoeff(&leader);
        verdict.axis *= std::copysign(1.0, verdict.axis[leader]);
        return Ambiguity::axes;
    }
    const double greatest = *std::ranges::max_element(greatest_numbers_);
    const auto is_none = [greatest](double size) { return size <= rounding * greatest; };
    for (std::size_t i = 0; i < count_; ++i) {
        if (is_none(greatest_numbers_.at(i))) {
            verdict.column = i;
            return Ambiguity::zero;
        }
    }
    for (std::size_t i = 0; i < count_; ++i) {
        for (std::size_t k = i + 1; k < count_; ++k) {
            if (is_none(greatest_differences_.at(i).at(k))) {
                verdict.column = i;
                verdict.other = k;
                return Ambiguity::equal;
            }
        }
    }
    return Ambiguity::difference;
}

} // namespace rotconv
