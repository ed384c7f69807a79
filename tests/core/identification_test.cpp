// Conventions are found again, and those that cannot be told apart are called so.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "../../src/core/identification/identification.hpp"
#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"

using namespace rotconv;
using accuracy::spec;

namespace {

using Row = std::vector<double>;
using Columns = std::vector<int>; ///< for each number of a SPEC the column that holds it, from 0

Columns identity_order(std::size_t count) {
    Columns columns;
    for (std::size_t i = 0; i < count; ++i) {
        columns.push_back(static_cast<int>(i));
    }
    return columns;
}

std::vector<Row> wide_attitudes(std::size_t count) {
    std::mt19937_64 random(20261113);
    std::normal_distribution<double> normal;
    std::vector<Row> rows(count, Row(4));
    for (Row& row : rows) {
        std::ranges::generate(row, [&] { return normal(random); });
    }
    return rows;
}

Row converted(const Row& numbers, const Spec& from, const Spec& to) {
    return accuracy::converted(from, to, numbers, {.tolerance = HUGE_VAL}).numbers;
}

/// The numbers of a SPEC in their columns, then the known attitude.
Row row_of(const Row& attitude, const Spec& unknown, const Columns& columns, const Spec& known) {
    const Row numbers = converted(attitude, Spec{}, unknown);
    Row row(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        row[static_cast<std::size_t>(columns[i])] = numbers[i];
    }
    return accuracy::joined(row, converted(attitude, Spec{}, known));
}

std::vector<Row> rows_of(const std::vector<Row>& attitudes, const Spec& unknown, const Columns& columns,
                         const Spec& known = spec("dcm")) {
    std::vector<Row> rows;
    for (const Row& attitude : attitudes) {
        rows.push_back(row_of(attitude, unknown, columns, known));
    }
    return rows;
}

/// Rows without motion, then as many of yaw, roll and pitch alone, each growing from nothing.
std::vector<Row> single_turns(std::size_t count) {
    std::vector<Row> attitudes(count, {1, 0, 0, 0});
    for (const std::size_t axis : {2U, 0U, 1U}) {
        for (std::size_t i = 0; i < count; ++i) {
            Row angles(3);
            angles[axis] = 5e-3 * static_cast<double>(i * i) / static_cast<double>(count);
            attitudes.push_back(converted(angles, spec("rpy"), Spec{}));
        }
    }
    return rows_of(attitudes, spec("rpy"), {0, 1, 2});
}

/// Adds rows, the first of which is 1, so many at once.
std::vector<RowReport> add(Identification& identification, const std::vector<Row>& rows, std::size_t at_once = 1000) {
    std::vector<RowReport> all;
    std::vector<RowReport> reports;
    for (std::size_t first = 0; first < rows.size(); first += at_once) {
        Row numbers;
        std::vector<std::size_t> lines;
        for (std::size_t i = first; i < std::min(first + at_once, rows.size()); ++i) {
            numbers.insert(numbers.end(), rows[i].begin(), rows[i].end());
            lines.push_back(i + 1);
        }
        identification.add(numbers, lines, reports);
        for (RowReport& report : reports) {
            report.row += first;
            all.push_back(report);
        }
    }
    return all;
}

/// A candidate as text: the SPEC and the columns from 1.
std::string text_of(const Candidate& candidate) {
    std::string text = candidate.spec.text() + ' ';
    for (std::size_t i = 0; i < candidate.spec.size(); ++i) {
        text += std::to_string(candidate.columns.at(i) + 1);
    }
    return text;
}

/// The one candidate that fits; else how many there are.
std::string answer(const Identification& identification) {
    const std::size_t fitting = identification.verdict().fitting;
    return fitting == 1 ? text_of(identification.best_first().front()) : std::to_string(fitting);
}

std::string identified(const std::vector<Row>& rows, std::size_t count, std::string_view known = "dcm",
                       double within = 1e-3) {
    Identification identification(count, spec(known), {}, {.within = within});
    CHECK(add(identification, rows).empty());
    return answer(identification);
}

Verdict::Ambiguity lack_of(const std::vector<Row>& rows) {
    Identification identification(3, spec("dcm"));
    add(identification, rows);
    CHECK(identification.verdict().fitting > 1);
    return identification.verdict().ambiguity;
}

/// The letters and signs in another order, the letters in the other case, all signs as given or all changed.
EulerSequence other_case(const EulerSequence& sequence, std::array<std::size_t, 3> order, double sign) {
    std::string letters;
    for (const std::size_t i : order) {
        letters += sign * sequence.sign(i) < 0.0 ? "-" : "";
        letters += static_cast<char>((sequence.intrinsic() ? 'x' : 'X') + sequence.axis(i));
    }
    return *EulerSequence::parse(letters);
}

std::ptrdiff_t signs_of(const Spec& spec) { return std::ranges::count(spec.text(), '-') + (spec.passive ? 1 : 0); }

/// What is made of a SPEC's name and a list of columns by the rules: intrinsic turns are the extrinsic ones read
/// backwards, the inverse is that with all signs changed, the transpose is the inverse, and xyz is rpy.
std::string called(Spec meant, Columns columns) {
    if (representation(meant.name).has_gimbal_lock) {
        Columns reversed(columns.rbegin(), columns.rend());
        if (reversed < columns) {
            columns = reversed;
            meant.sequence = other_case(meant.sequence, {2, 1, 0}, 1.0);
        }
        meant.name = RepresentationId::euler;
        Spec inverse = meant;
        inverse.passive = !meant.passive;
        inverse.sequence = other_case(meant.sequence, {0, 1, 2}, -1.0);
        const bool is_simpler =
            std::pair(signs_of(inverse), inverse.passive) < std::pair(signs_of(meant), meant.passive);
        meant = is_simpler ? inverse : meant;
    } else if (meant.name == RepresentationId::dcm) {
        meant.column_major = meant.column_major != meant.passive;
        meant.passive = false;
    }
    if (meant.name == RepresentationId::euler && meant.sequence == roll_pitch_yaw) {
        meant.name = RepresentationId::rpy;
    }
    Candidate candidate{.spec = meant};
    std::ranges::transform(columns, candidate.columns.begin(), [](int column) { return std::uint8_t(column); });
    return text_of(candidate);
}

} // namespace

