#include <cmath>
#include <optional>
#include <random>

#include <catch.hpp>
#include <fmt/format.h>

#include "process.hpp"

using namespace program;

namespace {

/// Files of a folder and the program, run on them.
class Files {
public:
    Files& add(const std::string& name, const std::string& text) {
        write_file(folder_ / name, text);
        return *this;
    }
    /// Names of files stand as @NAME.
    [[nodiscard]] Result operator()(const std::string& arguments, const std::string& input = {}) const {
        Words words = words_of(arguments);
        for (auto& word : words) {
            if (word.starts_with('@')) {
                word = path(word.substr(1));
            }
        }
        Result result = run(words, input);
        for (const char* name : {"new", "old"}) { // as the messages have them
            const std::string where = path(name);
            for (auto at = result.err.find(where); at != std::string::npos; at = result.err.find(where)) {
                result.err.replace(at, where.size(), name);
            }
        }
        return result;
    }
    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

private:
    Folder folder_;
};

Result failing(int code, const std::string& out, const std::string& err) {
    return {.exit_code = code, .out = out, .err = err};
}

const std::string summary_of_two_rows = "rows      2\nbeyond    0\nunpaired  0\nfailed    0\nmax       0.25 at 2\n"
                                        "rms       0.1767766952966369\nmean      0.125\n";

} // namespace

TEST_CASE("compare tells how far two files are apart") {
    // Catches lines that are missing or in another order, a maximum without its line, an angle of the wrong unit.
    Files files;
    files.add("new", "0 0 0\n0 0 0.25\n").add("old", "0 0 0\n0 0 0\n");
    CHECK(files("compare -f rotvec --within 0.25 @new @old") == done(summary_of_two_rows));
    CHECK(files("compare -f rotvec @new @old").out.find("beyond") == std::string::npos);
    CHECK(files("compare -f rotvec --within 0.3 --format json @new @old") ==
          done(R"({"rows": 2, "within": 0.3, "beyond": 0, "first_beyond": null, "unpaired": 0, "failed": 0, )"
               R"("max": 0.25, "max_line": 2, "rms": 0.1767766952966369, "mean": 0.125})"
               "\n"));
    CHECK(files("compare -f rotvec --format json -p 3 @new @old").out.find(R"("rms": 0.177,)") != std::string::npos);
    CHECK(files("compare -f rotvec --format csv @new @old") == done("0 0 0 0\n0 0 0.25 0.25\n"));
    files.add("new", "0 0 10\n0 0 25\n").add("old", "0 0 10\n0 0 0\n");
    const auto degrees = files("compare -f rotvec -d --within 25.0001 -p 6 --format json @new @old");
    CHECK(degrees.exit_code == 0);
    CHECK(missing(degrees.out, {R"("within": 25.0001)", R"("max": 25,)", R"("beyond": 0)"}) == "");
}

