#include <catch.hpp>

#include "process.hpp"

using namespace program;

TEST_CASE("a first row without numbers is the header") {
    // Catches a header that is an error, lost, or left with the old names.
    CHECK(run(reorder, "qw,qx,qy,qz\n1,0,0,0\n") == done("qx,qy,qz,qw\n0,0,0,1\n"));
    CHECK(run("-f quat -t cayley", "a b c d\n1 0 0 0\n") == done("cx cy cz\n0 0 0\n"));
    CHECK(run("-f quat -t euler:ZYX", "a;b;c;d\r\n1;0;0;0\r\n") == done("e1;e2;e3\r\n0;0;0\r\n"));
    CHECK(run(reorder, "# note\n\nqw,qx,qy,qz\n1,0,0,0\n") == done("# note\n\nqx,qy,qz,qw\n0,0,0,1\n"));
}

TEST_CASE("a first row with one number is data") {
    // Catches a broken first row that is taken for a header in silence.
    for (const char* row : {"1,x,y,z", "w,x,y,0", "nan,x,y,z", "w,inf,y,z", "w,x,-1e400,z"}) {
        CHECK(run(reorder, std::string(row) + "\n1,0,0,0\n") == stopped("", {"rotconv: -:1: "}));
    }
}

TEST_CASE("header add prints one where there was none") {
    // Catches a missing header, and a first row that is lost to it.
    CHECK(run(reorder + "--header add", "1,0,0,0\n") == done("qx,qy,qz,qw\n0,0,0,1\n"));
    CHECK(run("-f quat -t rotvec --header add", "1 0 0 0\n1 0 0 0\n") == done("rx ry rz\n0 0 0\n0 0 0\n"));
    CHECK(run(reorder + "--header add", "1;0;0;0\r\n") == done("qx;qy;qz;qw\r\n0;0;0;1\r\n"));
}

TEST_CASE("a name matches up to the first blank of a header field") {
    // Catches units that hide a column, as in EuRoC's ground truth.
    const std::string names = "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],";
    CHECK(run(reorder + "--columns q_RS_w,q_RS_x,q_RS_y,q_RS_z",
              names +
                  "q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n1403636580838555648,4.68,-1.78,0.78,0.5,-0.5,0.5,0.5\n") ==
          done(names + "qx,qy,qz,qw\n1403636580838555648,4.68,-1.78,0.78,-0.5,0.5,0.5,0.5\n"));
    CHECK(run(reorder + "--columns q_RS_w,q_RS_x,q_RS_y,q_RS_z",
              "# t, q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z []\r\n"
              "7,1,0,0,0\r\n") == done("# t,qx,qy,qz,qw\r\n7,0,0,0,1\r\n"));
}

TEST_CASE("a header may begin with a number sign") {
    // Catches a first name that is not found behind it, or a header that is no comment any more.
    CHECK(run(reorder + "--columns qw,qx,qy,qz", "# t qw qx qy qz note\n7 1 0 0 0 a\n") ==
          done("# t qx qy qz qw note\n7 0 0 0 1 a\n"));
    for (const std::string sign : {"#", "# ", "#  ", "#\t"}) {
        CHECK(run(reorder + "--columns qw,qx,qy,qz", sign + "qw,qx,qy,qz,t\n1,0,0,0,7\n") ==
              done(sign + "qx,qy,qz,qw,t\n0,0,0,1,7\n"));
    }
}

TEST_CASE("words for a missing number are no names") {
    // Catches a first row without values that is taken for a header, and its row lost.
    for (const char* row : {"NA,NA,NA,NA", ",,,", "w,n/a,y,z", "w,NULL,y,z", "None,x,y,z", "w,x,y,nil", "-,-,-,-",
                            "w,?,y,z", "., . ,.,.", "w,\"\",y,z", "w,\"NaN\",y,z"}) {
        INFO(row);
        CHECK(run(reorder + "--on-error nan", std::string(row) + "\n1,0,0,0\n") ==
              went_on("nan,nan,nan,nan\n0,0,0,1\n"));
    }
    // other columns may be called anything
    CHECK(run(reorder + "--columns 2-5", "NA,w,x,y,z,\n7,1,0,0,0,8\n") == done("NA,qx,qy,qz,qw,\n7,0,0,0,1,8\n"));
}

