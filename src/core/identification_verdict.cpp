#include <rotconv/identification.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <variant>

#include <rotconv/alignment.hpp>
#include <rotconv/axes.hpp>
#include <rotconv/dcm.hpp>

#include "numerics/eigensystem.hpp"
#include "representations/rotation_angle.hpp"

namespace rotconv {
namespace {

/// A smaller part of the whole is rounding.
constexpr double rounding = 1e-7;

using Attitudes = std::vector<Rotation>;

ConstantRotations constant_rotations(AlignedSide side, const Attitudes& unknown, const Attitudes& known,
                                     const ConstantRotations& before = {}) {
    Alignment alignment(side);
    for (std::size_t i = 0; i < known.size(); ++i) {
        alignment.add(before(unknown[i]), known[i]);
    }
    return alignment.some_rotations();
}

struct LargestAngle {
    double angle = 0.0;  ///< radians
    std::size_t row = 0; ///< the first with it
};

/// What is left of the angles between them.
LargestAngle largest_angle(const ConstantRotations& constant, const Attitudes& unknown,
                           const Attitudes& known) noexcept {
    LargestAngle largest;
    for (std::size_t i = 0; i < known.size(); ++i) {
        const double angle = angle_between(constant(unknown[i]), known[i]);
        if (angle > largest.angle) {
            largest = {angle, i};
        }
    }
    return largest;
}

/// The rotations of the axes' names that are nearest, where they are near: that of the first side, and that of the
/// other as it fits the first.
ConstantRotations with_named_axes(const ConstantRotations& constant, AlignedSide first, const Attitudes& unknown,
                                  const Attitudes& known) {
    const auto named = [](const Rotation& rotation) {
        const Dcm rounded = dcm::from_rotation(rotation).array().round();
        const Reading reading = dcm::to_rotation(rounded, 0.0);
        return reading ? *reading : rotation;
    };
    if (first == AlignedSide::reference) {
        const Rotation left = named(constant.left);
        return {left, named(constant_rotations(AlignedSide::body, unknown, known, {left, {}}).right)};
    }
    const Rotation right = named(constant.right);
    return {named(constant_rotations(AlignedSide::reference, unknown, known, {{}, right}).left), right};
}

/// Axes that people have names for, on either side of an attitude.
struct NamedAxes {
    NamedAxes(std::string_view reference_, std::string_view body_)
        : reference(reference_), body(body_), constant{rotation_of(reference), rotation_of(body).inverse()} {}

    static Rotation rotation_of(std::string_view text) {
        return text.empty() ? Rotation() : std::get<AxesChange>(parse_axes(text)).rotation().rotation;
    }

    std::string_view reference;
    std::string_view body;
    ConstantRotations constant;
};

const std::vector<NamedAxes>& named_axes() {
    static const std::vector<NamedAxes> axes{
        {"ned:enu", ""}, {"ned:enu", "frd:flu"}, {"", "rdf:rub"}, {"ruf:flu", "ruf:flu"}, {"fru:flu", "fru:flu"}};
    return axes;
}

/// sin(theta/2) cos(theta/2) n of the rotation from a to b in body axes: whatever the signs of the quaternions.
Eigen::Vector3d relative_vector(const Rotation& a, const Rotation& b) noexcept {
    const Rotation relative = a.inverse() * b;
    return Eigen::Vector3d(relative.x(), relative.y(), relative.z()) * (relative.w() / relative.squared_norm());
}

/// The mean of u u' over the vectors u of the rotations from the first attitude to each, in body or reference axes.
Eigen::Matrix3d relative_scatter(const Attitudes& attitudes, bool in_reference) noexcept {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Rotation& attitude : attitudes) {
        const Eigen::Vector3d vector = in_reference ? relative_vector(attitudes[0].inverse(), attitude.inverse())
                                                    : relative_vector(attitudes[0], attitude);
        scatter += vector * vector.transpose();
    }
    return scatter / static_cast<double>(attitudes.size());
}

/// How far vectors like sin(theta/2) n spread, as angles, increasing, and along which axes.
struct PrincipalAxes {
    explicit PrincipalAxes(const Eigen::Matrix3d& scatter) noexcept {
        const Eigensystem<3> system(scatter);
        sizes = 2.0 * system.values.cwiseMax(0.0).cwiseSqrt();
        axes = system.vectors;
    }