TEST_CASE("compare ends as diff does") {
    // Catches a check that passes whatever it finds.
    Files files;
    files.add("new", "0 0 0\n0 0 0.25\n0 0 0.5\n").add("old", "0 0 0\n0 0 0\n0 0 0\n");
    const auto beyond = files("compare -f rotvec --within 0.25 @new @old");
    CHECK(beyond.exit_code == 1);
    CHECK(beyond.err == "rotconv: new: beyond: 1 row, first at line 3; the attitudes differ by more than --within\n");
    CHECK(missing(beyond.out, {"beyond    1\n", "max       0.5 at 3\n"}) == "");
    CHECK(files("compare -f rotvec --within 0.25 --format csv --diagnostics rows @new @old") ==
          failing(1, "0 0 0 0\n0 0 0.25 0.25\n0 0 0.5 0.5\n",
                  "rotconv: new:3: beyond: angle 0.5; the attitudes differ by more than --within\n"));
    CHECK(missing(files("compare -f rotvec --within 0.1 --format json @new @old").out,
                  {R"("beyond": 2, "first_beyond": 2)"}) == "");
    CHECK(files("compare -f rotvec --within 0.6 @new @old").exit_code == 0);
    CHECK(files("compare -f rotvec --within 0.5 --diagnostics columns --format csv @new @old").out ==
          "0 0 0 0 inf 1 0 -\n0 0 0.25 0.25 inf 1 0 -\n0 0 0.5 0.5 inf 1 0 -\n");

    files.add("old", "0 0 0\n0 0 0\n");
    const auto longer = files("compare -f rotvec @new @old");
    CHECK(longer.exit_code == 1);
    CHECK(longer.err == "rotconv: new: unpaired: 1 row, first at line 3\n");
    CHECK(missing(longer.out, {"rows      2\n", "unpaired  1\n"}) == "");
    CHECK(files("compare -f rotvec @old @new").err == "rotconv: new: unpaired: 1 row, first at line 3\n");

    files.add("none", "# nothing\n\n");
    const auto none = files("compare -f rotvec @none @none");
    CHECK(none ==
          failing(1, "rows      0\nunpaired  0\nfailed    0\n", "rotconv: there was no row with an attitude\n"));
    CHECK(files("compare -f rotvec --format json @none @none").out ==
          R"({"rows": 0, "within": null, "beyond": null, "first_beyond": null, "unpaired": 0, "failed": 0, )"
          R"("max": null, "max_line": null, "rms": null, "mean": null})"
          "\n");
    CHECK(files("compare -f rotvec @new @missing").exit_code == 2);
    CHECK(files("compare -f rotvec @new @new").exit_code == 0); // one file twice
}

TEST_CASE("compare pairs rows of the same number, whatever stands between them") {
    // Catches comments or headers that are counted, the other file's delimiter or columns, a wrong line.
    Files files;
    files.add("new", "\n# made today\nt,qw,qx,qy,qz\n1,1,0,0,0\n# pause\n2,0,1,0,0\n");
    files.add("old", "r11;r12;r13;r21;r22;r23;r31;r32;r33;who\n1;0;0;0;1;0;0;0;1;me\n\n1;0;0;0;-1;0;0;0;-1;you\n");
    const std::string options = "compare -f quat --columns qw,qx,qy,qz -t dcm --reference-columns 1-9 ";
    CHECK(files(options + "--within 0 @new @old").exit_code == 0);
    CHECK(files(options + "--format csv @new @old") ==
          done("\n# made today\nt,qw,qx,qy,qz,angle\n1,1,0,0,0,0\n# pause\n2,0,1,0,0,0\n"));
    CHECK(files(options + "--format csv --as rotvec --diagnostics columns @new @old").out ==
          "\n# made today\nt,qw,qx,qy,qz,angle,rx,ry,rz,margin,condition,defect,notes\n"
          "1,1,0,0,0,0,0,0,0,3.141592653589793,1,0,\n# pause\n2,0,1,0,0,0,0,0,0,3.141592653589793,1,0,\n");
    CHECK(missing(files("compare -f dcm -t quat --columns 1-9 --reference-columns 2-5 --format json @old @new").out,
                  {R"("rows": 2)", R"("max": 0)"}) == "");
    const auto other = files("compare -f quat --columns qw,qx,qy,qz @new @old");
    CHECK(other.exit_code == 2);
    CHECK(missing(other.err, {"old:1: not a header: the row lacks the selected columns 'qw', 'qx', 'qy', 'qz'"}) == "");
}

