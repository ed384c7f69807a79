#include <rotconv/identification.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <Eigen/Eigenvalues>

#include "constant_turns.hpp"
#include "representations/codec.hpp"
#include "representations/half_turn.hpp"

namespace rotconv {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A candidate is dropped at an angle of more than so many times the limit, or of more than that, in radians.
constexpr double far = 1e3;
constexpr double farthest = 0.5;
/// A smaller part of the whole is rounding.
constexpr double rounding = 1e-7;

using Columns = std::array<std::uint8_t, 9>;

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
    int count = (spec.unit == AngleUnit::degrees ? 1 : 0) + (spec.column_major ? 1 : 0) + (spec.scalar_last ? 1 : 0) +
                (spec.passive ? 1 : 0);
    for (const std::size_t i : {0U, 1U, 2U}) {
        count += spec.sequence.sign(i) < 0.0 ? 1 : 0;
    }
    return count;
}

/// All SPECs of the representation, those with the fewest modifiers and signs first; of several, `passive` last.
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

/// All candidates, preferred names first.
std::vector<Candidate> candidates_of(std::size_t count, std::optional<RepresentationId> name) {
    std::vector<Candidate> candidates;
    for (const RepresentationId id : all_representations) {
        const Representation& entry = representation(id);
        const bool is_wanted = name ? id == *name : id != RepresentationId::rpy; // which is one of the sequences
        if (!is_wanted || entry.size != count) {
            continue;
        }
        const bool any_order = entry.has_gimbal_lock || id == RepresentationId::quat ||
                               id == RepresentationId::axis_angle || id == RepresentationId::two_column;
        for (const Spec& spec : specs_of(entry)) {
            Columns columns{};
            std::iota(columns.begin(), columns.end(), std::uint8_t{0});
            do {
                // Intrinsic turns are the extrinsic ones with the columns reversed.
                if (!entry.takes_sequence || columns[0] < columns[2]) {
                    candidates.push_back({.spec = spec, .columns = columns});
                }
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

/// Numbers by which attitudes are compared, to 1e-6: generic ones differ by more where candidates differ in meaning.
using Fingerprint = std::vector<std::int64_t>;

std::int64_t mark_of(double number) noexcept { return std::llround(1e6 * number); }

/// Of attitudes, whatever the signs of the quaternions.
Fingerprint fingerprint(std::span<const Rotation> attitudes) {
    Fingerprint marks;
    for (const Rotation& attitude : attitudes) {
        const Rotation q = attitude.canonical();
        marks.insert(marks.end(), {mark_of(q.w()), mark_of(q.x()), mark_of(q.y()), mark_of(q.z())});
    }
    return marks;
}

/// Of attitudes, whatever constant turns stand on their sides: the angles of the relative turns, and the angles and the
/// volume between their axes.
Fingerprint turned_fingerprint(std::span<const Rotation> attitudes) {
    Fingerprint marks;
    std::vector<Eigen::Vector3d> vectors;
    for (const Rotation& attitude : attitudes.subspan(1)) {
        vectors.push_back(relative_vector(attitudes[0], attitude));
        const double length = vectors.back().norm();
        vectors.back() /= length; // however small the turns are
        marks.push_back(mark_of(angle_between(attitudes[0], attitude) / 1e-3));
        for (const Eigen::Vector3d& vector : vectors) {
            marks.push_back(mark_of(vector.dot(vectors.back())));
        }
    }
    marks.push_back(mark_of(vectors[0].cross(vectors[1]).dot(vectors[2])));
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
    std::set<Fingerprint> met;
    std::map<Fingerprint, std::size_t> classes;
    std::vector<double> own(rows * 4);
    std::vector<Rotation> attitudes(rows);
    for (const Candidate& candidate : candidates) {
        order(candidate, generic.data(), count, rows, ordered_);
        Conversion(candidate.spec, Spec{}, {.tolerance = infinity}).run(ordered_, own, found_);
        for (std::size_t i = 0; i < rows; ++i) {
            attitudes[i] = rotation_at(own, i);
        }
        if (met.insert(fingerprint(attitudes)).second) {
            const auto turned_class = classes.try_emplace(turned_fingerprint(attitudes), classes.size()).first->second;
            living_.push_back(trials_.size());
            trials_.push_back(
                {candidate, Conversion(candidate.spec, Spec{}, {.tolerance = settings.tolerance}), turned_class});
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
        remember(row_numbers, rotation_at(known_, at), rows[at]);
        std::erase_if(living_, [&](std::size_t trial) {
            Candidate& candidate = trials_[trial].candidate;
            const double angle = angles_[trial * count + row];
            if (++candidate.rows == 1 || angle > candidate.angle) {
                candidate.angle = angle;
                candidate.angle_row = rows[at];
            }
            return angle > std::max(settings_.within, std::min(far * settings_.within, farthest));
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

void Identification::remember(const double* numbers, const Rotation& known, std::size_t row) {
    if ((rows_ - 1) % stride_ == 0) {
        if (kept_rows_.size() == most_kept) { // every second of these goes
            for (std::size_t i = 0; i < most_kept; i += 2) {
                std::copy_n(kept_numbers_.begin() + static_cast<std::ptrdiff_t>(i * count_), count_,
                            kept_numbers_.begin() + static_cast<std::ptrdiff_t>(i / 2 * count_));
                kept_known_[i / 2] = kept_known_[i];
                kept_rows_[i / 2] = kept_rows_[i];
            }
            kept_numbers_.resize(most_kept / 2 * count_);
            kept_known_.resize(most_kept / 2);
            kept_rows_.resize(most_kept / 2);
            stride_ *= 2;
        }
        kept_numbers_.insert(kept_numbers_.end(), numbers, numbers + count_);
        kept_known_.push_back(known);
        kept_rows_.push_back(row);
    }
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

namespace {

void count_fit(Verdict& verdict, double angle) noexcept {
    ++verdict.fitting;
    verdict.nearest[1] = std::min(verdict.nearest[1], std::max(verdict.nearest[0], angle));
    verdict.nearest[0] = std::min(verdict.nearest[0], angle);
}

/// The vectors of the turns from the first attitude to the others, in body or reference axes: their sizes, increasing,
/// and the directions of these.
struct RelativeTurns {
    RelativeTurns(const std::vector<Rotation>& attitudes, bool in_reference) {
        Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
        for (const Rotation& attitude : attitudes) {
            const Eigen::Vector3d vector = in_reference ? relative_vector(attitudes[0].inverse(), attitude.inverse())
                                                        : relative_vector(attitudes[0], attitude);
            scatter += vector * vector.transpose();
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter / static_cast<double>(attitudes.size()));
        sizes = 2.0 * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
        axes = solver.eigenvectors();
    }

    Eigen::Vector3d sizes;
    Eigen::Matrix3d axes;
};

/// Of an axis and its opposite that whose largest component is positive.
Eigen::Vector3d with_positive_leader(const Eigen::Vector3d& axis) noexcept {
    Eigen::Index leader = 0;
    axis.cwiseAbs().maxCoeff(&leader);
    return std::copysign(1.0, axis[leader]) * axis;
}

} // namespace

Verdict Identification::verdict() const {
    Verdict verdict;
    for (const Trial& trial : trials_) {
        if (fits(trial.candidate)) {
            count_fit(verdict, trial.candidate.angle);
        }
    }
    if (verdict.fitting == 0 && rows_ > 0) {
        try_turns(verdict);
    } else if (verdict.fitting > 1) {
        verdict.ambiguity = ambiguity(verdict);
    }
    return verdict;
}

std::vector<Rotation> Identification::attitudes_of(const Trial& trial, std::span<const std::size_t> kept) const {
    std::vector<double> ordered;
    for (const std::size_t row : kept) {
        for (std::size_t i = 0; i < trial.candidate.spec.size(); ++i) {
            ordered.push_back(kept_numbers_[row * count_ + trial.candidate.columns.at(i)]);
        }
    }
    std::vector<double> quaternions(4 * kept.size());
    std::vector<RowReport> reports;
    trial.conversion.run(ordered, quaternions, reports);
    if (std::ranges::any_of(reports, [](const RowReport& report) { return report.error != Error::none; })) {
        return {};
    }
    std::vector<Rotation> attitudes;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        attitudes.push_back(rotation_at(quaternions, i));
    }
    return attitudes;
}

/// Rows that are far apart, which reject nearly all candidates; some hundred, which give the turns; and all.
struct Identification::RowsForTurns {
    explicit RowsForTurns(const std::vector<Rotation>& kept) : few(spread_rows(kept, 12)), some(few), all(kept.size()) {
        std::iota(all.begin(), all.end(), std::size_t{0});
        for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / 256) {
            some.push_back(i);
        }
        const auto take = [&kept](const std::vector<std::size_t>& rows, std::vector<Rotation>& to) {
            std::ranges::transform(rows, std::back_inserter(to), [&kept](std::size_t row) { return kept[row]; });
        };
        take(few, known_few);
        take(some, known_some);
    }

    std::vector<std::size_t> few, some, all;
    std::vector<Rotation> known_few, known_some;
};

bool Identification::may_fit(const Trial& trial, const RowsForTurns& rows) const {
    const auto own = attitudes_of(trial, rows.few);
    for (std::size_t i = 1; i < own.size(); ++i) { // no constant turn changes the angle between two rows
        const double angle = angle_between(own[0], own[i]);
        if (std::fabs(angle - angle_between(rows.known_few[0], rows.known_few[i])) >
            2.0 * settings_.within + rounding) {
            return false;
        }
    }
    return !own.empty();
}

std::optional<Candidate> Identification::with_turn(const Trial& trial, AlignedSide side,
                                                   const RowsForTurns& rows) const {
    const auto own_few = attitudes_of(trial, rows.few);
    const ConstantTurns rough = constant_turns(side, own_few, rows.known_few);
    if (largest_angle(rough, own_few, rows.known_few).angle > 2.0 * settings_.within + rounding) {
        return std::nullopt;
    }
    const auto own = attitudes_of(trial, rows.all);
    if (own.empty()) {
        return std::nullopt;
    }
    const auto own_some = attitudes_of(trial, rows.some);
    ConstantTurns turns = constant_turns(side, own_some, rows.known_some);
    LargestAngle largest = largest_angle(turns, own, kept_known_);
    const ConstantTurns exact = turns;
    for (const AlignedSide first : {AlignedSide::reference, AlignedSide::body}) {
        if (side == first) { // the other side would be turned too
            continue;
        }
        const ConstantTurns named = with_named_axes(exact, first, own_some, rows.known_some);
        const LargestAngle largest_of_named = largest_angle(named, own, kept_known_);
        if (largest_of_named.angle <= settings_.within) {
            turns = named;
            largest = largest_of_named;
            break;
        }
    }
    if (largest.angle > settings_.within) {
        return std::nullopt;
    }
    // A turn below the limit would only spread a row's error over the others.
    if ((side != AlignedSide::body && angle_of(turns.left) <= settings_.within) ||
        (side != AlignedSide::reference && angle_of(turns.right) <= settings_.within)) {
        return std::nullopt;
    }
    Candidate candidate = trial.candidate;
    candidate.rows = kept_rows_.size();
    candidate.angle = largest.angle;
    candidate.angle_row = kept_rows_[largest.row];
    candidate.left = side == AlignedSide::body ? std::nullopt : std::optional(turns.left);
    candidate.right = side == AlignedSide::reference ? std::nullopt : std::optional(turns.right);
    return candidate;
}

void Identification::try_turns(Verdict& verdict) const {
    const RowsForTurns rows(kept_known_);
    std::map<std::size_t, bool> possible; // by class
    std::vector<const Trial*> trials;
    for (const Trial& trial : trials_) {
        const auto [found, is_new] = possible.try_emplace(trial.turned_class);
        if (is_new) {
            found->second = may_fit(trial, rows);
        }
        if (found->second) {
            trials.push_back(&trial);
        }
    }
    std::map<std::size_t, Candidate> fitting; // of each class the one with the fewest turns
    for (const AlignedSide side : {AlignedSide::body, AlignedSide::reference, AlignedSide::both}) {
        // What others make of turns on both sides is told by four rows; of fewer those that are not special serve.
        if (side == AlignedSide::both && !fitting.empty() && rows_ < 4 && !may_mistake_turns()) {
            break;
        }
        for (const Trial* trial : trials) {
            if (fitting.contains(trial->turned_class) || !possible[trial->turned_class]) {
                continue;
            }
            if (auto candidate = with_turn(*trial, side, rows)) {
                fitting.emplace(trial->turned_class, *candidate);
            } else if (side == AlignedSide::both) { // then none of its class fits
                possible[trial->turned_class] = false;
            }
        }
    }
    for (const auto& [turned_class, candidate] : fitting) {
        count_fit(verdict, candidate.angle);
        verdict.turned.push_back(candidate);
    }
    if (verdict.fitting > 1) {
        verdict.ambiguity = ambiguity_of_turned(verdict);
    }
}

Verdict::Ambiguity Identification::ambiguity_of_turned(Verdict& verdict) const {
    using Ambiguity = Verdict::Ambiguity;
    if (rows_ < 4) { // whose relative turns lie in a plane
        return Ambiguity::rows;
    }
    if (spread_ <= settings_.within) {
        return Ambiguity::attitudes;
    }
    verdict.angle = spread_;
    if (spread_ * spread_ <= 4.0 * settings_.within) {
        return Ambiguity::size;
    }
    const RelativeTurns turns(kept_known_, false);
    const double least = std::max(settings_.within, rounding);
    const bool is_axis = turns.sizes[1] <= least;
    verdict.axis = with_positive_leader(turns.axes.col(is_axis ? 2 : 0));
    return is_axis ? Ambiguity::axes : turns.sizes[0] <= least ? Ambiguity::plane : Ambiguity::difference;
}

// Along the axes, or halfway between them, other axes are turns of the numbers' signs and order.
bool Identification::may_mistake_turns() const {
    const double least = std::max(settings_.within, rounding);
    const auto is_special = [&](bool in_reference) {
        const RelativeTurns turns(kept_known_, in_reference);
        const Eigen::Vector3d n = turns.axes.col(turns.sizes[1] <= least ? 2 : 0).cwiseAbs();
        const double nearest =
            std::min({n[0], n[1], n[2], std::fabs(n[0] - n[1]), std::fabs(n[1] - n[2]), std::fabs(n[0] - n[2])});
        return turns.sizes[0] <= least && nearest <= 2.0 * settings_.within;
    };
    return is_special(false) || is_special(true);
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
        verdict.axis = with_positive_leader(solver.eigenvectors().col(2));
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
