#include <catch.hpp>

#include "process.hpp"

using namespace program;

namespace {

/// Rows of numbers under a SPEC, then the matrix that they mean.
std::string with_matrix(const std::string& spec, const std::string& rows) {
    const auto made = run("-f " + spec + " -t dcm --append --diagnostics off", rows);
    CHECK(made.exit_code == 0);
    return made.out;
}

const std::string angles = "10 20 30\n-50 60 100\n120 -30 5\n";
const std::string quaternions = "0.1 0.3 -0.2 0.9\n0.8 0.2 0.3 -0.1\n-0.4 0.5 0.6 0.2\n";

const std::string nothing =
    "none: a turn on both sides that has no name is found by compare --align both, once the SPEC is known";

/// The answer, where all went well.
std::string answer(const std::string& arguments, const std::string& input) {
    const auto result = run("identify " + arguments, input);
    CHECK(result.err == "");
    CHECK(result.exit_code == (last_line(result.out).starts_with("-f ") ? 0 : 1));
    return last_line(result.out);
}

} // namespace

// Catches an answer that cannot be pasted, or that reads other attitudes.
TEST_CASE("identify ends with options that read the numbers") {
    const std::string rows = with_matrix("euler:zxz:deg:passive", angles);
    CHECK(answer("-t dcm", rows) == "-f euler:zxz:deg:passive --columns 1-3");
    const auto pasted = run(answer("-t dcm", rows) + " -t dcm --diagnostics off", rows);
    for (const auto& row : fields_of(pasted.out.substr(0, pasted.out.size() - 1), '\n')) { // both matrices
        const auto numbers = words_of(row);
        REQUIRE(numbers.size() == 18);
        for (std::size_t i = 0; i < 9; ++i) {
            CHECK(std::stod(numbers[i]) == Approx(std::stod(numbers[9 + i])).margin(1e-14));
        }
    }
    CHECK(answer("-t quat", run("-f rpy:deg -t quat --append", angles).out) == "-f rpy:deg --columns 1-3");
}

// Catches columns counted among those selected.
TEST_CASE("identify answers in the columns of the file") {
    const auto row = with_matrix("rpy:deg --columns 2-4", "7 10 20 30 x\n8 -50 60 100 y\n9 120 -30 5 z\n");
    CHECK(answer("-t dcm --columns 2-4,6-14", row) == "-f rpy:deg --columns 2-4");
    CHECK(answer("-t dcm --columns 4,2,3,6-14", row) == "-f euler:ZYX:deg --columns 4,3,2");
    // by name, and mislabelled
    const std::string table = "t;qw;qx;qy;qz;roll;pitch;yaw\n"
                              "0;0;0;0.6;0.8;0;0;73.739795291688042\n1;0.6;0;0;0.8;73.739795291688042;0;0\n"
                              "2;0.5;0.5;0.5;0.5;90;0;90\n";
    const auto named = answer("-t rpy:deg --columns qw,qx,qy,qz,roll,pitch,yaw", table);
    CHECK(named == "-f quat:xyzw --columns 2-5");
    CHECK(run(named + " -t rpy:deg -p 6 --diagnostics off", table) ==
          done("t;roll;pitch;yaw;roll;pitch;yaw\n0;0;0;73.7398;0;0;73.739795291688042\n"
               "1;73.7398;0;0;73.739795291688042;0;0\n2;90;0;90;90;0;90\n"));
}