TEST_CASE("a row that fails keeps its place, and is told of the right file") {
    // Catches rows that shift, and messages about the wrong file or line.
    Files files;
    files.add("new", "0 0 1\n0 x 1\n0 0 1\n0 0 1\n").add("old", "0 0 1\n0 0 1\n# hm\n0 0 nan\n0 0 2\n");
    const std::string of_new = "rotconv: new:2: not a number: 'x'\n";
    const std::string of_old = "rotconv: old:4: not finite: '0 0 nan'\n";
    CHECK(files("compare -f rotvec --format csv @new @old") == failing(2, "0 0 1 0\n", of_new));
    CHECK(files("compare -f rotvec --format csv @old @new").err == "rotconv: new:2: not a number: 'x'\n");
    CHECK(files("compare -f rotvec --format csv --on-error nan @new @old") ==
          failing(1, "0 0 1 0\n0 x 1 nan\n0 0 1 nan\n0 0 1 1\n", of_new + of_old));
    CHECK(files("compare -f rotvec --format csv --on-error skip @new @old") ==
          failing(1, "0 0 1 0\n0 0 1 1\n", of_new + of_old));
    const auto summary = files("compare -f rotvec --on-error nan @new @old");
    CHECK(summary.exit_code == 1);
    CHECK(missing(summary.out, {"rows      2\n", "failed    2\n", "max       1 at 4\n"}) == "");
    CHECK(files("compare -f rotvec @new @old") == failing(2, "", of_new));
    files.add("new", "1 0 0 0\n1 0 0 0\n").add("old", "1 0 0 0\n2 0 0 0\n");
    CHECK(files("compare -f quat @new @old").err ==
          "rotconv: old:2: defect 1 is above the tolerance 0.001 (--tolerance), its norm is 2: '2 0 0 0'\n");
    CHECK(files("compare -f quat --tolerance inf @new @old").exit_code == 0);
    files.add("old", "1 0 0 0\n1 0 0\n");
    CHECK(files("compare -f quat @new @old").err == "rotconv: old:2: 3 fields where quat has 4: '1 0 0'\n");
}

TEST_CASE("one stream or a row of arguments may hold both attitudes") {
    // Catches numbers that are split in the wrong place.
    CHECK(run("compare -f quat -t rotvec --format csv", "1 0 0 0 0 0 0.25\n0 1 0 0 0 0 0\n") ==
          done("1 0 0 0 0 0 0.25 0.25\n0 1 0 0 0 0 0 3.141592653589793\n"));
    CHECK(missing(run("compare -f quat 1 0 0 0 -1 0 0 0").out, {"rows      1\n", "max       0 at 1\n"}) == "");
    CHECK(run("compare -f rotvec --columns 2-4,6-8 --format csv", "a,0,0,0.5,b,0,0,0,c\n") ==
          done("a,0,0,0.5,b,0,0,0,c,0.5\n"));
    CHECK(run("compare -f rotvec -t quat 0 0 1 1 0 0").err ==
          "rotconv: argument: 6 fields where rotvec with quat has 7: '0 0 1 1 0 0'\n");
    CHECK(run("compare -f quat -t dcm -- 1 0 0 0 1 0 0 0 1 0 0 0 -1").err ==
          "rotconv: argument: no rotation is nearest to a matrix with det <= 0: '1 0 0 0 1 0 0 0 1 0 0 0 -1'\n");
}

TEST_CASE("rows are paired by keys of any length") {
    // Catches keys that are read as doubles, and rows of one file that are lost in silence.
    Files files;
    files.add("new", "1403636579763555584,0,0,1\n1403636579763555585,0,0,0.5\n1403636579763555590,0,0,3\n");
    files.add("old", "1403636579763555583,0,0,9\n1403636579763555585,0,0,0\n1403636579763555590.0,0,0,3\n");
    const auto result = files("compare -f rotvec --key 1 --columns 2-4 --format csv @new @old");
    CHECK(result.exit_code == 1);
    CHECK(result.out == "1403636579763555585,0,0,0.5,0.5\n1403636579763555590,0,0,3,0\n");
    CHECK(result.err ==
          "rotconv: new: unpaired: 1 row, first at line 1\nrotconv: old: unpaired: 1 row, first at line 1\n");
    CHECK(missing(files("compare -f rotvec --key 1 --columns 2-4 --key-within 1 @new @old").out,
                  {"rows      3\n", "unpaired  0\n"}) == "");
    files.add("named", "q;stamp;w\n0;1403636579763555585;2.5\n");
    CHECK(missing(files("compare -f rotvec --key 1 --columns 2-4 --reference-key stamp --reference-columns q,1,w @new "
                        "@named")
                      .err,
                  {"column '1' is selected twice"}) == "");
}

