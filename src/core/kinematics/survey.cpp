#include <rotconv/survey.hpp>

#include <algorithm>
#include <cmath>

#include <rotconv/quaternion.hpp>

#include "../representations/codec.hpp"

namespace rotconv {
namespace {

using Numbers = std::array<double, 9>;

/// A change of parameters that may be a jump: each one has at least the size 2 (a switch to the shadow, a new sign).
constexpr double least_jump = 1.0;
/// A greater condition explains no more: the arcs that it would need are rounding.
constexpr double greatest_explanation = 1e15;

Rotation unit(const Rotation& rotation) noexcept {
    const Eigen::Quaterniond q = quaternion::from_rotation(rotation);
    return Rotation::near_unit(q.w(), q.x(), q.y(), q.z());
}

Numbers numbers_of(const Spec& set, const Rotation& rotation) noexcept {
    Numbers numbers{};
    codec_of(set.name).write_row(set, rotation, numbers.data());
    return numbers;
}

double distance(const Numbers& a, const Numbers& b) noexcept {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return std::sqrt(sum);
}

/// The shortest rotation between two unit quaternions.
struct Arc {
    Rotation from;
    Rotation to;

    /// Of both signs of the second quaternion the one that makes the arc short.
    Arc(const Rotation& a, const Rotation& b) noexcept : from(a), to(b) {
        if ((a.w() * b.w() + a.x() * b.x()) + (a.y() * b.y() + a.z() * b.z()) < 0.0) {
            to = Rotation::near_unit(-b.w(), -b.x(), -b.y(), -b.z());
        }
    }

    /// The rotation angle, from the chord 2 sin(angle/4).
    [[nodiscard]] double angle() const noexcept {
        const double chord = std::hypot(std::hypot(to.w() - from.w(), to.x() - from.x()),
                                        std::hypot(to.y() - from.y(), to.z() - from.z()));
        return 4.0 * std::asin(std::min(chord / 2.0, 1.0));
    }

    [[nodiscard]] Rotation middle() const noexcept {
        const double w = from.w() + to.w();
        const double x = from.x() + to.x();
        const double y = from.y() + to.y();
        const double z = from.z() + to.z();
        const double norm = std::hypot(std::hypot(w, x), std::hypot(y, z));
        return Rotation::near_unit(w / norm, x / norm, y / norm, z / norm);
    }
};

/// As Survey says: halves the arc, keeping the half with the larger step.
bool has_jump(const Spec& set, Arc arc, Numbers from, Numbers to, double condition) noexcept {
    condition = std::min(condition, greatest_explanation);
    double angle = arc.angle();
    double step = distance(from, to);
    while (step > least_jump) {
        if (step > 2.0 * condition * angle) {
            return true;
        }
        const Rotation middle = arc.middle();
        const Numbers half = numbers_of(set, middle);
        const double first = distance(from, half);
        const double second = distance(half, to);
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
                    sets_.push_back({.set = {.name = name, .sequence = sequence}});
                }
            }
        } else if (!representation(name).has_gimbal_lock) { // else one of the sequences
            sets_.push_back({.set = {.name = name}});
        }
    }
    states_.resize(sets_.size());
}

void Survey::add(const Rotation& rotation, std::size_t row) noexcept {
    const Rotation now = unit(rotation);
    for (std::size_t i = 0; i < sets_.size(); ++i) {
        SetSurvey& survey = sets_[i];
        const Sensitivity sensitivity = codec_of(survey.set.name).sensitivity(survey.set, now);
        const State state{numbers_of(survey.set, now), sensitivity.condition};
        if (rows_ == 0 || sensitivity.margin < survey.least_margin) {
            survey.least_margin = sensitivity.margin;
            survey.margin_row = row;
        }
        if (rows_ == 0 || sensitivity.condition > survey.greatest_condition) {
            survey.greatest_condition = sensitivity.condition;
            survey.condition_row = row;
        }
        if (rows_ > 0 && has_jump(survey.set, {latest_, now}, states_[i].numbers, state.numbers,
                                  std::max(states_[i].condition, state.condition))) {
            survey.jump_row = survey.jumps++ == 0 ? row : survey.jump_row;
        }
        states_[i] = state;
    }
    latest_ = now;
    ++rows_;
}

const SetSurvey* Survey::smallest(double limit) const noexcept {
    const SetSurvey* best = nullptr;
    for (const SetSurvey& survey : sets_) {
        const bool smaller =
            best == nullptr || survey.set.size() < best->set.size() ||
            (survey.set.size() == best->set.size() && survey.greatest_condition < best->greatest_condition);
        if (survey.serves(limit) && smaller) {
            best = &survey;
        }
    }
    return best;
}

} // namespace rotconv