// Catches a candidate that is left out, columns that are read the wrong way round, SPECs that differ taken for one,
// SPECs that are one taken for two, and a name that is not the simplest.
TEST_CASE("every SPEC is identified by its numbers, in every order of the columns") {
    const auto attitudes = wide_attitudes(6);
    for (const std::string& text : accuracy::combined_specs()) {
        INFO(text);
        const Spec unknown = spec(text);
        if (unknown.positive) { // which is for output
            continue;
        }
        std::vector<Columns> orders{identity_order(unknown.size())};
        while (representation(unknown.name).has_gimbal_lock && orders.size() < 6) {
            orders.push_back(orders.back());
            std::ranges::next_permutation(orders.back());
        }
        if (unknown.name == RepresentationId::axis_angle) {
            orders.push_back({1, 2, 3, 0}); // the angle first
        } else if (unknown.name == RepresentationId::two_column) {
            orders.push_back({0, 2, 4, 1, 3, 5}); // row by row
        }
        for (const Columns& columns : orders) {
            const std::string found = identified(rows_of(attitudes, unknown, columns), unknown.size());
            if (found != called(unknown, columns)) {
                CHECK(found == called(unknown, columns));
            }
        }
    }
}

// Catches candidates that are counted twice or not at all. Of three numbers: 24 sequences, as 12 in 6 orders with 8
// choices of signs, which are those of the inverse too, in degrees or radians; rotvec in these, passive or not;
// cayley and mrp, passive or not. Of four: the scalar first or last, and the angle, passive or not, in degrees or
// radians. Of six: one column after the other, or row by row, passive or not.
TEST_CASE("there are so many conventions of a count of numbers") {
    const auto count = [](std::size_t numbers, std::optional<RepresentationId> name = {}) {
        return Identification(numbers, spec("quat"), name).best_first().size();
    };
    CHECK(count(3) == 12 * 6 * 8 * 2 + 4 + 2 + 2);
    CHECK(count(4) == 2 * 2 + 2 * 4);
    CHECK(count(5) == 2);
    CHECK(count(6) == 2 * 2);
    CHECK(count(9) == 2);
    CHECK(count(3, RepresentationId::euler) == 1152);
    CHECK(count(3, RepresentationId::rpy) == 24);
    CHECK(count(3, RepresentationId::mrp) == 2);
    CHECK(count(4, RepresentationId::quat) == 4);
    CHECK(count(7) == 0);
    for (const std::size_t numbers : {0U, 1U, 2U, 7U, 8U, 10U}) {
        CHECK(!Identification::is_count(numbers));
    }
    CHECK(Identification::is_count(5));
    const auto three = Identification(3, spec("quat")).best_first();
    CHECK(std::ranges::count_if(three, [](const Candidate& candidate) {
              return candidate.columns[0] == 0 && candidate.columns[1] == 1;
          }) == 392);
}