TEST_CASE("keys that do not increase, or are none, are errors of their row") {
    // Catches a file out of order that is compared with whatever comes by.
    Files files;
    files.add("new", "1 0 0 1\n3 0 0 1\n3 0 0 1\n2 0 0 1\nx 0 0 1\n4 0 0 1\n");
    files.add("old", "1 0 0 1\n3 0 0 1\n4 0 0 1\n");
    const std::string options = "compare -f rotvec --key 1 --columns 2-4 --format csv ";
    const std::string errors = "rotconv: new:3: the key does not increase: '3'\n"
                               "rotconv: new:4: the key does not increase: '2'\n"
                               "rotconv: new:5: not a number: 'x'\n";
    CHECK(files(options + "@new @old") ==
          failing(2, "1 0 0 1 0\n3 0 0 1 0\n", errors.substr(0, errors.find('\n') + 1)));
    CHECK(files(options + "--on-error skip @new @old") == failing(1, "1 0 0 1 0\n3 0 0 1 0\n4 0 0 1 0\n", errors));
    CHECK(files(options + "--on-error nan @new @old") ==
          failing(1, "1 0 0 1 0\n3 0 0 1 0\n3 0 0 1 nan\n2 0 0 1 nan\nx 0 0 1 nan\n4 0 0 1 0\n", errors));
    CHECK(files(options + "--on-error nan @old @new") == failing(1, "1 0 0 1 0\n3 0 0 1 0\n4 0 0 1 0\n", errors));
    CHECK(files("compare -f rotvec --key 1 @new @old").exit_code == 2);
    CHECK(missing(files("compare -f rotvec --key 1 @new @old").err, {"--key needs --columns"}) == "");
    CHECK(files("compare -f rotvec --key 1,2 --columns 2-4 @new @old").exit_code == 2);
    CHECK(files("compare -f rotvec --key 9 --columns 2-4 @new @old").err ==
          "rotconv: new:1: no column 9, the row has 4: '1 0 0 1'\n");
}

TEST_CASE("each row is paired with the nearest whose nearest it is") {
    // Catches a greedy match, and ties that are decided by chance. The pairs are found anew by looking at all.
    std::mt19937 engine(7);
    Files files;
    for (int round = 0; round < 60; ++round) {
        const int within = std::uniform_int_distribution(0, 6)(engine);
        std::vector<std::vector<int>> keys(2);
        for (std::size_t side = 0; side < 2; ++side) {
            std::string text;
            for (int key = 0, i = 0; i < 40; ++i) {
                key += std::uniform_int_distribution(1, round % 9 + 1)(engine);
                keys[side].push_back(key);
                text += fmt::format("{}.{} 0 0 {}\n{}", key / 10, key % 10, side == 0 ? 0.0 : 1e-3 * i,
                                    i % 7 == round % 7 ? "# remark\n" : "");
            }
            files.add(side == 0 ? "new" : "old", text);
        }
        const auto nearest = [&](std::size_t side, std::size_t row) {
            const auto& others = keys[1 - side];
            std::size_t best = 0;
            for (std::size_t i = 1; i < others.size(); ++i) {
                const auto apart = [&](std::size_t at) { return std::abs(others[at] - keys[side][row]); };
                best = apart(i) < apart(best) ? i : best;
            }
            return best;
        };
        std::string expected;
        for (std::size_t i = 0; i < keys[0].size(); ++i) {
            const std::size_t other = nearest(0, i);
            if (std::abs(keys[0][i] - keys[1][other]) <= within && nearest(1, other) == i) {
                expected += fmt::format("{}:{} ", i, other);
            }
        }
        const auto result = files(
            fmt::format("compare -f rotvec --key 1 --columns 2-4 --key-within 0.{} --format csv @new @old", within));
        std::string pairs;
        for (const auto& line : fields_of(result.out, '\n')) {
            if (!line.empty() && !line.starts_with('#')) {
                const auto words = words_of(line);
                const int key = static_cast<int>(std::lround(std::stod(words.front()) * 10));
                pairs += fmt::format("{}:{} ", std::ranges::find(keys[0], key) - keys[0].begin(),
                                     std::lround(std::stod(words.back()) * 1000));
            }
        }
        CHECK(pairs == expected);
    }
}

