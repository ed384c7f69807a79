// The worst rows that are known of plain double arithmetic: random rows stay well below the limits, these are near to
// them. They come from a search that changes the numbers of a row, by units in their last places or by more, and keeps
// what makes the error greater.

#include <algorithm>
#include <iterator>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include <rotconv/rotconv.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"

using namespace rotconv;
using accuracy::spec;

namespace {

/// A Conversion, or typed calls both ways.
enum class By { fast, typed };

struct KnownRow {
    std::string from, to;
    By by;
    const char* text;

    [[nodiscard]] std::vector<double> numbers() const {
        std::istringstream words(text);
        return {std::istream_iterator<double>(words), {}};
    }
};

const std::vector<KnownRow>& known_rows() {
    static const std::vector<KnownRow> rows{
        {"quat", "quat", By::fast, "-1.0050070047764932 -1.0050085216525622 1.0049976073705036 1.0050060778621439"},
        {"quat", "dcm", By::typed,
         "-0.25261917552041524 -0.019782616106039274 0.019782616106039184 -0.50523835279550244"},
        {"quat", "6d", By::fast,
         "-6.2481982272827137e+71 3.1240991139247028e+71 -6.2080427842800383e+63 -3.1240991139469134e+71"},
        {"quat", "5d", By::fast,
         "0.70712400824108756 7.450387783077951e-09 0.70711457969951186 7.4505805969237636e-09"},
        {"quat", "rotvec", By::fast,
         "2.8430558497452138e+117 2.6906184862824396e+118 1.3453092431412198e+118 2.6906184862824396e+118"},
        {"quat", "rotvec", By::typed,
         "8.8864766020982649e-15 0.66416433954081255 -0.65553324695332249 0.34575757964572157"},
        {"quat", "axis-angle:deg", By::fast,
         "-2.4853127503045386e-26 2.4233180393152617e-26 3.6705602880569594e-26 -2.7504578390280622e-26"},
        {"quat", "cayley", By::typed,
         "-1.2195159417516286e-11 -6.2445860885020574e-09 -1.2195264363644244e-11 6.243921622122451e-09"},
        {"quat", "mrp", By::fast, "-0.27687128812968687 -1.1094782394744016 1.1094782394744016 -1.1094782394744016"},
        {"quat", "euler:YXZ:deg", By::fast,
         "0.25000156876264773 -0.25000545304390698 -0.25000279580190571 -0.25000242373396508"},
        {"dcm", "quat", By::fast,
         "8.3460621746885916e-10 4.2185511650660579e-08 1.0000006644944475 -2.0635534175637202e-08 1.0000015537664817 "
         "3.143643728698831e-08 -0.99999998555611913 -1.1024780874362815e-08 8.9620966203428237e-10"},
        {"6d", "quat", By::fast,
         "-0.33334716106356477 0.66668081391251854 -0.66664560492482894 0.6666808139143453 -0.33329120992995021 "
         "-0.66667357960362472"},
        {"5d", "quat", By::fast,
         "0.70716780549418101 -8.103259780520858e-05 -0.70716781011871399 8.6315982696356732e-05 "
         "7.6308267883576699e-06"},
        {"cayley", "quat", By::fast, "-0.99921670797129269 0.9999996502894406 0.9999996502894406"},
        {"mrp", "quat", By::typed, "-1.6334466315452421 0.1763707174433802 1.5418855858209028"},
        {"euler:xyz:deg", "quat", By::fast, "-36.676309194359469 87.790089696903408 243.77384669672333"},
        {"rotvec:deg", "quat", By::fast, "-31.741938104492412 90.603758770586708 -2.1061934570162094e-05"},
        {"rotvec:deg", "quat", By::typed, "-6039.5840526271822 -1440.3226258633892 -4.6357924605388662e-05"},
        {"axis-angle", "quat", By::typed,
         "-5.9053326120055537e-09 -4.9068620111382115e-09 -0.71449184783536801 -1.5707963356201153"},
        {"rotvec:deg", "dcm", By::fast, "43.087491943516696 -86.174983887033392 -1.4330098242676818e-08"},
        {"quat", "dcm", By::fast,
         "1.0002713857608075e+115 -2.0005427715211614e+115 1.0002713857656628e+115 -2.0005427715211614e+115"},
        {"quat", "euler:ZYX", By::fast,
         "-4.0256243201269122 -1.4685558283668912e-15 4.5131920019443355 -1.468386938332629e-15"},
        {"euler:zxz:deg", "quat", By::fast, "134.99999999998013 -11.500756305917079 112.67973324365263"},
    };
    return rows;
}

std::vector<double> typed(const Spec& to, const Rotation& rotation) {
    const auto list = [](const auto& numbers) { return std::vector<double>(numbers.begin(), numbers.end()); };
    switch (to.name) {
    case RepresentationId::dcm: return list(dcm::from_rotation(rotation).transpose().reshaped());
    case RepresentationId::two_column: return list(two_column::from_rotation(rotation).reshaped());
    case RepresentationId::five_d: return list(five_d::from_rotation(rotation));
    case RepresentationId::rotvec: return list(rotation_vector::from_rotation(rotation, to.unit).vector);
    case RepresentationId::axis_angle: {
        const AxisAngle value = axis_angle::from_rotation(rotation, to.unit);
        return {value.axis.x(), value.axis.y(), value.axis.z(), value.angle};
    }
    case RepresentationId::cayley: return list(cayley::from_rotation(rotation));
    case RepresentationId::mrp: return list(mrp::from_rotation(rotation));
    case RepresentationId::euler:
    case RepresentationId::rpy: return list(euler::from_rotation(rotation, to.sequence, to.unit, 0.0).angles);
    case RepresentationId::quat: {
        const Eigen::Quaterniond q = quaternion::from_rotation(rotation);
        return {q.w(), q.x(), q.y(), q.z()};
    }
    }
    return {};
}

oracle::Quaternion exact(const Rotation& r) {
    return oracle::attitude(spec("quat"), std::vector<double>{r.w(), r.x(), r.y(), r.z()});
}

double error_of(const KnownRow& row) {
    const Spec from = spec(row.from);
    const Spec to = spec(row.to);
    const std::vector<double> numbers = row.numbers();
    const auto given = oracle::attitude(from, numbers);
    const auto found =
        row.by == By::fast ? accuracy::fast(from, to)(numbers) : typed(to, *read_attitude(from, numbers));
    return oracle::error_in_eps(given, oracle::attitude(to, found));
}

std::string name_in_table(const std::string& text) {
    const Representation& entry = representation(spec(text).name);
    return std::string(entry.text);
}

} // namespace

