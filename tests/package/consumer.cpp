// Each public class of the library, made and used by a program that is compiled for another processor than the library
// was. Expected results are known by hand.

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/rotconv.hpp>

using namespace rotconv;
using std::numbers::pi;

// A type that holds an Eigen vector of 16 or 32 bytes by value has an alignment, and so a layout, that depends on
// flags.
template <class... Public> constexpr bool have_the_layout_of_doubles = ((alignof(Public) <= alignof(double)) && ...);
static_assert(have_the_layout_of_doubles<
              Rotation, Reading, DiagnosticSet, Sensitivity, EulerSequence, EulerAngles, AxisAngle, RotationVector,
              Modifier, ModifierSet, PresetMeaning, Representation, Spec, SpecError, FixedFactor, FixedRotation,
              ConversionSettings, UnusualNumbers, PartReport, ReferenceReport, RowReport, Conversion, ContinuousNumbers,
              ComparisonSettings, Comparison, Composition, VectorRotation, IntegratorEntry, Stepper,
              PropagationSettings, Propagated, PushResult, Propagator, RateSettings, Rates, AxesChange, AxesError,
              ConstantRotations, MeanRotation, Alignment, SampleSettings, Sampler>);

// No reference into a Reading that is gone by the end of the line.
static_assert(std::is_same_v<decltype(*std::declval<Reading>()), Rotation>);

// A function that returns an Eigen expression may return references to what is gone.
constexpr auto expression = [](double t) { return t * Eigen::Vector3d::UnitX(); };
constexpr auto vector = [](double t) -> Eigen::Vector3d { return t * Eigen::Vector3d::UnitX(); };
static_assert(!AngularVelocity<decltype(expression)> && AngularVelocity<decltype(vector)>);

