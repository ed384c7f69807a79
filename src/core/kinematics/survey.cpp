#include "survey.hpp"

#include <algorithm>

#include <rotconv/quaternion.hpp>

#include "../numerics/elementary.hpp"
#include "../representations/codec.hpp"
#include "../representations/rotation_angle.hpp"

namespace rotconv {
namespace {

/// A change of parameters that may be a jump: each one has at least the size 2 (a switch to the shadow, a new sign).
constexpr double least_jump = 1.0;
/// A longer rotation may pass a switch and end near to where it began: it is looked at in parts.
constexpr double longest_part = 1.0;
/// A greater condition explains no more: the arcs that it would need are rounding.
constexpr double greatest_explanation = 1e15;

using Numbers = Eigen::Matrix<double, 9, 1>;
using Unit = Eigen::Vector4d; ///< a unit quaternion

Numbers numbers_of(const Spec& spec, const Unit& q) noexcept {
    Numbers numbers = Numbers::Zero();
    write_row(spec, rotation_at(q.data()), numbers.data());
    return numbers;
}

/// The shortest rotation between two unit quaternions.
struct Arc {
    Unit from;
    Unit to;

    /// Takes the sign of the second quaternion that makes the arc short.
    Arc(const Unit& a, const Unit& b) noexcept
        : from(a), to((a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]) < 0.0 ? Unit(-b) : b) {}

    /// The rotation angle, from the chords 2 sin(angle/4) and 2 cos(angle/4).
    [[nodiscard]] double angle() const noexcept {
        return 4.0 * angle_of((to + from).stableNorm(), (to - from).stableNorm(), AngleUnit::radians).hi;
    }
    [[nodiscard]] Unit middle() const noexcept { return (from + to).stableNormalized(); }
};

/// As Survey says: halves the arc, keeping the half with the larger step.
// NOLINTNEXTLINE(misc-no-recursion): a half-turn is cut twice
bool has_jump(const Spec& spec, Arc arc, double angle, Numbers from, Numbers to, double condition) noexcept {
    condition = std::min(condition, greatest_explanation);
    if (angle > longest_part) {
        const Unit middle = arc.middle();
        const Numbers half = numbers_of(spec, middle);
        const Arc first(arc.from, middle);
        const Arc second(middle, arc.to);
        return has_jump(spec, first, first.angle(), from, half, condition) ||
               has_jump(spec, second, second.angle(), half, to, condition);
    }
    double step = (to - from).norm();
    while (step > least_jump) {
        if (step > 2.0 * condition * angle) {
            return true;
        }
        const Unit middle = arc.middle();
        const Numbers half = numbers_of(spec, middle);
        const double first = (half - from).norm();
        const double second = (to - half).norm();
        if (first >= second) {
            arc = {arc.from, middle};
            to = half;
        } else {
            arc = {middle, arc.to};
            from = half;
        }
        step = std::max(first, second);
        angle /= 2.0;
    }
    return false;
}

} // namespace

Survey::Survey() {
    for (const RepresentationId name : all_representations) {
        if (representation(name).takes_sequence) {
            for (const EulerSequence sequence : EulerSequence::all()) {
                if (sequence.intrinsic()) {
                    surveys_.push_back({.spec = {.name = name, .sequence = sequence}});
                }
            }
        } else if (!representation(name).has_gimbal_lock) { // else one of the sequences
            surveys_.push_back({.spec = {.name = name}});
        }
    }
    states_.resize(surveys_.size());
}

void Survey::add(const Rotation& rotation, std::size_t row) noexcept {
    const Eigen::Quaterniond q = quaternion::from_rotation(rotation);
    const Unit now(q.w(), q.x(), q.y(), q.z());
    const Arc arc(rows_ > 0 ? Unit(latest_.data()) : now, now);
    const double angle = arc.angle();
    for (std::size_t i = 0; i < surveys_.size(); ++i) {
        RepresentationSurvey& survey = surveys_[i];
        const Sensitivity sensitivity = codec_of(survey.spec.name).sensitivity(survey.spec, rotation_at(now.data()));
        const State state{numbers_of(survey.spec, now), sensitivity.condition};
        if (rows_ == 0 || sensitivity.margin < survey.least_margin) {
            survey.least_margin = sensitivity.margin;
            survey.margin_row = row;
        }
        if (rows_ == 0 || sensitivity.condition > survey.greatest_condition) {
            survey.greatest_condition = sensitivity.condition;
            survey.condition_row = row;
        }
        if (rows_ > 0 && has_jump(survey.spec, arc, angle, states_[i].numbers, state.numbers,
                                  std::max(states_[i].condition, state.condition))) {
            survey.jump_row = survey.jumps++ == 0 ? row : survey.jump_row;
        }
        states_[i] = state;
    }
    latest_ = {now[0], now[1], now[2], now[3]};
    ++rows_;
}

const RepresentationSurvey* Survey::smallest(double limit) const noexcept {
    const RepresentationSurvey* best = nullptr;
    for (const RepresentationSurvey& survey : surveys_) {
        const bool smaller =
            best == nullptr || survey.spec.size() < best->spec.size() ||
            (survey.spec.size() == best->spec.size() && survey.greatest_condition < best->greatest_condition);
        if (survey.serves(limit) && smaller) {
            best = &survey;
        }
    }
    return best;
}

} // namespace rotconv
