#include "identification.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

#include <rotconv/alignment.hpp>
#include <rotconv/axes.hpp>
#include <rotconv/dcm.hpp>
#include <rotconv/spec.hpp>

#include "../numerics/eigensystem.hpp"
#include "../numerics/row_batch.hpp"
#include "../projects.hpp"
#include "../representations/rotation_angle.hpp"
#include "../text.hpp"

namespace rotconv {
namespace {

/// A smaller part of the whole is rounding.
constexpr double rounding = 1e-7;

using Attitudes = std::vector<Rotation>;

/// Whether no angle between them is beyond the limit, without an arctangent: it is asked of all pairs of candidates.
bool are_near(const Attitudes& a, const Attitudes& b, double limit) {
    const double most = sine_of(0.5 * std::min(limit, std::numbers::pi));
    return std::ranges::equal(a, b, [most](const Rotation& x, const Rotation& y) {
        return squared_sine_of_half(x * y.inverse()) <= most * most;
    });
}

/// The rotation that only permutes and negates axes whose matrix is the rounded one; without it, the rotation itself.
Rotation nearest_axes(const Rotation& rotation) noexcept {
    const Dcm rounded = dcm::from_rotation(rotation).array().round();
    const Reading reading = dcm::to_rotation(rounded, 0.0);
    return reading ? *reading : rotation;
}

/// Constant rotations, with the names of the axes if people have names for them.
struct Turn {
    [[nodiscard]] Candidate of(Candidate candidate) const {
        candidate.constant = constant;
        candidate.reference_axes = reference;
        candidate.body_axes = body;
        return candidate;
    }