// Catches candidates that are the same attitude on a generic row.
TEST_CASE("one wide row is enough, and its candidates all differ") {
    const auto attitudes = wide_attitudes(1);
    CHECK(identified(rows_of(attitudes, spec("euler:zxz:deg:passive"), {0, 1, 2}), 3, "dcm", 1e-9) ==
          "euler:zxz:deg:passive 123");
}

// Catches an angle that is taken from the angles' differences. Yaw - roll is all that counts.
TEST_CASE("rows at gimbal lock tell what they can") {
    std::vector<Row> rows;
    for (int i = 0; i < 5; ++i) {
        const Row unknown{20.0 + 31 * i, 90, 10.0 * i};
        rows.push_back(accuracy::joined(unknown, converted(unknown, spec("euler:ZYX:deg"), spec("dcm"))));
    }
    Identification locked(3, spec("dcm"));
    add(locked, rows);
    const auto best = locked.best_first();
    CHECK(std::ranges::any_of(best, [&](const Candidate& candidate) {
        return locked.fits(candidate) && text_of(candidate) == "euler:ZYX:deg 123" && candidate.angle < 1e-15;
    }));
    // with rows off lock there is no doubt
    const auto wide = rows_of(wide_attitudes(2), spec("euler:ZYX:deg"), {0, 1, 2});
    rows.insert(rows.end(), wide.begin(), wide.end());
    CHECK(identified(rows, 3) == "euler:ZYX:deg 123");
}

// Catches an answer that is one of many, and a reason that does not hold.
TEST_CASE("narrow rows are ambiguous, and it is said why") {
    using Ambiguity = Verdict::Ambiguity;
    const Columns plain{0, 1, 2};
    const auto of = [&](const std::vector<Row>& angles) {
        std::vector<Row> attitudes;
        for (const Row& row : angles) {
            attitudes.push_back(converted(row, spec("rpy:deg"), Spec{}));
        }
        return rows_of(attitudes, spec("rpy:deg"), plain);
    };
    // Yaw alone: of the 12 sequences, with their orders of columns, those that turn about z by the third column: six
    // have z once among three axes, two in the middle, each with 2 orders of the others; two have z twice, with 4.
    // The signs of the other two do not count. And the rotation vector.
    Identification yaw(3, spec("dcm"));
    add(yaw, of({{0, 0, 30}, {0, 0, 100}, {0, 0, -70}}));
    CHECK(yaw.verdict().fitting == ((6 + 2) * 2 + 2 * 4) * 4 + 1);
    CHECK(yaw.verdict().ambiguity == Ambiguity::axes);
    CHECK(yaw.verdict().axis.isApprox(Eigen::Vector3d(0, 0, 1)));
    CHECK(lack_of(of({{0, 0, 30}})) == Ambiguity::rows);
    CHECK(lack_of(of({{0, 0, 30}, {0, 0, 30}})) == Ambiguity::attitudes);
    CHECK(lack_of(of({{1, 0.5, 1}, {0.3, 2, -1}, {2, -1, 0.5}})) == Ambiguity::size);
    Identification two(3, spec("dcm"));
    add(two, of({{0, 10, 30}, {0, -50, 100}, {0, 20, -70}})); // ZYX and ZYZ
    CHECK(two.verdict().ambiguity == Ambiguity::zero);
    CHECK(two.verdict().column == 0);
    Identification twins(3, spec("dcm")); // roll and yaw may change places with the order of turns
    add(twins, of({{20, 10, 20}, {30, -50, 30}, {-70, 20, -70}}));
    CHECK(twins.verdict().fitting > 1);
    CHECK(twins.verdict().ambiguity == Ambiguity::equal);
    CHECK(twins.verdict().column == 0);
    CHECK(twins.verdict().other == 2);
    CHECK(lack_of(of({{0, 0, 0}, {0, 0, 0}})) == Ambiguity::attitudes);
    // a skew axis
    Identification skew(3, spec("quat"));
    std::vector<Row> turns;
    for (const double angle : {0.4, 1.1, -2.0}) {
        turns.push_back(converted({angle * 0.6, 0, angle * 0.8}, spec("rotvec"), Spec{}));
    }
    add(skew, rows_of(turns, spec("rotvec"), plain, spec("quat")));
    CHECK(skew.verdict().fitting == 1); // of the vectors along the axis none is another's multiple
    CHECK(skew.verdict().ambiguity == Ambiguity::nothing);
    const auto wide = of({{0, 0, 30}, {0, 0, 100}, {20, -40, -70}, {-60, 10, 5}});
    CHECK(identified(wide, 3) == "rpy:deg 123");
}