TEST_CASE("compare gives the same bytes with any number of threads, and needs no memory for its length") {
    // Catches sums in another order, pairs that shift where blocks end, and a file that is held.
    Files files;
    std::string rows;
    std::string others;
    for (int i = 0; i < 60'000; ++i) {
        rows += fmt::format("{} {} {} {}\n", i, std::sin(i), std::cos(3 * i), 0.1 * std::sin(7 * i));
        others += fmt::format("{}, {}, {}, {}, more text to make blocks of other lengths\n", i + 0.25, std::sin(i),
                              std::cos(3 * i), 0.1 * std::sin(7 * i + 1e-3 * std::sin(11 * i)));
        if (i % 1000 == 0) {
            rows += "# remark\n";
        }
    }
    files.add("new", rows).add("old", others);
    for (const std::string options : {"--columns 2-4 --format csv", "--columns 2-4 --format json",
                                      "--columns 2-4 --key 1 --key-within 0.3 --format csv --as quat"}) {
        const auto one = files("compare -f rotvec --threads 1 " + options + " @new @old");
        CHECK(one.exit_code == 0);
        CHECK(one.out.size() > 100);
        for (const char* threads : {"2", "5"}) {
            CHECK(files("compare -f rotvec " + options + " @new @old --threads " + threads) == one);
        }
    }
}

