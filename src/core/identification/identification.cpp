#include "identification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "../checks.hpp"
#include "../representations/codec.hpp"
#include "../representations/rotation_angle.hpp"

namespace rotconv {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A candidate is dropped at an angle of more than so many times the limit, or of more than that, in radians.
constexpr double far = 1e3;
constexpr double farthest = 0.5;

/// All sequences with all signs, those with the fewest first.
std::vector<EulerSequence> sequences() {
    std::vector<EulerSequence> all;
    for (const unsigned signs : {0U, 1U, 2U, 4U, 3U, 5U, 6U, 7U}) {
        for (const EulerSequence sequence : EulerSequence::all()) {
            all.push_back(sequence.with_signs((signs & 1U) != 0, (signs & 2U) != 0, (signs & 4U) != 0));
        }
    }
    return all;
}

/// The number of modifiers and signs.
int complexity(const Spec& spec) noexcept {
    int count = spec.modifiers().count();
    for (const std::size_t i : {0U, 1U, 2U}) {
        count += spec.sequence.sign(i) < 0.0 ? 1 : 0;
    }
    return count;
}

/// All SPECs of the representation, those with the fewest modifiers and signs first; of several, `passive` last.
std::vector<Spec> specs_of(const Representation& entry) {
    constexpr std::array modifiers{Modifier::deg, Modifier::col, Modifier::xyzw, Modifier::passive};
    std::vector<Spec> specs;
    for (unsigned choice = 0; choice < 1U << modifiers.size(); ++choice) { // a bit for each modifier
        ModifierSet chosen;
        for (std::size_t i = 0; i < modifiers.size(); ++i) {
            chosen |= {modifiers.at(i), (choice >> i & 1U) != 0};
        }
        if (!entry.modifiers.has_all(chosen)) {
            continue;
        }
        Spec spec{.name = entry.name};
        spec.apply(chosen);
        if (!entry.takes_sequence) {
            specs.push_back(spec);
            continue;
        }
        for (const EulerSequence sequence : sequences()) {
            spec.sequence = sequence;
            const int signs = complexity({.sequence = sequence});
            if (spec.passive ? signs == 0 : signs < 3) { // with all signs changed it is the inverse
                specs.push_back(spec);
            }
        }
    }
    std::ranges::stable_sort(specs, {}, complexity);
    return specs;
}

/// The orders in which programs list the numbers of a representation.
std::vector<ColumnOrder> orders_of(const Representation& entry) {
    ColumnOrder columns{};
    std::iota(columns.begin(), columns.end(), std::uint8_t{0});
    std::vector<ColumnOrder> orders{columns};
    if (const ColumnOrder& listed = codec_of(entry.name).listed_order; listed != ColumnOrder{}) {
        orders.push_back(listed);
    }
    while (entry.has_gimbal_lock && std::next_permutation(columns.begin(), columns.begin() + 3)) {
        orders.push_back(columns);
    }
    return orders;
}

/// All candidates, preferred names first: a SPEC without signs whose columns are as they stand, then the others.
std::vector<Candidate> candidates_of(std::size_t count, std::optional<RepresentationId> name) {
    std::vector<Candidate> candidates;
    for (const RepresentationId id : all_representations) {
        const Representation& entry = representation(id);
        const bool is_one_sequence = entry.has_gimbal_lock && !entry.takes_sequence;
        const bool is_wanted = name ? id == *name : !is_one_sequence;
        if (!is_wanted || entry.size != count) {
            continue;
        }
        for (Spec spec : specs_of(entry)) {
            const bool is_rpy = !name && entry.takes_sequence && spec.sequence == roll_pitch_yaw;
            spec.name = is_rpy ? RepresentationId::rpy : spec.name;
            for (const ColumnOrder& columns : orders_of(entry)) {
                // Intrinsic turns are the extrinsic ones with the columns reversed.
                if (!entry.takes_sequence || columns[0] < columns[2]) {
                    candidates.push_back({.spec = spec, .columns = columns});
                }
            }
        }
    }
    std::ranges::stable_sort(candidates, {},
                             [](const Candidate& each) { return std::pair(!each.is_plain(), each.columns); });
    return candidates;
}

/// Numbers by which attitudes are compared, to 1e-6, whatever the signs of the quaternions: generic ones differ by more
/// where candidates differ in meaning.
std::vector<std::int64_t> fingerprint(std::span<const Rotation> attitudes) {
    std::vector<std::int64_t> marks;
    for (const Rotation& attitude : attitudes) {
        const Rotation q = attitude.canonical();
        for (const double component : {q.w(), q.x(), q.y(), q.z()}) {
            marks.push_back(std::llround(1e6 * component));
        }
    }
    return marks;
}

/// Rows of numbers whose attitudes are equal only in candidates that mean the same.
std::vector<double> generic_numbers(const Spec& spec) {
    std::vector<double> numbers;
    for (const Rotation& rotation :
         {Rotation::near_unit(0.83, 0.31, -0.42, 0.17), Rotation::near_unit(0.29, -0.37, 0.71, 0.53),
          Rotation::near_unit(0.61, 0.47, 0.13, -0.59), Rotation::near_unit(0.43, 0.19, -0.67, 0.31),
          Rotation::near_unit(0.71, -0.11, 0.23, 0.41)}) {
        std::array<double, most_numbers> row{};
        write_row(spec.in_degrees(), rotation, row.data());
        numbers.insert(numbers.end(), row.begin(), row.begin() + static_cast<std::ptrdiff_t>(spec.size()));
    }
    return numbers;
}

} // namespace