// Catches a table without lines, and angles in another unit.
TEST_CASE("identify has a line for each of the best candidates") {
    std::string rows = with_matrix("rpy:deg", "10 20 30\n-50 60 100\n120 -30 5\n");
    rows = "# a remark\n\n" + rows;
    const auto result = run("identify -t dcm", rows);
    CHECK(missing(result.out, {"SPEC ", "columns", "worst angle", "at line", "rows", "fits", "\n3 rows; ",
                               "within 0.001 rad:\n"}) == "");
    const auto lines = fields_of(result.out, '\n');
    REQUIRE(lines.size() > 13);
    const auto best = words_of(lines.at(1));
    CHECK(best.front() == "rpy:deg");
    CHECK(best.at(1) == "1-3");
    CHECK(best.at(4) == "3");
    CHECK(best.at(5) == "yes");
    CHECK(words_of(lines.at(2)).back() == "no");
    CHECK(count_rows(result.out) == 14);
    // one row off by a tenth of a degree: (10, 20, 30.1) is known as (10, 20, 30)
    const std::string off = with_matrix("rpy:deg", "10 20 30\n") + "120 -30 5.1 " +
                            run("-f rpy:deg -t dcm", "120 -30 5\n").out +
                            with_matrix("rpy:deg", "-50 60 100\n12 -34 56\n-130 15 -75\n");
    const auto degrees = run("identify -t dcm -d --within 0.2", off);
    CHECK(last_line(degrees.out) == "-f rpy:deg --columns 1-3");
    const auto of_best = words_of(fields_of(degrees.out, '\n').at(1));
    CHECK(of_best.at(2) == "0.1");
    CHECK(of_best.at(3) == "2");
    CHECK(missing(degrees.out, {"within 0.2 deg:\n"}) == "");
    CHECK(answer("-t dcm -d --within 0.05", off) == nothing);
    CHECK(answer("-t dcm", off) == nothing);
    CHECK(answer("-t dcm --within 0.002rad", off) == "-f rpy:deg --columns 1-3");
}

// Catches one of many taken for the answer, and exit 0.
TEST_CASE("identify calls narrow rows ambiguous and says what they lack") {
    const auto of = [](const std::string& rows) { return answer("-t dcm", with_matrix("rpy:deg", rows)); };
    CHECK(of("0 0 30\n0 0 80\n") == "ambiguous: 97 fit; all turn about one axis, (0, 0, 1)");
    CHECK(of("0 0 30\n") == "ambiguous: 97 fit; there is one row");
    CHECK(of("0 0 30\n0 0 30\n") == "ambiguous: 97 fit; all rows have the same attitude");
    CHECK(missing(of("1 0.5 1\n0 0 3\n2 -1 0.5\n"), {"ambiguous: ", " fit; all are small, at most 0.0524 rad"}) == "");
    CHECK(missing(of("0 10 30\n0 -50 100\n0 20 -70\n"), {"ambiguous: ", "the number in column 1 is always 0"}) == "");
    const auto zero = with_matrix("rpy:deg --columns 2-4", "7 0 10 30\n7 0 -50 100\n");
    CHECK(missing(answer("-t dcm --columns 4,2,3,5-13", zero), {"the number in column 2 is always 0"}) == "");
    CHECK(answer("-t rpy:deg", "0 0 0.6 0.8 0 0 73.74\n0.5 0.5 0.5 0.5 90 0 90\n") == "-f quat:xyzw --columns 1-4");
    CHECK(answer("-t dcm", with_matrix("rpy:deg", "10 20 30\n")) == "-f rpy:deg --columns 1-3");
}

// Catches the least bad candidate taken for the answer.
TEST_CASE("identify says none where nothing fits") {
    const std::string rows = "1 2 3 1 0 0 0 1 0 0 0 1\n3 2 1 0 -1 0 1 0 0 0 0 1\n";
    const auto result = run("identify -t dcm", rows);
    CHECK(result.exit_code == 1);
    CHECK(result.err == "");
    CHECK(last_line(result.out) == nothing);
    for (const char* input : {"", "# comment\n", "\n"}) {
        CHECK(run("identify -t dcm", input) == went_on("none\n", {"there was no row with an attitude"}));
        CHECK(run("identify -t dcm --format json", input).out == R"({"rows": 0, "fit": 0, "answer": "none"})"
                                                                 "\n");
    }
}

// Catches a name that is ignored.
TEST_CASE("identify tries one representation alone where it is named") {
    const std::string rows = with_matrix("rpy:deg", "0 0 30\n0 0 80\n");
    CHECK(answer("-t dcm -f rotvec", rows) == "-f rotvec:deg --columns 1-3");
    CHECK(missing(answer("-t dcm -f euler", rows), {"ambiguous: 96 fit"}) == "");
    CHECK(answer("-t dcm -f mrp", rows) == nothing);
    CHECK(answer("-t dcm -f rpy", with_matrix("rpy:deg", angles)) == "-f rpy:deg --columns 1-3");
    CHECK(answer("-t dcm -f gibbs", with_matrix("cayley", angles)) == "-f cayley --columns 1-3");
}