TEST_CASE("the comment before the first row is the header where it has its fields") {
    // Catches eight names over seven columns.
    CHECK(run("-f quat:tum -t rpy --columns 5-8",
              "# truth\n# timestamp tx ty tz qx qy qz qw\n1.5 1 2 3 0 0 0 1\n# end\n") ==
          done("# truth\n# timestamp tx ty tz roll pitch yaw\n1.5 1 2 3 0 0 0\n# end\n"));
    CHECK(run("-f quat -t rpy --columns 2-5", "#t [ns], q_w [], q_x [], q_y [], q_z [],v\r\n\r\n7,1,0,0,0,9\r\n") ==
          done("#t [ns],roll,pitch,yaw,v\r\n\r\n7,0,0,0,9\r\n"));
    CHECK(run("-f quat -t rpy --append", "# qw qx qy qz  \n1 0 0 0\n") ==
          done("# qw qx qy qz roll pitch yaw\n1 0 0 0 0 0 0\n"));
    CHECK(run("-f quat -t rpy --columns 1-4 --format json", "#qw;qx;qy;qz;id\n1;0;0;0;9\n") ==
          done("{\"id\": 9, \"roll\": 0, \"pitch\": 0, \"yaw\": 0}\n"));
    CHECK(run("rates -f quat --columns 2-8", "# t qw qx qy qz wx wy wz\n5 1 0 0 0 0 0 2\n") ==
          done("# t qw_rate qx_rate qy_rate qz_rate\n5 0 0 0 1\n"));
    CHECK(run("propagate -t rotvec", "# timestamp wx wy wz\n0 0 0 0\n") == done("# timestamp rx ry rz\n0 0 0 0\n"));
    CHECK(run("-f quat -t rpy --header yes", "#a,b,c,d\n1,0,0,0\n") == done("#roll,pitch,yaw\n0,0,0\n"));
    // Of two rows that could be it the one without a mark, if its fields are no numbers: a remark has many words.
    CHECK(run("-f quat -t rpy --header yes", "#a,b,c,d\nw,x,y,z\n").out == "#a,b,c,d\nroll,pitch,yaw\n");
    CHECK(run("-f quat -t rpy --header yes", "# exported, by, tool, x\nqw,qx,qy,qz\n1,0,0,0\n") ==
          done("# exported, by, tool, x\nroll,pitch,yaw\n0,0,0\n"));
}

TEST_CASE("a comment that is not the first row's header passes") {
    // Catches remarks that lose their words, and a header that is not the last comment.
    for (const char* comment : {
             "# one two three four\n",             // under blanks only the representation's names
             "# qw qx qy qz\n# recorded in May\n", // only the last comment
             "# qw qx qy qz t\n",                  // another number of fields
             "# qw qx qy 1\n",                     // a number
             "# a,b,c,d\n",                        // another delimiter
         }) {
        INFO(comment);
        CHECK(run(reorder, std::string(comment) + "1 0 0 0\n") == done(std::string(comment) + "0 0 0 1\n"));
    }
    CHECK(run(reorder + "--header no", "# a,b,c,d\n1,0,0,0\n") == done("# a,b,c,d\n0,0,0,1\n"));
    CHECK(run(reorder + "--header add", "# a,b,c,d\n1,0,0,0\n") == done("# a,b,c,d\nqx,qy,qz,qw\n0,0,0,1\n"));
    CHECK(run(reorder, "# a,b,c,d\nw,x,y,z\n1,0,0,0\n") == done("# a,b,c,d\nqx,qy,qz,qw\n0,0,0,1\n"));
    CHECK(run(reorder, "w,x,y,z\n# a,b,c,d\n1,0,0,0\n") == done("qx,qy,qz,qw\n# a,b,c,d\n0,0,0,1\n"));
    CHECK(run(reorder, "1,0,0,0\n# a,b,c,d\n1,0,0,0\n") == done("0,0,0,1\n# a,b,c,d\n0,0,0,1\n"));
    CHECK(run(reorder, "# qw qx qy qz\n\n# end").out == "# qw qx qy qz\n\n# end");
}