    Eigen::Vector3d sizes;
    Eigen::Matrix3d axes;
};

/// The axis or its opposite: the one whose largest component is positive.
Eigen::Vector3d with_positive_leader(const Eigen::Vector3d& axis) noexcept {
    Eigen::Index leader = 0;
    axis.cwiseAbs().maxCoeff(&leader);
    return std::copysign(1.0, axis[leader]) * axis;
}

/// At most `count` rows that are as far from each other as may be: each the farthest from those before it.
std::vector<std::size_t> spread_rows(const Attitudes& attitudes, std::size_t count) {
    std::vector<std::size_t> rows{0};
    std::vector<double> nearest(attitudes.size(), std::numeric_limits<double>::infinity());
    while (rows.size() < std::min(count, attitudes.size())) {
        for (std::size_t i = 0; i < attitudes.size(); ++i) {
            nearest[i] = std::min(nearest[i], angle_between(attitudes[i], attitudes[rows.back()]));
        }
        const auto farthest = std::ranges::max_element(nearest);
        rows.push_back(static_cast<std::size_t>(farthest - nearest.begin()));
    }
    return rows;
}

/// Numbers by which generic attitudes are compared, to 1e-6, whatever constant rotations stand on their sides: the
/// angles of the relative rotations, and the angles and the volume between their axes.
std::vector<std::int64_t> rotated_fingerprint(const Attitudes& attitudes) {
    std::vector<std::int64_t> marks;
    const auto mark = [&marks](double number) { marks.push_back(std::llround(1e6 * number)); };
    std::vector<Eigen::Vector3d> axes;
    for (std::size_t i = 1; i < attitudes.size(); ++i) {
        axes.push_back(relative_vector(attitudes[0], attitudes[i]).normalized()); // however small the rotations are
        mark(1e3 * angle_between(attitudes[0], attitudes[i]));
        for (const Eigen::Vector3d& axis : axes) {
            mark(axis.dot(axes.back()));
        }
    }
    mark(axes[0].cross(axes[1]).dot(axes[2]));
    return marks;
}

} // namespace

/// Rows that are far apart, which reject nearly all candidates, and some hundred, which give the rotations.
struct Identification::RowsForRotations {
    explicit RowsForRotations(const Identification& identification)
        : few(spread_rows(identification.kept_known_, 12)), some(few) {
        const Attitudes& kept = identification.kept_known_;
        for (std::size_t i = 0; i < kept.size(); i += 1 + kept.size() / 256) {
            some.push_back(i);
        }
        known_few = of(few, kept);
        known_some = of(some, kept);
        const std::size_t count = identification.count_;
        for (const std::size_t row : few) {
            const auto first = identification.kept_numbers_.begin() + static_cast<std::ptrdiff_t>(row * count);
            numbers_few.insert(numbers_few.end(), first, first + static_cast<std::ptrdiff_t>(count));
        }
    }

    static Attitudes of(const std::vector<std::size_t>& rows, const Attitudes& all) {
        Attitudes attitudes;
        std::ranges::transform(rows, std::back_inserter(attitudes), [&all](std::size_t row) { return all[row]; });
        return attitudes;
    }

    std::vector<std::size_t> few, some;
    Attitudes known_few, known_some;
    std::vector<double> numbers_few;
};

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
    const auto fits_as_it_is = [this](const Trial& trial) { return fits(trial.candidate); };
    const auto first = std::ranges::find_if(trials_, fits_as_it_is);
    verdict.fitting = static_cast<std::size_t>(std::ranges::count_if(trials_, fits_as_it_is));
    if (verdict.fitting == 0 && rows_ > 0) {
        verdict.rotated = rotated();
        verdict.fitting = verdict.rotated.size();
    }
    const bool has_both = verdict.fitting == 1 && !verdict.rotated.empty() && verdict.rotated[0].constant.count() == 2;
    if (verdict.fitting > 1 || (has_both && !determines_both())) {
        verdict.ambiguity = ambiguity(verdict);
    } else if (verdict.fitting == 1) {
        verdict.answer = as_written(verdict.rotated.empty() ? first->candidate : verdict.rotated[0]);
    }
    return verdict;
}

Attitudes Identification::attitudes_or_none(const Trial& trial, std::span<const double> numbers) const {
    std::vector<RowReport> reports;
    Attitudes attitudes = attitudes_of(trial, numbers, count_, reports);
    return std::ranges::all_of(attitudes, is_attitude) ? attitudes : Attitudes();
}