bool Candidate::is_plain() const noexcept {
    return std::ranges::is_sorted(std::span(columns).first(spec.size())) && !spec.sequence.has_signs();
}

void Candidate::add(double row_angle, std::size_t row) noexcept {
    if (++rows == 1 || row_angle > angle) {
        angle = row_angle;
        angle_row = row;
    }
}

Identification::Identification(std::size_t count, const Spec& known, std::optional<RepresentationId> name,
                               const IdentificationSettings& settings)
    : count_(count), settings_(settings), known_conversion_(known, Spec{}, {.tolerance = settings.tolerance}) {
    std::set<std::vector<std::int64_t>> met;
    for (const Candidate& candidate : candidates_of(count, name)) {
        if (generic_numbers_.empty()) {
            generic_numbers_ = generic_numbers(candidate.spec);
        }
        if (met.insert(fingerprint(generic_attitudes(candidate))).second) {
            living_.push_back(candidates_.size());
            candidates_.push_back(candidate);
        }
    }
}

Identification::Identification(const Candidate& candidate, const Spec& known, const IdentificationSettings& settings)
    : count_(candidate.spec.size()), settings_(settings),
      known_conversion_(known, Spec{}, {.tolerance = settings.tolerance}), candidates_{candidate}, living_{0} {
    candidates_[0].rows = 0;
}

std::vector<Rotation> Identification::generic_attitudes(const Candidate& candidate) const {
    std::vector<RowReport> reports;
    auto attitudes = attitudes_of(candidate, infinity, generic_numbers_, count_, reports);
    std::ranges::transform(attitudes, attitudes.begin(), candidate.constant);
    return attitudes;
}

std::vector<Rotation> Identification::attitudes_of(const Candidate& candidate, double tolerance,
                                                   std::span<const double> numbers, std::size_t width,
                                                   std::vector<RowReport>& reports, bool fast) {
    const Conversion conversion(candidate.spec, Spec{}, {.tolerance = tolerance, .fast = fast});
    return attitudes_by(conversion, candidate.columns, numbers, width, reports);
}

std::vector<Rotation> Identification::attitudes_by(const Conversion& conversion, const ColumnOrder& columns,
                                                   std::span<const double> numbers, std::size_t width,
                                                   std::vector<RowReport>& reports) {
    std::vector<Rotation> attitudes(numbers.size() / width);
    std::vector<double> ordered;
    ordered.reserve(attitudes.size() * conversion.from().size());
    for (std::size_t row = 0; row < numbers.size(); row += width) {
        for (const std::uint8_t column : std::span(columns).first(conversion.from().size())) {
            ordered.push_back(numbers[row + column]);
        }
    }
    std::vector<double> quaternions(4 * attitudes.size());
    conversion.run(ordered, quaternions, reports);
    for (std::size_t i = 0; i < attitudes.size(); ++i) {
        attitudes[i] = rotation_at(quaternions.data() + 4 * i);
    }
    return attitudes;
}

bool Identification::is_count(std::size_t count) noexcept {
    return std::ranges::any_of(all_representations,
                               [count](RepresentationId id) { return representation(id).size == count; });
}

void Identification::add(std::span<const double> numbers, std::span<const std::size_t> rows,
                         std::vector<RowReport>& reports) {
    const std::size_t width = count_ + known_conversion_.from().size();
    check_size(numbers.size(), rows.size() * width);
    ColumnOrder columns{};
    std::iota(columns.begin(), columns.end(), static_cast<std::uint8_t>(count_));
    known_ = attitudes_by(known_conversion_, columns, numbers.first(rows.size() * width), width, reports);
    std::ranges::for_each(reports, [](RowReport& report) {
        report.at_fault = 1;
        report.references[0].defect = report.error == Error::none ? std::exchange(report.defect, 0.0) : 0.0;
    });
    // Few of the first rows at a time, because most candidates are dropped there.
    for (std::size_t first = 0; first < rows.size();) {
        const std::size_t count = std::min({rows.size() - first, batch_rows, std::max<std::size_t>(rows_, 1)});
        first += try_rows(numbers, rows, first, count, reports);
    }
}

bool Identification::is_dropped(const Candidate& candidate) const noexcept {
    return candidate.angle > std::max(settings_.within, std::min(far * settings_.within, farthest));
}

double Identification::angle_of_row(const Candidate& candidate, const Rotation& own, const Rotation& known) noexcept {
    return is_attitude(own) ? angle_between(candidate.constant(own), known) : infinity;
}