TEST_CASE("the memory of compare does not grow with the streams") {
    // Catches rows that are held: by row, by keys that are equal, and by keys whose next one must be seen.
    Files files;
    for (const std::string options : {"", "--key 1 ", "--key 1 --key-within 0.5 "}) {
        std::vector<long> peaks;
        for (const int count : {20'000, 200'000}) {
            std::string rows;
            std::string others;
            for (int i = 0; i < count; ++i) {
                rows += std::to_string(i) + " 0.5 -0.5 0.5 0.5\n";
                others += std::to_string(i) + (options.find("within") == std::string::npos ? "" : ".1") +
                          " 0.5 -0.5 0.5 0.5\n";
            }
            files.add("old", others);
            Process process(
                words_of("compare -f quat --threads 1 --columns 2-5 " + options + "- " + files.path("old")));
            process.write(rows);
            process.wait_until_read();
            peaks.push_back(process.peak_memory_kib());
            const auto result = process.finish();
            CHECK(result.exit_code == 0);
            CHECK(missing(result.out, {"rows      " + std::to_string(count) + "\n"}) == "");
        }
        INFO(options);
        CHECK((is_sanitized || peaks[1] <= peaks[0] + 512));
    }
    // long stretches without a partner, in the stream and in the reference
    std::string sparse;
    for (int i = 0; i < 200'000; i += 20'000) {
        sparse += std::to_string(i) + " 0.5 -0.5 0.5 0.5\n";
    }
    std::string dense;
    for (int i = 0; i < 200'000; ++i) {
        dense += std::to_string(i) + " 0.5 -0.5 0.5 0.5\n";
    }
    for (const bool first : {true, false}) {
        files.add("old", first ? sparse : dense);
        Process process(words_of("compare -f quat --key 1 --columns 2-5 --threads 1 - " + files.path("old")));
        process.write(first ? dense : sparse);
        const auto peak = [&] {
            process.wait_until_read();
            return process.peak_memory_kib();
        }();
        CHECK(missing(process.finish().out, {"rows      10\n"}) == "");
        CHECK((is_sanitized || peak < 9'000)); // of 5 MB of rows
    }
}

TEST_CASE("a row whose partner cannot be told ends the comparison") {
    // Catches a wrong pair, and memory that grows with what stands between two keys.
    Files files;
    const std::string options = "compare -f quat --key 1 --columns 2-5 --key-within 0.5 --format csv @new @old";
    files.add("old", "1.1 1 0 0 0\n");
    files.add("new", "1 1 0 0 0\n" + repeated("# remark\n", 4'000) + "1.1 1 0 0 0\n");
    CHECK(files(options) == failing(1, repeated("# remark\n", 4'000) + "1.1 1 0 0 0 0\n",
                                    "rotconv: new: unpaired: 1 row, first at line 1\n"));
    files.add("new", "1 1 0 0 0\n" + repeated("# remark\n", 200'000) + "1.1 1 0 0 0\n");
    CHECK(files(options) == failing(2, "",
                                    "rotconv: new:1: the row cannot be paired: too many comments and failed rows stand "
                                    "before the next key\n"));
}

TEST_CASE("a pair that has arrived is answered") {
    // Catches a comparison that waits for full blocks.
    Files files;
    files.add("old", "0 0 0\n0 0 0\n0 0 0\n");
    Process process(Words{"compare", "-f", "rotvec", "--format", "csv", "-", files.path("old")});
    process.write("0 0 0\n");
    CHECK(process.read_rows(1) == "0 0 0 0\n");
    process.write("0 0 0.5\n0 0");
    CHECK(process.read_rows(1) == "0 0 0.5 0.5\n");
    process.write(" 0\n");
    CHECK(process.read_rows(1) == "0 0 0 0\n");
    CHECK(process.finish().exit_code == 0);
}

TEST_CASE("rows of doubles are compared too") {
    // Catches fields that get into the sums.
    Files files;
    const auto bytes = [](std::initializer_list<double> numbers) {
        return std::string(reinterpret_cast<const char*>(std::data(numbers)), numbers.size() * sizeof(double));
    };
    files.add("new", bytes({7, 0, 0, 0, 8, 0, 0, 0.25})).add("old", bytes({7, 0, 0, 0, 8, 0, 0, 0}));
    const std::string options = "compare -f rotvec --input-format f64 --width 4 --columns 2-4 --within 0.25 ";
    CHECK(files(options + "@new @old") == done(summary_of_two_rows));
    CHECK(files(options + "--key 1 @new @old") == done(summary_of_two_rows));
    CHECK(files(options + "--format csv @new @old") == done("7,0,0,0,0\n8,0,0,0.25,0.25\n"));
    files.add("old", bytes({7, 0, 0, 0, 8, 0, 0}));
    CHECK(missing(files(options + "@new @old").err, {"old:2: the row that begins at byte 32 is not whole"}) == "");
    CHECK(files(options + "@new @old").exit_code == 2);
}

TEST_CASE("what cannot be compared is refused") {
    // Catches options that are taken in silence.
    Files files;
    files.add("new", "0 0 1\n").add("old", "0 0 1\n");
    CHECK(missing(run("compare -f rotvec - -").err, {"both FILE and REFERENCE are stdin"}) == "");
    CHECK(missing(files("compare -f rotvec @new @old @new").err, {"is one FILE too many"}) == "");
    CHECK(missing(files("compare -f rotvec -o " + files.path("old") + " @new @old").err,
                  {"the same file is input and output"}) == "");
    CHECK(missing(files("compare -f rotvec --format f64 @new @old").err, {"'f64' is not a known format of compare"}) ==
          "");
    CHECK(missing(files("compare -f rotvec --key-within x @new @old").err, {"--key-within 'x' must be"}) == "");
    CHECK(missing(files("compare @new @old").err, {"--from SPEC is missing"}) == "");
    CHECK(missing(files("compare -f quat --columns 1-3 @new @old").err, {"selects 3 columns where quat has 4"}) == "");
    CHECK(missing(files("-f rotvec -t quat @new @old").err, {"are two FILEs, but one is read"}) == "");
    const auto directory = files("compare -f rotvec @new /");
    CHECK(directory.exit_code == 2);
}

TEST_CASE("a reader that closes the pipe ends a comparison and an identification quietly") {
    // Catches an unfinished check that is called a failed one.
    Files files;
    files.add("old", repeated("0.5 -0.5 0.5 0.5\n", 1000));
    for (const std::string& arguments : {"compare -f quat --format csv - " + files.path("old"),
                                         "compare -f quat - " + files.path("old"), std::string("identify -t quat")}) {
        Process process(words_of(arguments));
        process.close_output(); // before there is anything to write
        process.write(repeated(arguments.starts_with("c") ? "0.5 -0.5 0.5 0.5\n" : "0 0 1 1 0 0 0\n", 1000));
        const auto result = process.finish();
        INFO(arguments);
        CHECK(result.exit_code == 0);
        CHECK(result.err == "");
    }
}

TEST_CASE("a diagnostic of the reference is told of it") {
    // Catches a defect that is looked for in the wrong file.
    Files files;
    files.add("new", "1 0 0 0\n1.0001 0 0 0\n1 0 0 0\n").add("old", "# 1\n1 0 0 0\n1 0 0 0\n1.0002 0 0 0\n");
    const auto rows = files("compare -f quat --diagnostics rows @new @old").err;
    CHECK(count_rows(rows) == 2);
    CHECK(missing(rows, {"new:2: normalized: defect 0.0001;", "old:4: normalized: defect 0.0002;"}) == "");
    CHECK(missing(files("compare -f quat @new @old").err,
                  {"new: normalized: 1 row, first at line 2", "old: normalized: 1 row, first at line 4"}) == "");
    CHECK(missing(files("compare -f quat --format csv --diagnostics columns -p 2 @new @old").out,
                  {"inf 1 0 -\n", "inf 1 0.0001 normalized\n", "inf 1 0.0002 normalized\n"}) == "");
}

TEST_CASE("errors of the reference's options name them") {
    // Catches a message about a text that nobody typed.
    Files files;
    files.add("new", "1 1 0 0 0\n").add("old", "1 1 0 0 0\n");
    const auto error = [&](const std::string& options) {
        return files("compare -f quat " + options + " @new @old").err;
    };
    CHECK(error("--columns 2-5 --reference-key 1") == "");
    CHECK(missing(error("--columns 2-5 --reference-columns 1,2"), {"--reference-columns: '1,2' selects 2"}) == "");
    CHECK(missing(error("--columns 2-5 --reference-columns qx,qy,qz,qw"), {"--reference-columns 'qx,qy,qz,qw' is"}) ==
          "");
    CHECK(missing(error("--key 1 --columns 2-4"), {"--columns: '2-4' selects 3 columns where quat has 4 numbers"}) ==
          "");
    CHECK(missing(error("--columns 2-5 -t rotvec"), {"--columns (of REFERENCE too): '2-5' selects 4"}) == "");
    CHECK(run("compare -f quat --columns 1-4 --reference-columns 5-8 --format csv 1 0 0 0 -1 0 0 0").out ==
          "1 0 0 0 -1 0 0 0 0\n");
    CHECK(error("--columns 2-5 --as nonsense").find("--as 'nonsense'") != std::string::npos);
}

TEST_CASE("an angle of a relative attitude that rounds to -180 is 180") {
    // Catches a range that is looked for in the column of another number.
    const auto result = run("compare -f rpy:deg -d --as rpy --format csv --decimals 1", "-179.999 0 0 0 0 0\n");
    CHECK(result.out == "-179.999 0 0 0 0 0 180.0 180.0 0.0 0.0\n");
}