TEST_CASE("comments and blank rows before the first row keep their order and use no memory") {
    // Catches lines that are lost where they wait for the row that tells, and those that pile up.
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

TEST_CASE("of several rows with all names the last is the header") {
    // Catches a remark before the header that is taken for it, and one after it.
    const std::string by_name = reorder + "--columns qw,qx,qy,qz";
    CHECK(run(by_name, "# it is t qw qx qy qz here\nt,qw,qx,qy,qz\n7,1,0,0,0\n") ==
          done("# it is t qw qx qy qz here\nt,qx,qy,qz,qw\n7,0,0,0,1\n"));
    CHECK(run(by_name, "t,qw,qx,qy,qz\n# qw qx qy qz t\n\n7,1,0,0,0\n") ==
          done("t,qx,qy,qz,qw\n# qw qx qy qz t\n\n7,0,0,0,1\n"));
    CHECK(run(by_name, "#qx,qy,qz,qw\n# t,qw,qx,qy,qz\n# note\n7,1,0,0,0\n") ==
          done("#qx,qy,qz,qw\n# t,qx,qy,qz,qw\n# note\n7,0,0,0,1\n"));
    CHECK(run(by_name + " --format json", "qx,qy,qz,qw\nt,qw,qx,qy,qz\n7,1,0,0,0\n") ==
          done("{\"t\": 7, \"qx\": 0, \"qy\": 0, \"qz\": 0, \"qw\": 1}\n"));
    CHECK(run(by_name + " --on-error nan", "#t,qw,qx,qy,qz\nbroken\n").out ==
          "#t,qx,qy,qz,qw\nbroken nan nan nan nan\n");
    // a comment with the names as words is none where commas delimit
    CHECK(run(by_name, "# order: qw qx qy qz\n1,0,0,0,7\n") == stopped("# order: qw qx qy qz\n", {"rotconv: -:2: "}));
}

TEST_CASE("an input that is JSON is told so") {
    // Catches objects that are taken for a header, and a flood of bad rows.
    for (const char* json : {"{\"qw\": 1, \"qx\": 0, \"qy\": 0, \"qz\": 0}\n{\"qw\": 1}\n", "[[1,0,0,0],\n[1,0,0,0]]\n",
                             "\n[\n1,0,0,0\n]\n", "  {\n", "{}"}) {
        for (const char* more : {"", "--columns qw,qx,qy,qz"}) {
            INFO(json << more);
            CHECK(run(reorder + more, json) == stopped(any_output, {"rotconv: -:", "JSON"}));
        }
        // Whoever says that bad rows are to be gone over means these too.
        CHECK(run(reorder + "--delimiter comma --on-error skip", std::string(json) + "\n1,0,0,0\n")
                  .out.ends_with("0,0,0,1\n"));
        CHECK(run(reorder + "--header no", json).err.find("JSON") == std::string::npos);
    }
    CHECK(run(reorder + "--columns 2-5", "[a],1,0,0,0\n") == done("[a],0,0,0,1\n"));
    CHECK(run(reorder + "--columns qw,qx,qy,qz", "{t},qw,qx,qy,qz\n7,1,0,0,0\n") ==
          done("{t},qx,qy,qz,qw\n7,0,0,0,1\n"));
}

TEST_CASE("headers may be as wide as lines are long") {
    // Catches time that grows with the square of the columns, by the time limit of a process.
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