    ConstantRotations constant;
    std::string_view reference{};
    std::string_view body{};
};

const std::vector<Turn>& named_axes() {
    const auto rotation_of = [](std::string_view text) {
        return text.empty() ? Rotation() : std::get<AxesChange>(parse_axes(text)).rotation().rotation;
    };
    const auto named = [&](std::string_view reference, std::string_view body) {
        return Turn{{rotation_of(reference), rotation_of(body).inverse()}, reference, body};
    };
    static const std::vector<Turn> axes{named("ned:enu", ""), named("ned:enu", "frd:flu"), named("", "rdf:rub"),
                                        named("ruf:flu", "ruf:flu"), named("fru:flu", "fru:flu")};
    return axes;
}

/// sin(theta/2) cos(theta/2) n of the rotation from a to b in body axes: whatever the signs of the quaternions.
Eigen::Vector3d relative_vector(const Rotation& a, const Rotation& b) noexcept {
    const Rotation relative = a.inverse() * b;
    return Eigen::Vector3d(relative.x(), relative.y(), relative.z()) * (relative.w() / relative.squared_norm());
}

/// The vectors of the rotations from the first attitude to each, in body or reference axes.
std::vector<Eigen::Vector3d> relative_vectors(const Attitudes& attitudes, bool in_reference) {
    std::vector<Eigen::Vector3d> vectors;
    for (const Rotation& attitude : attitudes) {
        vectors.push_back(in_reference ? relative_vector(attitudes[0].inverse(), attitude.inverse())
                                       : relative_vector(attitudes[0], attitude));
    }
    return vectors;
}

/// The mean of u u' over vectors u.
Eigen::Matrix3d scatter_of(const std::vector<Eigen::Vector3d>& vectors) noexcept {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& vector : vectors) {
        scatter += vector * vector.transpose();
    }
    return scatter / static_cast<double>(vectors.size());
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

/// At most twelve rows that are as far from each other as may be: each the farthest from those before it.
std::vector<std::size_t> far_apart(const Attitudes& attitudes) {
    std::vector<std::size_t> rows{0};
    std::vector<double> nearest(attitudes.size(), std::numeric_limits<double>::infinity());
    while (rows.size() < std::min<std::size_t>(12, attitudes.size())) {
        for (std::size_t i = 0; i < attitudes.size(); ++i) {
            nearest[i] = std::min(nearest[i], angle_between(attitudes[i], attitudes[rows.back()]));
        }
        const auto farthest = std::ranges::max_element(nearest);
        rows.push_back(static_cast<std::size_t>(farthest - nearest.begin()));
    }
    return rows;
}

/// Up to this angle others are as near as the nearest: a factor of ten, of more than rounding.
double most_alike(double nearest) noexcept { return 10.0 * std::max(nearest, 1e-12); }

/// What trials on two sets of rows say together.
Candidate joined(const Candidate& a, const Candidate& b) noexcept {
    Candidate joined = b.angle >= a.angle ? b : a;
    joined.rows = std::max(a.rows, b.rows);
    return joined;
}

} // namespace

std::vector<Candidate> Identification::best_first() const {
    std::vector<Candidate> candidates = candidates_;
    std::vector<Candidate*> undecided;
    for (Candidate& each : candidates) {
        if (each.rows < rows_ && !is_dropped(each)) {
            undecided.push_back(&each);
        }
    }
    const Rows few = undecided.empty() ? Rows() : some_rows(far_apart(kept_.known));
    for (Candidate* each : undecided) {
        *each = joined(*each, held_quickly(*each, few));
    }
    hold_nearest(undecided, [&](Candidate& each) {
        const Candidate& tried = candidates_[static_cast<std::size_t>(&each - candidates.data())];
        each = joined(tried, held_quickly(tried, kept_));
    });
    std::ranges::stable_sort(candidates, {}, [](const Candidate& candidate) {
        return std::pair(-static_cast<double>(candidate.rows), candidate.angle);
    });
    return candidates;
}

Verdict Identification::verdict() const {
    Verdict verdict{.candidates = best_first()};
    const auto fit = [this](const Candidate& candidate) { return fits(candidate); };
    if (rows_ > 0 && std::ranges::none_of(verdict.candidates, fit)) {
        const auto found = rotated();
        verdict.candidates.insert(verdict.candidates.begin(), found.begin(), found.end());
    }
    verdict.fitting = static_cast<std::size_t>(std::ranges::count_if(verdict.candidates, fit));
    const auto first = std::ranges::find_if(verdict.candidates, fit);
    if (verdict.fitting > 1 || (verdict.fitting == 1 && !do_rows_suffice(*first, settings_.within))) {
        verdict.ambiguity = ambiguity(verdict);
    } else if (verdict.fitting == 1) {
        verdict.answer = as_written(*first);
    }
    return verdict;
}

Attitudes Identification::attitudes_or_none(const Candidate& candidate, const Rows& rows) const {
    std::vector<RowReport> reports;
    Attitudes attitudes = attitudes_of(candidate, settings_.tolerance, rows.numbers, count_, reports);
    return std::ranges::all_of(attitudes, is_attitude) ? attitudes : Attitudes();
}

Candidate Identification::held_quickly(const Candidate& candidate, const Rows& rows) const {
    constexpr double far_above_rounding = 1e-8; // small motions are often undecided, and would take Wide
    const Candidate quick = held(candidate, rows, true);
    return quick.angle > far_above_rounding ? quick : held(candidate, rows);
}

Candidate Identification::held(const Candidate& candidate, const Rows& rows, bool fast) const {
    Candidate held = candidate;
    held.rows = 0;
    held.angle = 0.0;
    std::vector<RowReport> reports;
    for (std::size_t first = 0; first < rows.rows.size(); first += batch_rows) {
        const std::size_t count = std::min(batch_rows, rows.rows.size() - first);
        const auto own =
            attitudes_of(candidate, settings_.tolerance,
                         std::span(rows.numbers).subspan(first * count_, count * count_), count_, reports, fast);
        for (std::size_t i = 0; i < count; ++i) {
            held.add(angle_of_row(candidate, own[i], rows.known[first + i]), rows.rows[first + i]);
            if (is_dropped(held)) {
                return held;
            }
        }
    }
    return held;
}

void Identification::hold_nearest(std::vector<Candidate*> nearest, const std::function<void(Candidate&)>& hold) const {
    constexpr std::size_t enough = 16;
    std::ranges::stable_sort(nearest, {}, &Candidate::angle);
    std::size_t held = 0;
    std::size_t fitting = 0;
    for (Candidate* each : nearest) {
        if (held >= enough && (fitting > 1 || !fits(*each))) {
            return;
        }
        hold(*each);
        ++held;
        fitting += fits(*each) ? 1 : 0;
    }
}

std::vector<Candidate> Identification::rotated() const {
    // Rows that are far apart reject most candidates, and some hundred give the rotations.
    std::vector<std::size_t> places = far_apart(kept_.known);
    const Rows few = some_rows(places);
    for (std::size_t i = 0; i < kept_.rows.size(); i += 1 + kept_.rows.size() / 256) {
        places.push_back(i);
    }
    const Rows some = some_rows(places);
    // No constant rotations change the angle between two rows.
    const auto may_fit = [&](const Attitudes& own) {
        for (std::size_t i = 1; i < own.size(); ++i) {
            const double angle = angle_between(own[0], own[i]);
            if (std::fabs(angle - angle_between(few.known[0], few.known[i])) > 2.0 * settings_.within + rounding) {
                return false;
            }
        }
        return !own.empty();
    };
    // A rotation below the limit would only spread a row's error over the others.
    const auto is_small = [this](const Rotation& rotation) {
        return !rotation.is_identity() && angle_of(rotation) <= settings_.within;
    };
    std::vector<Candidate> found;
    for (const Candidate& candidate : candidates_) {
        if (!may_fit(attitudes_or_none(candidate, few))) {
            continue;
        }
        const Attitudes own = attitudes_or_none(candidate, some);
        if (own.empty()) {
            continue;
        }
        std::vector<Turn> turns;
        for (const AlignedSide side : {AlignedSide::reference, AlignedSide::body}) {
            Alignment alignment(side);
            for (std::size_t i = 0; i < own.size(); ++i) {
                alignment.add(own[i], some.known[i]);
            }
            turns.push_back({alignment.some_rotations()});
        }
        std::ranges::copy_if(named_axes(), std::back_inserter(turns),
                             [](const Turn& axes) { return axes.constant.count() == 2; });
        for (const Turn& turn : turns) {
            const Candidate turned = held(turn.of(candidate), some);
            if (fits(turned) && !is_small(turn.constant.left) && !is_small(turn.constant.right)) {
                found.push_back(turned);
            }
        }
    }
    return different(std::move(found));
}

std::vector<Candidate> Identification::different(std::vector<Candidate> found) const {
    std::vector<Candidate*> all;
    std::ranges::transform(found, std::back_inserter(all), [](Candidate& each) { return &each; });
    hold_nearest(all, [this](Candidate& each) {
        Candidate of_axes = each;
        of_axes.constant = {nearest_axes(each.constant.left), nearest_axes(each.constant.right)};
        of_axes = held(of_axes, kept_);
        each = fits(of_axes) ? of_axes : held(each, kept_);
    });
    std::erase_if(found, [this](const Candidate& each) { return !fits(each); });
    std::ranges::stable_sort(found, {}, &Candidate::angle);
    std::vector<Attitudes> meanings;
    std::erase_if(found, [&](const Candidate& each) {
        Attitudes own = generic_attitudes(each);
        const bool is_known = std::ranges::any_of(meanings, [&](const Attitudes& meaning) {
            return are_near(own, meaning, 2.0 * settings_.within + rounding);
        });
        const bool is_far = each.angle > most_alike(found.front().angle);
        if (!is_known && !is_far) {
            meanings.push_back(std::move(own));
        }
        return is_known || is_far;
    });
    return found;
}

bool Identification::is_of_project(const Candidate& candidate) const {
    const Attitudes meaning = generic_attitudes(candidate);
    Candidate made = candidate;
    const auto is_same = [&](std::string_view text) {
        const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
        const auto parsed = parse_spec(text.substr(begin, text.find(' ', begin) - begin));
        const Spec* const spec = std::get_if<Spec>(&parsed);
        if (spec == nullptr || !spec->sequence.has_signs()) {
            return false;
        }
        made.spec = *spec;
        made.spec.unit = candidate.spec.unit;
        return std::ranges::any_of(std::array{false, true}, [&](bool passive) {
            made.spec.passive = passive;
            return are_near(generic_attitudes(made), meaning, rounding);
        });
    };
    return std::ranges::is_sorted(std::span(candidate.columns).first(count_)) &&
           std::ranges::any_of(projects(), [&](const Project& project) {
               return std::ranges::any_of(split(project.specs, ';'), is_same);
           });
}

Candidate Identification::as_written(const Candidate& candidate) const {
    if (candidate.constant.count() == 0 && (candidate.is_plain() || is_of_project(candidate))) {
        return candidate;
    }
    const Attitudes meaning = generic_attitudes(candidate);
    for (const Candidate& plain : candidates_) {
        if (!plain.is_plain()) {
            continue;
        }
        for (const Turn& axes : named_axes()) {
            Candidate made = axes.of(candidate); // what was measured, under another name
            made.spec = plain.spec;
            made.columns = plain.columns;
            if (are_near(generic_attitudes(made), meaning, rounding)) {
                return made;
            }
        }
    }
    return candidate;
}

bool Identification::do_rows_suffice(const Candidate& candidate, double within) const {
    if (candidate.constant.count() == 0) {
        return true;
    }
    if (rows_ < 2 || angle_of_squared_sine(spread_) <= rounding) {
        return false;
    }
    // Along the axes, or halfway between them, other axes are changes of the numbers' signs and order.
    const double least = std::max(within, rounding);
    const double as_near = std::min(least, most_alike(candidate.angle));
    const auto is_special = [&](bool in_reference) {
        const auto vectors = relative_vectors(kept_.known, in_reference);
        const PrincipalAxes relative(scatter_of(vectors));
        const Eigen::Vector3d n = relative.axes.col(relative.sizes[1] <= least ? 2 : 0).cwiseAbs();
        const double nearest =
            std::min({n[0], n[1], n[2], std::fabs(n[0] - n[1]), std::fabs(n[1] - n[2]), std::fabs(n[0] - n[2])});
        const auto is_in_plane = [&](const Eigen::Vector3d& vector) { // its mirror image is as near
            return 4.0 * std::fabs(relative.axes.col(0).dot(vector)) <= as_near;
        };
        return nearest <= 2.0 * least && std::ranges::all_of(vectors, is_in_plane);
    };
    return !is_special(false) && !is_special(true);
}

Verdict::Ambiguity Identification::ambiguity(Verdict& verdict) const {
    using Ambiguity = Verdict::Ambiguity;
    const bool rotated = verdict.candidates.front().constant.count() > 0;
    if (rows_ < 2) {
        return Ambiguity::rows;
    }
    const double spread = angle_of_squared_sine(spread_);
    const double least = std::max(settings_.within, rounding);
    if (spread <= (rotated ? least : settings_.within)) {
        return Ambiguity::attitudes;
    }
    // SPECs of small attitudes differ by half the angle's square.
    verdict.angle = rotated ? spread : angle_of_squared_sine(greatest_angle_);
    if (verdict.angle * verdict.angle <= 4.0 * settings_.within) {
        return Ambiguity::size;
    }
    const PrincipalAxes principal(rotated ? scatter_of(relative_vectors(kept_.known, false))
                                          : Eigen::Matrix3d(scatter_ / static_cast<double>(rows_)));
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