bool Identification::may_fit(const Trial& trial, const RowsForRotations& rows) const {
    const auto own = attitudes_or_none(trial, rows.numbers_few);
    for (std::size_t i = 1; i < own.size(); ++i) { // no constant rotation changes the angle between two rows
        const double angle = angle_between(own[0], own[i]);
        if (std::fabs(angle - angle_between(rows.known_few[0], rows.known_few[i])) >
            2.0 * settings_.within + rounding) {
            return false;
        }
    }
    return !own.empty();
}

std::optional<Candidate> Identification::with_rotation(const Trial& trial, AlignedSide side,
                                                       const RowsForRotations& rows) const {
    const auto own_few = attitudes_or_none(trial, rows.numbers_few);
    const ConstantRotations rough = constant_rotations(side, own_few, rows.known_few);
    if (largest_angle(rough, own_few, rows.known_few).angle > 2.0 * settings_.within + rounding) {
        return std::nullopt;
    }
    const auto own = attitudes_or_none(trial, kept_numbers_);
    if (own.empty()) {
        return std::nullopt;
    }
    const auto own_some = RowsForRotations::of(rows.some, own);
    ConstantRotations constant = constant_rotations(side, own_some, rows.known_some);
    LargestAngle largest = largest_angle(constant, own, kept_known_);
    const ConstantRotations exact = constant;
    for (const AlignedSide first : {AlignedSide::reference, AlignedSide::body}) {
        if (side == first) { // the other side would be rotated too
            continue;
        }
        const ConstantRotations named = with_named_axes(exact, first, own_some, rows.known_some);
        const LargestAngle largest_of_named = largest_angle(named, own, kept_known_);
        if (largest_of_named.angle <= settings_.within) {
            constant = named;
            largest = largest_of_named;
            break;
        }
    }
    if (largest.angle > settings_.within) {
        return std::nullopt;
    }
    // A rotation below the limit would only spread a row's error over the others.
    if ((side != AlignedSide::body && angle_of(constant.left) <= settings_.within) ||
        (side != AlignedSide::reference && angle_of(constant.right) <= settings_.within)) {
        return std::nullopt;
    }
    Candidate candidate = trial.candidate;
    candidate.rows = kept_rows_.size();
    candidate.angle = largest.angle;
    candidate.angle_row = kept_rows_[largest.row];
    candidate.constant = constant;
    return candidate;
}

std::vector<Candidate> Identification::rotated() const {
    std::map<std::vector<std::int64_t>, std::vector<const Trial*>>
        classes; // that are the same but for constant rotations
    for (const Trial& trial : trials_) {
        classes[rotated_fingerprint(generic_attitudes(trial.candidate))].push_back(&trial);
    }
    const RowsForRotations rows(*this);
    std::erase_if(classes, [&](const auto& each) { return !may_fit(*each.second.front(), rows); });
    std::vector<Candidate> found;
    std::vector<const Trial*> left_over;
    for (const auto& [mark, trials] : classes) {
        const std::size_t before = found.size();
        for (const AlignedSide side : {AlignedSide::reference, AlignedSide::body}) {
            for (const Trial* trial : trials) {
                if (auto rotated = with_rotation(*trial, side, rows)) {
                    found.push_back(*rotated);
                }
            }
        }
        if (found.size() == before) {
            left_over.push_back(trials.front());
        }
    }
    if (found.empty() || may_mistake_rotations()) {
        for (const Trial* trial : left_over) { // if one of a class does not fit with both, none does
            if (auto rotated = with_rotation(*trial, AlignedSide::both, rows)) {
                found.push_back(*rotated);
            }
        }
    }
    std::ranges::stable_sort(found, {}, &Candidate::angle);
    std::vector<std::vector<Rotation>> meanings;
    std::erase_if(found, [&](const Candidate& each) {
        constexpr double exact = 1e-12;
        const auto own = meaning_of(each);
        const bool is_known = std::ranges::any_of(meanings, [&](const auto& meaning) {
            return largest_angle({}, own, meaning).angle <= 2.0 * settings_.within + rounding;
        });
        const bool is_far = each.angle > 10.0 * std::max(found.front().angle, exact);
        if (!is_known && !is_far) {
            meanings.push_back(own);
        }
        return is_known || is_far;
    });
    return found;
}

Attitudes Identification::meaning_of(const Candidate& candidate) const {
    Attitudes attitudes = generic_attitudes(candidate);
    std::ranges::transform(attitudes, attitudes.begin(), candidate.constant);
    return attitudes;
}