// Catches a table sorted by the last angle alone.
TEST_CASE("a candidate that fits but for one late row stands before those that never fit") {
    auto rows = rows_of(wide_attitudes(300), spec("euler:YXZ"), {0, 1, 2});
    rows[250][1] += 2.0;
    Identification identification(3, spec("dcm"));
    add(identification, rows);
    CHECK(identification.verdict().fitting == 0);
    const Candidate best = identification.best_first().front();
    CHECK(text_of(best) == "euler:YXZ 123");
    CHECK(best.rows == 251);
    CHECK(best.angle_row == 251);
    CHECK(best.angle == Approx(2.0));
}

// Catches a bad row that drives the right candidate out, and a row that is counted all the same.
TEST_CASE("rows that cannot be read are errors and count for nothing") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    auto rows = rows_of(wide_attitudes(10), spec("quat:xyzw"), {0, 1, 2, 3});
    rows[3][4] = 7;                       // no matrix
    rows[5][0] = nan;                     // no number
    std::fill_n(rows[6].begin(), 4, 0.0); // no quaternion
    rows[8][1] *= 2.0;                    // no unit quaternion
    for (const std::size_t at_once : {std::size_t{1}, std::size_t{3}, std::size_t{10}}) {
        Identification identification(4, spec("dcm"));
        const auto reports = add(identification, rows, at_once);
        REQUIRE(reports.size() == 4);
        const std::array expected{
            std::pair(std::size_t{3}, Error::defect), std::pair(std::size_t{5}, Error::not_finite),
            std::pair(std::size_t{6}, Error::zero_quaternion), std::pair(std::size_t{8}, Error::defect)};
        for (std::size_t i = 0; i < 4; ++i) {
            CHECK(reports[i].row == expected[i].first);
            CHECK(reports[i].error == expected[i].second);
        }
        CHECK(reports[3].defect > 1e-3);
        CHECK(identification.rows() == 6);
        CHECK(answer(identification) == "quat:xyzw 1234");
    }
}

// Catches a quaternion of any norm that fits.
TEST_CASE("a candidate that cannot read a row leaves with it") {
    const auto attitudes = wide_attitudes(4);
    auto rows = rows_of(attitudes, spec("axis-angle:deg"), {0, 1, 2, 3});
    Identification identification(4, spec("dcm"));
    CHECK(add(identification, rows).empty());
    CHECK(answer(identification) == "axis-angle:deg 1234");
    const auto best = identification.best_first();
    const auto quat =
        std::ranges::find_if(best, [](const Candidate& candidate) { return text_of(candidate) == "quat 1234"; });
    REQUIRE(quat != best.end());
    CHECK(quat->rows == 1);
    CHECK(std::isinf(quat->angle));
    CHECK(quat->angle_row == 1);
}

