// Misuses of the library, each of which once gave a wrong attitude, a broken heap or a wall of errors in silence.
// The program is compiled with several flags and compilers, see misuse_test.sh.

#include <cmath>
#include <cstdio>
#include <sstream>
#include <type_traits>
#include <vector>

#include <rotconv/rotconv.hpp>

using namespace rotconv;

// Three numbers alone are not Euler angles: their sequence and unit are said.
static_assert(!std::is_default_constructible_v<EulerAngles> && !std::is_aggregate_v<EulerAngles>);
static_assert(!std::is_constructible_v<EulerAngles, Eigen::Vector3d> &&
              !std::is_constructible_v<EulerAngles, Eigen::Vector3d, EulerSequence>);

namespace {

int failures = 0;

void check(bool holds, const char* what) {
    if (!holds) {
        std::printf("FAILED: %s\n", what);
        ++failures;
    }
}

#ifdef __cpp_exceptions
template <class Exception, class Function> bool throws(const Function& function) {
    try {
        function();
    } catch (const Exception& exception) {
        return std::string_view(exception.what()).size() > 10;
    }
    return false;
}

void refused_at_run_time() {
    const Conversion conversion(Spec{}, {.name = RepresentationId::dcm});
    std::vector<RowReport> reports;
    std::vector<double> quaternions{1, 0, 0, 0, 1, 0, 0, 0};
    std::vector<double> room(9); // of one matrix
    check(throws<std::invalid_argument>([&] { conversion.run(quaternions, room, reports); }),
          "no room for two matrices");
    room.resize(18);
    conversion.run(quaternions, room, reports);
    quaternions.pop_back();
    check(throws<std::invalid_argument>([&] { conversion.run(quaternions, room, reports); }), "seven numbers");
    check(throws<std::invalid_argument>([&] { (void)read_attitude(eigen_matrix, quaternions); }), "seven of a matrix");
    Stepper stepper(Spec{}, Integrator::rk4);
    check(throws<std::invalid_argument>([&] { stepper.step(0.1, {}); }), "a step without rates");
    check(throws<std::logic_error>([] { (void)Reading(Error::none); }), "an error that is none");
    const Rotation turned;
    const Eigen::MatrixXd four = Eigen::MatrixXd::Identity(4, 4);
    check(throws<std::invalid_argument>([&] { (void)(turned * Eigen::VectorXd(four.col(0))); }),
          "R times four numbers");
    check(throws<std::invalid_argument>([&] { (void)(turned * four); }), "R times four rows");
    check(throws<std::invalid_argument>([&] { (void)dcm::to_rotation(four); }), "a matrix of 4x4");
    check(throws<std::invalid_argument>([&] { (void)Rotation(four); }), "a Rotation of 4x4");
    check(throws<std::invalid_argument>([&] { (void)mrp::to_rotation(Eigen::VectorXd(four.col(0))); }), "mrp of four");
    check(throws<std::invalid_argument>([&] { (void)rotation_vector::to_rotation(Eigen::VectorXd(four.col(0))); }),
          "a rotation vector of four");
    check(throws<std::logic_error>([] { (void)Rotation(-Eigen::Matrix3d::Identity()); }), "a reflection");
    check(throws<std::invalid_argument>([] { (void)Rotation::from_components(0, 0, 0, 0); }), "no quaternion");
    check(throws<std::invalid_argument>([&] { (void)interpolate(turned, turned, NAN); }), "a fraction that is nan");
    const Spec matrix_with_scalar{.name = RepresentationId::dcm, .scalar_last = true};
    check(throws<std::invalid_argument>([&] { Conversion(matrix_with_scalar, Spec{}); }), "dcm:xyzw");
}
#endif

} // namespace

int main() {
    // Numbers that are not finite, also where the compiler takes them for impossible.
    for (const double bad : {static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
        check(!quaternion::to_rotation({bad, 0, 0, 1}), "a quaternion");
        check(!quaternion::to_rotation({0, 0, 0, bad}, any_defect), "a quaternion, any defect");
        check(!cayley::to_rotation({bad, 0, 0}) && !cayley::to_rotation({0, 0, bad}), "a Gibbs vector");
    }
    check(!quaternion::to_rotation({NAN, 0, 0, 1}, 1e-3), "the quaternion of the issue");

    // Matrices far from a rotation.
    Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
    shear(0, 1) = 0.1;
    check(dcm::to_rotation(90.0 * Eigen::Matrix3d::Identity()).error() == Error::defect, "90 I");
    check(dcm::to_rotation(shear).error() == Error::defect && dcm::to_rotation(shear, any_defect), "a shear");
    check(quaternion::to_rotation({2, 0, 0, 0}).error() == Error::defect, "a quaternion of norm 2");

    // Eigen's order of storage, which has a name.
    const Rotation turned = *axis_angle::to_rotation({{1, 2, 3}, 0.7});
    const Eigen::Matrix3d matrix = dcm::from_rotation(turned);
    const Eigen::Quaterniond q = quaternion::from_rotation(turned);
    for (const auto& [spec, numbers] :
         {std::pair(eigen_matrix, std::vector<double>(matrix.data(), matrix.data() + 9)),
          std::pair(eigen_quaternion, std::vector<double>(q.coeffs().data(), q.coeffs().data() + 4))}) {
        check(angle_between(*read_attitude(spec, numbers), turned) < 1e-15, "the order of Eigen");
    }

    // Points are the columns of a matrix, of a size known at compile time or not.
    const Eigen::MatrixXd points = Eigen::MatrixXd::Ones(3, 5);
    const Eigen::MatrixXd moved = turned * points;
    check(moved.cols() == 5 && (moved.col(4) - matrix * points.col(4)).norm() < 1e-14, "R times points");

    // A stepper that has not started, and the words of errors.
    Stepper stepper(Spec{}, Integrator::rk4);
    const std::vector<Eigen::Vector3d> rates(3, Eigen::Vector3d::UnitX());
    check(stepper.step(0.1, rates) == Error::ended && !stepper.attitude(), "a step before start()");
    check(!message(Error::defect).empty(), "message");
    std::ostringstream printed;
    printed << eigen_matrix << ' ' << Rotation::near_unit(-0.75, 0, 0, 1);
    check(printed.str() == "dcm:col 0.6 0 0 -0.8", "operator<<");
    const auto half = interpolate(Rotation(), turned, 0.5);
    check(half && std::fabs(angle_between(*half, Rotation()) - 0.35) < 1e-14, "interpolate");
#ifdef __cpp_exceptions
    refused_at_run_time();
#endif
    return failures == 0 ? 0 : 1;
}