namespace {

int failures = 0;

void check(bool holds, const char* what) {
    if (!holds) {
        std::printf("FAILED: %s\n", what);
        ++failures;
    }
}

bool near(double a, double b) { return std::fabs(a - b) < 1e-14; }

template <class Function> bool throws_invalid_argument(const Function& function) {
    try {
        function();
    } catch (const std::invalid_argument&) {
        return true;
    }
    return false;
}

Spec spec_of(std::string_view text) { return std::get<Spec>(parse_spec(text)); }

// Each test has the quarter turn about z, which takes x to y: q = (1, 0, 0, 1)/sqrt 2.

void typed_calls() {
    const double half = std::sqrt(0.5);
    const Reading read = quaternion::to_rotation({half, 0, 0, half}, 1e-9);
    check(read && read.defect() < 1e-15 && read.error() == Error::none, "Reading");
    const Rotation& quarter = *quaternion::to_rotation({half, 0, 0, half}); // lives as long as its name
    check((quarter * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(0, 1, 0)).norm() < 1e-15, "Rotation times a vector");
    check(near((quarter * quarter).z(), 1) && near((quarter * quarter.inverse()).w(), 1), "Rotation times Rotation");
    Dcm matrix;
    matrix << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    check((dcm::from_rotation(quarter) - matrix).norm() < 1e-15 &&
              near(quaternion::from_rotation(*dcm::to_rotation(matrix)).z(), half),
          "dcm");
    const TwoColumns columns = two_column::from_rotation(quarter);
    check((columns - matrix.leftCols<2>()).norm() < 1e-15, "TwoColumns");
    check(near(five_d::from_rotation(quarter)[0], half), "five_d"); // r21/(sqrt 2 - r11)
    check(near(rotation_vector::from_rotation(quarter).vector.z(), pi / 2), "RotationVector");
    check(near(axis_angle::from_rotation(quarter, AngleUnit::degrees).angle, 90), "AxisAngle");
    check(near(cayley::from_rotation(quarter).z(), 1) && near(mrp::from_rotation(quarter).z(), std::sqrt(2.0) - 1),
          "cayley and mrp");
    check(near(euler::from_rotation(quarter, "ZYX", AngleUnit::degrees).angles[0], 90), "EulerAngles");
    check(near(quaternion::from_rotation(*euler::to_rotation({{pi / 2, 0, 0}, "ZYX", AngleUnit::radians})).z(), half),
          "EulerSequence");
    const Sensitivity sensitivity = cayley::sensitivity(quarter);
    check(near(sensitivity.margin, pi / 2) && near(sensitivity.condition, 1), "Sensitivity");
    check(euler::diagnostics(quarter, "ZXZ").has(DiagnosticKind::gimbal_lock), "DiagnosticSet");
    check((quaternion::rate({1, 0, 0, 0}, {0, 0, 2}).coeffs() - Eigen::Vector4d(0, 0, 1, 0)).norm() == 0, "rate");
}

// What Eigen, Sophus and manif say in as few words.
void few_words() {
    const Eigen::Vector3d r(0, 0, pi / 2);
    const Rotation quarter = *rotation_vector::to_rotation(r);
    check(near(rotation_vector::to_rotation({r, AngleUnit::degrees})->z(), std::sin(pi * pi / 720)), "degrees");
    check(near(rotation_vector::to_rotation(2 * r)->z(), 1), "an expression");
    const Eigen::AngleAxisd turn = axis_angle::from_rotation(quarter, AngleUnit::degrees);
    check(near(turn.angle(), pi / 2) && near(turn.axis().z(), 1) &&
              near(angle_between(*axis_angle::to_rotation(turn), quarter), 0),
          "Eigen::AngleAxisd");
    check(Rotation(turn.toRotationMatrix()) == *dcm::to_rotation(turn.toRotationMatrix()), "of a matrix");
    const Rotation one = Rotation::from_components(1, 2, 3, 4);
    check(one == Rotation::from_components(-3, -6, -9, -12) && one != one.inverse() && one != Rotation(), "==");

    const std::vector<Eigen::Quaterniond> quaternions{{0, 1, 0, 0}, {2, 0, 0, 2}};
    std::vector<Eigen::Matrix3d> matrices(2);
    std::vector<RowReport> reports;
    Conversion(eigen_quaternion, eigen_matrix, {.tolerance = any_defect})
        .run(numbers_of(quaternions), numbers_of(matrices), reports);
    check(matrices[0].diagonal() == Eigen::Vector3d(1, -1, -1) && matrices[1](1, 0) == 1, "vectors of Eigen's types");

    ContinuousNumbers following({.name = RepresentationId::euler, .sequence = "ZYX"});
    std::array<double, 3> angles{};
    for (int i = 0; i <= 100; ++i) { // the last is past a half-turn
        following.next(*axis_angle::to_rotation({{0, 0, 1}, 0.04 * i}), angles);
    }
    check(near(angles[0] / 4, 1), "ContinuousNumbers::next()");

    Eigen::Matrix3Xd points(3, 2);
    points << 1, 0, 0, 2, 0, 0; // columns along x and y
    const Eigen::Matrix3Xd turned = quarter * points;
    check(turned.cols() == 2 && near(turned(1, 0), 1) && near(turned(0, 1), -2), "Rotation times columns");
}

void readings_have_a_tolerance() {
    const Reading wrong = quaternion::to_rotation({1, 2, 3, 4}); // |q| = sqrt 30
    check(!wrong && wrong.error() == Error::defect && near(wrong.defect(), std::sqrt(30.0) - 1), "tolerance of quat");
    check(bool(quaternion::to_rotation({1, 2, 3, 4}, any_defect)), "any defect");
    Dcm shear = Dcm::Identity();
    shear(0, 1) = 1e-2;
    check(dcm::to_rotation(shear, 1e-3).error() == Error::defect && dcm::to_rotation(shear, 1e-2), "tolerance of dcm");
    const TwoColumns columns = shear.leftCols<2>();
    check(two_column::to_rotation(columns, 1e-3).error() == Error::defect, "tolerance of 6d");
    check(bool(five_d::to_rotation(five_d::from_rotation({}), 1e-15)), "tolerance of 5d");
}

void rows() {
    std::vector<RowReport> reports;
    const std::array<double, 6> yaw_pitch_roll{90, 0, 0, 90, 90, 0};
    std::array<double, 8> quaternions{};
    const FixedRotation left(*axis_angle::to_rotation({{1, 0, 0}, 0}));
    const AxesChange enu = std::get<AxesChange>(parse_axes("ned:enu")); // a half-turn about x = y
    check(enu.matrix(0, 1) == 1 && !enu.changes_hand() && near((left * enu.rotation()).rotation.z(), 0), "AxesChange");
    const std::array<double, 4> angle_first{7, 0, 0, 8};
    const UnusualNumbers found = unusual_numbers(spec_of("axis-angle"), angle_first);
    check(near(found.defect, 6) && found.angle == 8, "unusual_numbers");
    ConversionSettings settings;
    settings.left = left;
    Conversion(spec_of("euler:ZYX:deg"), Spec{}, settings).run(yaw_pitch_roll, quaternions, reports);
    check(near(quaternions[3], std::sqrt(0.5)) && near(quaternions[5], -0.5) && reports.empty(), "Conversion");
    check(near(read_attitude(spec_of("quat:xyzw"), std::array<double, 4>{0, 0, 1, 0})->z(), 1), "read_attitude");

    ContinuousNumbers continuous(spec_of("quat"));
    std::array<double, 8> turned{0, 0, 0, 1, 0.6, 0, 0, -0.8};
    continuous.run(turned, {});
    check(turned[4] == -0.6 && turned[7] == 0.8, "ContinuousNumbers");

    const Comparison comparison(spec_of("rpy:deg"), spec_of("quat"),
                                ComparisonSettings{.per_radian = degrees_per_radian});
    std::array<double, 1> angle{};
    comparison.run(std::array<double, 7>{0, 0, 90, 1, 0, 0, 0}, angle, reports);
    check(near(angle[0], 90), "Comparison");

    const Composition composition(spec_of("quat:passive"), spec_of("rpy:deg"), spec_of("rotvec:deg"));
    std::array<double, 3> product{};
    composition.run(std::array<double, 7>{1, 0, 0, 0, 0, 0, 90}, product, reports);
    check(near(product[2], 90), "Composition");

    const VectorRotation rotation(spec_of("rpy:deg"));
    std::array<double, 3> vector{};
    rotation.run(std::array<double, 6>{0, 0, 90, 1, 0, 0}, vector, reports);
    check(near(vector[1], 1), "VectorRotation");

    const Rates rates(spec_of("rpy"), RateSettings{});
    std::array<double, 3> angle_rates{};
    rates.run(std::array<double, 6>{0, 0, 1, 0, 0, 2}, angle_rates, reports);
    check(angle_rates[2] == 2 && reports.empty(), "Rates");

    const SampleSettings sampling{.kinds = sample_kinds_of(RepresentationId::dcm)};
    std::array<double, 9> sample{};
    Sampler(spec_of("dcm"), sampling).run(std::array{7.0}, sample);
    check(static_cast<bool>(read_attitude(spec_of("dcm"), sample)) && name_of(SampleKind::cube) == "cube", "Sampler");
}

void motion() {
    const auto omega = [](double t) -> Eigen::Vector3d {
        return Eigen::Vector3d(0, 0, t);
    }; // half a radian in a second
    Stepper stepper(spec_of("mrp"), Integrator::rk4);
    stepper.start({});
    check(integrate(stepper, omega, 0, 0.01, 100) == Error::none, "integrate");
    check(std::fabs(stepper.numbers()[2] - std::tan(0.125)) < 1e-9, "Stepper"); // tan(theta/4)
    Propagator propagator(PropagationSettings{});
    PushResult pushed = propagator.push(0, {0, 0, 0});
    pushed = propagator.push(1, {0, 0, pi});
    const Propagated& answer = *pushed.answer;
    check(near(rotation_vector::from_rotation(*answer.attitude).vector.z(), pi / 2), "Propagator");

    // The exponential steps are the quaternion's, and axis-angle has no rates.
    const PropagationSettings matrix_by_exponentials{.representation = spec_of("dcm")};
    check(throws_invalid_argument([&] { Propagator{matrix_by_exponentials}; }), "dcm with magnus4");
    check(throws_invalid_argument([] { Stepper(spec_of("mrp"), Integrator::magnus6); }), "mrp with magnus6");
    check(throws_invalid_argument([] { Stepper(spec_of("axis-angle"), Integrator::rk4); }), "axis-angle");
    check(throws_invalid_argument([] { Rates{spec_of("axis-angle")}; }), "rates of axis-angle");
}

void tables() {
    check(integrators().size() == 3 && entry_of(Integrator::magnus6).order == 6, "tables");
    const Representation& entry = representation(RepresentationId::dcm);
    check(entry.size == 9 && entry.modifiers.has(Modifier::col) && !entry.presets.empty(), "Representation");
    check(std::get<SpecError>(parse_spec("quat:deg")).what == SpecError::What::meaningless_modifier, "SpecError");
    const ModifierSet spice = meaning_of("spice", entry).modifiers;
    check(spice.has(Modifier::passive) && entry.presets[0].modifiers.has(Modifier::passive), "PresetMeaning");
}

} // namespace

int main() {
    typed_calls();
    few_words();
    readings_have_a_tolerance();
    rows();
    motion();
    tables();
    return failures == 0 ? 0 : 1;
}