// Catches a form that is left out.
TEST_CASE("identify takes one row as VALUEs, and a file") {
    CHECK(run("identify -t dcm 0 0 90 0 -1 0 1 0 0 0 0 1").exit_code == 1);
    CHECK(last_line(run("identify -t dcm 0 0 90 0 -1 0 1 0 0 0 0 1").out) == "ambiguous: 97 fit; there is one row");
    CHECK(last_line(run("identify -t rpy:deg 0.5,0.1,0.7,0.5,120,60,-10").out) ==
          "ambiguous: 24 fit; there is one row, and a turn takes two");
    CHECK(last_line(run(Words{"identify", "-t", "quat", "90 0 90 0.5 0.5 0.5 0.5"}).out).starts_with("ambiguous"));
    Folder folder;
    const auto path = (folder / "rows").string();
    write_file(path, with_matrix("rpy:deg", angles));
    CHECK(last_line(run("identify -t dcm " + path).out) == "-f rpy:deg --columns 1-3");
    CHECK(last_line(run("identify -t dcm -i " + path).out) == "-f rpy:deg --columns 1-3");
    const auto table = (folder / "table").string();
    CHECK(run("identify -t dcm -o " + table + " " + path) == done(""));
    CHECK(last_line(read_file(table)) == "-f rpy:deg --columns 1-3");
}

// Catches a count of numbers that is taken from bytes.
TEST_CASE("identify reads doubles") {
    const auto bytes =
        run("-f quat -t rpy:deg --append --format f64 --diagnostics off --tolerance inf --input-format f64",
            run("-f quat -t quat --tolerance inf --diagnostics off --format f64", quaternions).out);
    CHECK(bytes.exit_code == 0);
    CHECK(bytes.out.size() == 3 * 7 * sizeof(double));
    CHECK(answer("-t rpy:deg --input-format f64 --width 7", bytes.out) == "-f quat --columns 1-4");
    CHECK(answer("-t rpy:deg -f quat --input-format f64", bytes.out) == "-f quat --columns 1-4");
    CHECK(answer("-t quat --columns 5-7,1-4 --width 7 --input-format f64", bytes.out) == "-f rpy:deg --columns 5-7");
    CHECK(run("identify -t rpy:deg --input-format f64", bytes.out) == stopped(any_output, {"f64", "--width"}));
}

// Catches numbers that no JSON reader takes, and a last line that is none.
TEST_CASE("identify speaks JSON") {
    const auto result = run("identify -t dcm --format json", "0 0 90 0 -1 0 1 0 0 0 0 1\n");
    CHECK(result.exit_code == 1);
    CHECK(count_rows(result.out) == 11);
    CHECK(missing(result.out, {R"({"spec": "rotvec:deg", "columns": "1-3", "angle": 0, "angle_line": 1, "rows": 1, )"
                               R"("fits": true})"}) == "");
    CHECK(last_line(result.out) == R"({"rows": 1, "fit": 97, "answer": "ambiguous", "lack": "there is one row"})");
    const auto one = run("identify -t dcm --format json", with_matrix("euler:ZYX:deg", angles));
    CHECK(one.exit_code == 0);
    CHECK(last_line(one.out) == R"({"rows": 3, "fit": 1, "answer": "-f euler:ZYX:deg --columns 1-3"})");
    // a quaternion of the norm 5 is none
    CHECK(run("identify -t quat -f quat --format json", "0.1 0.2 0.3 0.4 1 0 0 0\n") ==
          stopped(any_output, {"rotconv: -:1: defect 0.45", "0.1 0.2 0.3 0.4 1 0 0 0"}));
    const auto axis = run("identify -t quat --format json", "0 0 2 180 0 0 0 1\n");
    CHECK(missing(axis.out, {R"({"spec": "axis-angle:deg", "columns": "1-4", "angle": )"}) == "");
}