Candidate Identification::as_written(const Candidate& candidate) const {
    if (candidate.is_plain() && candidate.constant.count() == 0) {
        return candidate;
    }
    const Attitudes meaning = meaning_of(candidate);
    const auto with = [&candidate](const Candidate& named) { // what was measured, under another name
        Candidate made = candidate;
        made.spec = named.spec;
        made.columns = named.columns;
        return made;
    };
    struct Name {
        Candidate candidate;
        Attitudes own;
    };
    std::vector<Name> plain; // that differ from the candidate by constant rotations
    for (const Trial& trial : trials_) {
        if (trial.candidate.is_plain()) {
            Name name{trial.candidate, generic_attitudes(trial.candidate)};
            if (rotated_fingerprint(name.own) == rotated_fingerprint(meaning)) {
                plain.push_back(std::move(name));
            }
        }
    }
    for (const auto& [name, own] : plain) {
        for (const NamedAxes& axes : named_axes()) {
            if (largest_angle(axes.constant, own, meaning).angle <= rounding) {
                Candidate made = with(name);
                made.constant = axes.constant;
                made.reference_axes = axes.reference;
                made.body_axes = axes.body;
                return made;
            }
        }
    }
    if (candidate.constant.count() == 0) {
        return candidate;
    }
    // The fewest rotations, first those of axes; of equals a plain name.
    std::optional<Candidate> best;
    std::pair<bool, int> least{true, 3};
    plain.push_back({candidate, generic_attitudes(candidate)});
    for (const auto& [name, own] : plain) {
        const ConstantRotations exact = constant_rotations(AlignedSide::both, own, meaning);
        const ConstantRotations named = with_named_axes(exact, AlignedSide::reference, own, meaning);
        const bool is_named = !axes_text(named.left).empty() && !axes_text(named.right).empty() &&
                              largest_angle(named, own, meaning).angle <= rounding;
        const ConstantRotations& constant = is_named ? named : exact;
        Candidate made = with(name);
        const auto& [left, right] = constant;
        made.constant = {angle_of(left) <= rounding ? Rotation() : left,
                         angle_of(right) <= rounding ? Rotation() : right};
        const std::pair rank(!is_named, made.constant.count());
        if (rank < least && largest_angle(constant, own, meaning).angle <= rounding) {
            least = rank;
            best = made;
        }
    }
    return best.value_or(candidate);
}

bool Identification::determines_both() const {
    const PrincipalAxes relative(relative_scatter(kept_known_, false));
    return rows_ >= 4 && relative.sizes[0] > std::max(settings_.within, rounding);
}

// Along the axes, or halfway between them, other axes are changes of the numbers' signs and order.
bool Identification::may_mistake_rotations() const {
    const double least = std::max(settings_.within, rounding);
    const auto is_special = [&](bool in_reference) {
        const PrincipalAxes relative(relative_scatter(kept_known_, in_reference));
        const Eigen::Vector3d n = relative.axes.col(relative.sizes[1] <= least ? 2 : 0).cwiseAbs();
        const double nearest =
            std::min({n[0], n[1], n[2], std::fabs(n[0] - n[1]), std::fabs(n[1] - n[2]), std::fabs(n[0] - n[2])});
        return relative.sizes[0] <= least && nearest <= 2.0 * settings_.within;
    };
    return is_special(false) || is_special(true);
}

Verdict::Ambiguity Identification::ambiguity(Verdict& verdict) const {
    using Ambiguity = Verdict::Ambiguity;
    const bool rotated = !verdict.rotated.empty();
    if (rows_ < (rotated ? 4 : 2)) { // the relative rotations of three lie in a plane
        return Ambiguity::rows;
    }
    if (spread_ <= settings_.within) {
        return Ambiguity::attitudes;
    }
    // SPECs of small attitudes differ by half the angle's square.
    verdict.angle = rotated ? spread_ : greatest_angle_;
    if (verdict.angle * verdict.angle <= 4.0 * settings_.within) {
        return Ambiguity::size;
    }
    const PrincipalAxes principal(rotated ? relative_scatter(kept_known_, false)
                                          : Eigen::Matrix3d(scatter_ / static_cast<double>(rows_)));
    const double least = std::max(settings_.within, rounding);
    const bool is_axis = principal.sizes[1] <= least;
    if (is_axis || rotated) {
        verdict.axis = with_positive_leader(principal.axes.col(is_axis ? 2 : 0));
        return is_axis ? Ambiguity::axes : principal.sizes[0] <= least ? Ambiguity::plane : Ambiguity::difference;
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
