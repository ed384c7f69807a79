#include <catch.hpp>

#include "process.hpp"

using namespace program;

// Catches lines that are lost where they wait for the row that tells, and those that pile up.
TEST_CASE("comments and blank rows before the first row keep their order and use no memory") {
    const std::string many = repeated("# " + std::string(100, 'c') + "\n\n", 20'000);
    CHECK((run(reorder, many + "#a,b,c,d\n1,0,0,0\n") == done(many + "#qx,qy,qz,qw\n0,0,0,1\n")));
    CHECK((run(reorder, many).out == many));
    CHECK((run(reorder + "--columns qw,qx,qy,qz", many + "#qw,qx,qy,qz\n# note\n\n1,0,0,0\n") ==
           done(many + "#qx,qy,qz,qw\n# note\n\n0,0,0,1\n")));
    const std::string wide = "# " + std::string(4'000'000, 'c') + "\n";
    CHECK((run(reorder, wide + wide + "1,0,0,0\n") == done(wide + wide + "0,0,0,1\n")));
    for (const std::string list : {"1-4", "qw,qx,qy,qz"}) { // what waits has an end
        Process process(words_of(reorder + "--columns " + list));
        process.write("#qw,qx,qy,qz\n");
        for (int i = 0; i < 300; ++i) {
            process.write(std::string(100'000, '\n'));
        }
        process.wait_until_read();
        if (!is_sanitized) {
            CHECK(process.peak_memory_kib() < 20'000);
        }
        process.write("1,0,0,0\n");
        const auto result = process.finish();
        CHECK(result.exit_code == 0);
        CHECK(result.out.size() == 13 + 30'000'000 + 8);
    }
    // a line that is too long loses none of those before it
    CHECK(run(reorder, "# note\n" + std::string(5'000'000, '1')) == stopped("# note\n"));
}

// Catches time that grows with the square of the columns, by the time limit of a process.
TEST_CASE("headers may be as wide as lines are long") {
    std::string names = "qw,qx,qy,qz";
    std::string row = "1,0,0,0";
    for (int i = 5; i <= 300'000; ++i) {
        names += ",column" + std::to_string(i);
        row += ",1";
    }
    std::string rows;
    for (int i = 0; i < 3; ++i) {
        rows += row + '\n';
    }
    for (const std::string sign : {"", "#"}) {
        for (const std::string columns : {"1-4", "qw,qx,qy,qz"}) {
            for (const std::string format : {"csv", "json"}) {
                INFO(sign << ' ' << columns << ' ' << format);
                const auto result = run("-f quat -t quat --threads 2 --columns " + columns + " --format " + format,
                                        sign + names + '\n' + rows);
                CHECK(result.exit_code == 0);
                CHECK(result.out.find("column300000") != std::string::npos);
                CHECK(count_rows(result.out) == (format == "csv" ? 4 : 3));
            }
        }
    }
    const auto same = run("-f quat -t quat --columns 1-4 --format json", repeated("a,", 299'999) + "a\n" + rows);
    CHECK(same.exit_code == 0);
    CHECK(same.out.find("\"300000\"") != std::string::npos);
}