// Catches an input of its own, and a bad row that drives the right convention out.
TEST_CASE("identify takes bad rows, headers and comments as a conversion does") {
    auto lines = fields_of(with_matrix("rpy:deg", angles), '\n');
    const std::string bad = "# made\nroll pitch yaw a b c d e f g h i\n" + lines[0] + "\n1 2 x 1 0 0 0 1 0 0 0 1\n" +
                            lines[1] + "\n1 2 3 9 0 0 0 1 0 0 0 1\n1 nan 3 1 0 0 0 1 0 0 0 1\n1 2 3\n" + lines[2] +
                            "\n";
    const auto stopped = run("identify -t dcm", bad);
    CHECK(stopped.exit_code == 2);
    CHECK(stopped.out == "");
    CHECK(stopped.err == "rotconv: -:4: not a number: 'x'\n");
    for (const std::string policy : {"skip", "nan"}) {
        const auto skipped = run("identify -t dcm --on-error " + policy, bad);
        CHECK(skipped.exit_code == 1);
        CHECK(last_line(skipped.out) == "-f rpy:deg --columns 1-3");
        CHECK(missing(skipped.out, {"\n3 rows; "}) == "");
        CHECK(missing(skipped.err, {"-:4: not a number: 'x'\n", "-:6: defect", "-:7: not finite", "1 nan 3 1 0",
                                    "-:8: 3 fields where 3 unknown numbers with dcm has 12: '1 2 3'\n"}) == "");
    }
    CHECK(answer("-t dcm", "\xEF\xBB\xBF" + with_matrix("rpy:deg", angles)) == "-f rpy:deg --columns 1-3");
    CHECK(missing(run("identify -t dcm", "{\"q\": 1}\n").err, {"looks like JSON"}) == "");
    CHECK(missing(answer("-t dcm --delimiter comma", "0,0,30,1,0,0,0,1,0,0,0,1\n"),
                  {"ambiguous: ", " fit; there is one row"}) == ""); // any turn fits one row
}

// Catches rows that are paired wrongly, a key that is taken for a number, and columns that are counted from it.
TEST_CASE("the known attitudes of identify may stand in another file") {
    Folder folder;
    const auto file = [&](const char* name, const std::string& text) {
        write_file(folder / name, text);
        return (folder / name).string();
    };
    const auto unknown = file("unknown", "t,x,who,y,z\n1,10,a,20,30\n2,-100,b,50,70\n3,80,c,-30,-150\n");
    std::string known;
    for (const std::string row : {"10 20 30", "-100 50 70", "80 -30 -150"}) {
        known += run("-f euler:ZYX:deg -t quat -- " + row).out;
    }
    const auto reference = file("reference", "# remark\n" + known);
    const auto answer = [](const Result& result) { return last_line(result.out); };
    CHECK(answer(run({"identify", "-t", "quat", "--columns", "x,y,z", "--reference-columns", "1-4", unknown,
                      reference})) == "-f euler:ZYX:deg --columns 2,4,5");
    const auto plain = file("plain", "10 20 30\n-100 50 70\n80 -30 -150\n");
    CHECK(answer(run({"identify", "-t", "quat", plain, reference})) == "-f euler:ZYX:deg --columns 1-3");
    CHECK(answer(run({"identify", "-t", "quat", plain, "-"}, known)) == "-f euler:ZYX:deg --columns 1-3");

    std::string keyed = "0.5 1 0 0 0\n";
    for (std::size_t i = 0, at = 0; at < known.size(); ++i) {
        const auto end = known.find('\n', at);
        keyed += std::to_string(i + 1) + ".0 " + known.substr(at, end - at) + "\n";
        at = end + 1;
    }
    const auto with_keys = file("keys", keyed);
    const auto result = run({"identify", "-t", "quat", "--key", "t", "--columns", "x,y,z", "--reference-key", "1",
                             "--reference-columns", "2-5", unknown, with_keys});
    CHECK(answer(result) == "-f euler:ZYX:deg --columns 2,4,5");
    CHECK(result.exit_code == 0);
    CHECK(missing(result.err, {"keys: unpaired: 1 row, first at line 1"}) == "");

    CHECK(run({"identify", "-t", "quat", plain, file("bad", "1 0 0 0\n0 0 0 0\n")}) ==
          stopped(any_output, {"bad:2: a zero quaternion has no attitude: '0 0 0 0'"}));
    CHECK(missing(run({"identify", "-t", "quat", file("two", "1 2\n"), reference}).err,
                  {"two:1: 2 numbers: 2 unknown (legal: 3 4 5 6 9): '1 2'"}) == "");
}