// Catches a candidate that leaves with its batch.
TEST_CASE("what comes of rows does not depend on how many come at once") {
    auto single = single_turns(300);
    single[500][0] = NAN;
    for (const auto& rows : {rows_of(wide_attitudes(300), spec("euler:XZX:deg"), {1, 0, 2}), single}) {
        Identification all(3, spec("dcm"));
        add(all, rows);
        for (const std::size_t at_once : {std::size_t{1}, std::size_t{2}, std::size_t{37}}) {
            Identification some(3, spec("dcm"));
            add(some, rows, at_once);
            const auto expected = all.best_first();
            const auto found = some.best_first();
            REQUIRE(found.size() == expected.size());
            for (std::size_t i = 0; i < found.size(); ++i) {
                if (text_of(found[i]) != text_of(expected[i]) || found[i].angle != expected[i].angle ||
                    found[i].rows != expected[i].rows || found[i].angle_row != expected[i].angle_row) {
                    FAIL(text_of(found[i]));
                }
            }
        }
    }
}

// Catches candidates that fit the first rows and are passed over later, or kept although a row rules them out: while
// all stands still all fit, one axis leaves those whose column it is, three leave the six orders and the vector.
TEST_CASE("candidates that rest are judged by the rows that tell them apart") {
    using Ambiguity = Verdict::Ambiguity;
    const auto verdict_of = [](const std::vector<Row>& rows) {
        Identification identification(3, spec("dcm"));
        add(identification, rows);
        return identification.verdict();
    };
    auto rows = single_turns(300); // still, yaw, roll, pitch
    CHECK(verdict_of({rows.begin(), rows.begin() + 300}).ambiguity == Ambiguity::attitudes);
    const Verdict yaw = verdict_of({rows.begin(), rows.begin() + 600});
    CHECK(yaw.fitting == 97); // see "narrow rows are ambiguous"
    CHECK(yaw.ambiguity == Ambiguity::axes);
    CHECK(verdict_of(rows).fitting == 7);
    const auto wide = rows_of(wide_attitudes(1), spec("euler:YZX"), {0, 1, 2});
    rows.insert(rows.begin() + 700, wide[0]);
    CHECK(verdict_of(rows).fitting == 0); // the roll is in the third column there
    rows = single_turns(300);
    rows.push_back(rows_of(wide_attitudes(1), spec("euler:YXZ"), {1, 0, 2})[0]);
    const Verdict one = verdict_of(rows);
    REQUIRE(one.answer);
    CHECK(text_of(*one.answer) == "euler:YXZ 213");
    CHECK(one.answer->rows == rows.size());
}

// Catches figures of the first rows alone, of a candidate that does not fit and is still one of the best.
TEST_CASE("the best candidates are held against all rows") {
    std::mt19937_64 random(20261126);
    std::normal_distribution<double> normal(0.0, 0.02);
    std::vector<Row> attitudes;
    for (int i = 0; i < 600; ++i) {
        attitudes.push_back(converted({normal(random), normal(random), normal(random)}, spec("rotvec"), Spec{}));
    }
    const auto rows = rows_of(attitudes, spec("rpy"), {0, 1, 2}, spec("quat"));
    Identification identification(3, spec("quat"));
    add(identification, rows);
    CHECK(answer(identification) == "rpy 123");
    const auto best = identification.best_first();
    for (std::size_t place = 0; place < 10; ++place) {
        INFO(text_of(best[place]));
        double greatest = 0.0;
        std::size_t line = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            Row numbers(3);
            for (std::size_t k = 0; k < 3; ++k) {
                numbers[k] = rows[i][best[place].columns.at(k)];
            }
            const Rotation own = *read_attitude(best[place].spec, numbers);
            const double angle = angle_between(own, *read_attitude(Spec{}, std::span(rows[i]).subspan(3)));
            line = angle > greatest ? i + 1 : line;
            greatest = std::max(greatest, angle);
        }
        CHECK(best[place].rows == rows.size());
        CHECK(best[place].angle == Approx(greatest).margin(1e-15));
        CHECK((place == 0 || best[place].angle_row == line));
        CHECK((place == 0 || best[place].angle >= best[place - 1].angle));
    }
}