// Catches a limit below what is known, and a table whose worst error is not that of these rows.
TEST_CASE("the worst rows that are known stay within the limits") {
    for (const auto& way : accuracy::ways()) {
        double worst = 0.0;
        for (const KnownRow& row : known_rows()) {
            if (name_in_table(row.from) == way.from && name_in_table(row.to) == way.to) {
                worst = std::max(worst, error_of(row));
            }
        }
        INFO(way.from << " to " << way.to);
        CHECK(worst == Approx(way.worst).margin(0.006));
        CHECK(worst <= way.limit);
    }
}

// Catches a limit in rotation.hpp below what is known.
TEST_CASE("the worst products of rotations that are known stay within the limit") {
    const auto error = [](const std::vector<double>& v) {
        const Rotation a = Rotation::near_unit(v[0], v[1], v[2], v[3]);
        const Rotation b = Rotation::near_unit(v[4], v[5], v[6], v[7]);
        return oracle::error_in_eps(exact(a) * exact(b), exact(a * b));
    };
    const double worst = error({0.25075279346784179, 0.25092684693476652, -0.25086610582773944, 0.25092767371460101,
                                0.49999999838061238, -0.50000000002553258, -0.50000000453201821, -0.50000000000109313});
    CHECK(worst == Approx(3.63).margin(0.006));
    CHECK(worst <= 4.25);
}

// Catches the same.
TEST_CASE("the worst turns of a vector that are known stay within the limit") {
    const auto error = [](const std::vector<double>& v) {
        const Rotation rotation = Rotation::near_unit(v[0], v[1], v[2], v[3]);
        const Eigen::Vector3d vector(v[4], v[5], v[6]);
        const oracle::Vector3 turned = exact(rotation) * vector.cast<oracle::Real>();
        const oracle::Vector3 off = (rotation * vector).cast<oracle::Real>() - turned;
        return static_cast<double>(off.norm() / turned.norm()) / oracle::eps;
    };
    const double worst = error({-0.013731459228014354, -3.2299448211179612e-12, -1.0018520137429268,
                                -0.013731459228014338, 1.013333474036364, 3.6162418438766665e-05, 0.12066403661043733});
    CHECK(worst == Approx(9.24).margin(0.006));
    CHECK(worst <= 10.75);
}