std::size_t Identification::try_rows(std::span<const double> numbers, std::span<const std::size_t> rows,
                                     std::size_t first, std::size_t count, std::vector<RowReport>& reports) {
    const std::size_t width = count_ + known_conversion_.from().size();
    angles_.resize(std::max(angles_.size(), candidates_.size() * count));
    const std::vector<std::size_t> readers =
        living_.empty() && !candidates_.empty() ? std::vector<std::size_t>{0} : living_;
    for (const std::size_t reader : readers) {
        const auto own = attitudes_of(candidates_[reader], settings_.tolerance,
                                      numbers.subspan(first * width, count * width), width, found_);
        for (std::size_t i = 0; i < count; ++i) {
            angles_[reader * count + i] = angle_of_row(candidates_[reader], own[i], known_[first + i]);
        }
    }
    for (std::size_t row = 0; row < count; ++row) {
        const std::size_t at = first + row;
        if (!is_attitude(known_[at])) {
            continue;
        }
        const auto row_numbers = numbers.subspan(at * width, count_);
        const auto cannot_read = [&](std::size_t reader) { return angles_[reader * count + row] == infinity; };
        const auto& remaining = living_.empty() ? readers : living_;
        if (!remaining.empty() && std::ranges::all_of(remaining, cannot_read) && !is_read(row_numbers)) {
            attitudes_of(candidates_[remaining.front()], settings_.tolerance, row_numbers, count_, found_);
            auto place = std::ranges::lower_bound(reports, at, {}, &RowReport::row);
            if (place == reports.end() || place->row != at) {
                place = reports.insert(place, RowReport());
            }
            *place = {.row = at, .error = found_.front().error, .defect = found_.front().defect};
            continue;
        }
        ++rows_;
        remember(row_numbers, known_[at], rows[at]);
        bool are_others = rows_ == rows_for_all;
        std::erase_if(living_, [&](std::size_t living) {
            Candidate& candidate = candidates_[living];
            const bool fitted = fits(candidate);
            candidate.add(angles_[living * count + row], rows[at]);
            are_others |= rows_ > rows_for_all && (fitted != fits(candidate) || is_dropped(candidate));
            return is_dropped(candidate);
        });
        if (are_others) {
            choose_living(row_numbers, known_[at], rows[at]);
            return row + 1;
        }
    }
    return count;
}

bool Identification::is_read(std::span<const double> numbers) const {
    std::vector<RowReport> reports;
    return std::ranges::any_of(candidates_, [&](const Candidate& each) {
        return (living_.empty() || !is_dropped(each)) &&
               is_attitude(attitudes_of(each, settings_.tolerance, numbers, count_, reports)[0]);
    });
}

void Identification::choose_living(std::span<const double> numbers, const Rotation& known, std::size_t row) {
    std::vector<std::size_t> nearest;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        Candidate& candidate = candidates_[i];
        if (fits(candidate) && rows_ > rows_for_all && std::ranges::find(living_, i) == living_.end()) {
            const auto own = attitudes_of(candidate, settings_.tolerance, numbers, count_, found_);
            candidate.add(angle_of_row(candidate, own[0], known), row);
        }
        if (!is_dropped(candidate)) {
            nearest.push_back(i);
        }
    }
    const auto fitting = std::ranges::count_if(nearest, [this](std::size_t i) { return fits(candidates_[i]); });
    std::ranges::stable_sort(nearest, {}, [this](std::size_t i) {
        const Candidate& candidate = candidates_[i];
        return std::tuple(!fits(candidate), -static_cast<double>(candidate.rows), candidate.angle);
    });
    nearest.resize(
        std::min(nearest.size(), std::clamp<std::size_t>(static_cast<std::size_t>(fitting), 1, most_living)));
    living_ = nearest;
}

void Identification::remember(std::span<const double> numbers, const Rotation& known, std::size_t row) {
    if ((rows_ - 1) % stride_ == 0) {
        if (kept_.rows.size() == most_kept) { // every second of these goes
            std::vector<std::size_t> places;
            for (std::size_t i = 0; i < most_kept; i += 2) {
                places.push_back(i);
            }
            kept_ = some_rows(places);
            stride_ *= 2;
        }
        kept_.numbers.insert(kept_.numbers.end(), numbers.begin(), numbers.end());
        kept_.known.push_back(known);
        kept_.rows.push_back(row);
    }
    spread_ = std::max(spread_, squared_sine_of_half(known.inverse() * kept_.known.front()));
    greatest_angle_ = std::max(greatest_angle_, squared_sine_of_half(known));
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

Identification::Rows Identification::some_rows(const std::vector<std::size_t>& places) const {
    Rows some;
    for (const std::size_t place : places) {
        const auto first = kept_.numbers.begin() + static_cast<std::ptrdiff_t>(place * count_);
        some.numbers.insert(some.numbers.end(), first, first + static_cast<std::ptrdiff_t>(count_));
        some.known.push_back(kept_.known[place]);
        some.rows.push_back(kept_.rows[place]);
    }
    return some;
}

} // namespace rotconv
