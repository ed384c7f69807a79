#include <sstream>

#include "usage.hpp"

using namespace program;

TEST_CASE("options of the conversion do not stand before a command") {
    // Catches an option that is taken and ignored.
    check_usage_error("-i rows rates -f quat 1 0 0 0 2 4 6", {"--input", "before rates"});
    check_usage_error("--append --precision 3 survey -f quat", {"before survey"});
    check_usage_error("-f quat list", {"before list"});
}

TEST_CASE("an unknown representation is answered with a near name, or with where the names are listed") {
    // Catches a message that leaves the user to guess, and a name that is not near.
    check_usage_error("-f qqqq -t dcm", {"'qqqq' is not a known representation; rotconv list has them"});
    check_usage_error("-f quaternoin -t dcm", {"'quaternoin'", "did you mean quaternion?"});
    check_usage_error("-f quat -t rotvek", {"'rotvek'", "did you mean rotvec?"});
    check_usage_error("-f QUAT -t dcm", {"'QUAT'", "did you mean quat?"});
}

TEST_CASE("a missing SPEC is a usage error") {
    // Catches a default that nobody asked for.
    check_usage_error("", {"--from"});
    check_usage_error("-f quat", {"--to"});
    check_usage_error("-t quat", {"--from"});
    check_usage_error("-t quat 1 0 0 0", {"--from"});
    check_usage_error("-t quat -f", {"--from"});
}

TEST_CASE("a modifier without a meaning is answered with the legal ones") {
    // Catches modifiers that are ignored.
    check_usage_error("-f quat:deg -t dcm", {"deg", "quat", "passive", "xyzw"});
    check_usage_error("-f dcm:xyzw -t dcm", {"xyzw", "dcm", "passive", "col"});
    check_usage_error("-f quat -t mrp:deg", {"deg", "mrp", "passive"});
    check_usage_error("-f quat -t euler:ZYX:col", {"col", "euler", "passive", "deg"});
    check_usage_error("-f quat:xyzx -t dcm", {"xyzx", "xyzw"});
    check_usage_error("-f quat:scippy -t dcm", {"scippy", "scipy"});
    check_usage_error("-f quat: -t dcm", {"quat"});
}

TEST_CASE("a sequence is three letters with different neighbours and of one case") {
    // Catches sequences that describe no attitude.
    for (const std::string sequence : {"ZZX", "XYY", "ZY", "ZYXZ", "zYX", "ABC", "123", "passive"}) {
        check_usage_error("-f quat -t euler:" + sequence, {sequence});
    }
    check_usage_error("-f quat -t euler", {"euler"});
    check_usage_error("-f quat -t rpy:ZYX", {"ZYX"});
}

TEST_CASE("all 24 sequences are known") {
    // Catches a table with a gap.
    for (const char* letters : {"XYZ", "xyz"}) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                for (int k = 0; k < 3; ++k) {
                    if (i != j && j != k) {
                        const std::string sequence{letters[i], letters[j], letters[k]};
                        CHECK(run("-f euler:" + sequence + " -t quat 0 0 0") == done("1 0 0 0\n"));
                    }
                }
            }
        }
    }
}

TEST_CASE("modifiers are a set with at most one preset") {
    // Catches an order or a count that matters.
    CHECK(run("-f quat:xyzw:xyzw -t quat 0 0 0 1") == done("1 0 0 0\n"));
    CHECK(run("-f quat:scipy:xyzw -t quat 0 0 0 1") == done("1 0 0 0\n"));
    CHECK(run("-f quat:passive:passive -t quat 0.5 0.5 0.5 0.5") == done("0.5 -0.5 -0.5 -0.5\n"));
    CHECK(run("-f quat:passive:xyzw -t quat:xyzw:passive -0.5 0.5 0.5 0.5") == done("-0.5 0.5 0.5 0.5\n"));
    check_usage_error("-f quat:scipy:ros -t dcm", {"ros"});
    check_usage_error("-f quat -t dcm:spice:matlab", {"matlab"});
}

TEST_CASE("aliases are the names that they stand for") {
    // Catches an alias that points to a neighbour.
    CHECK(run("-f quaternion -t matrix 0.5 0.5 0.5 0.5") == done("0 0 1 1 0 0 0 1 0\n"));
    CHECK(run("-f quat -t two-column 0.5 0.5 0.5 0.5") == done("0 1 0 0 0 1\n"));
    CHECK(run("-f two-column -t 6d 0 1 0 0 0 1") == done("0 1 0 0 0 1\n"));
    CHECK(run("-f gibbs -t cayley 1 1 1") == done("1 1 1\n"));
    CHECK(run("-f axang -t exp 1 0 0 0") == done("0 0 0\n"));
    CHECK(run("-f hopf -t quat --diagnostics off -- 0 0 0 2.414213562373095 0") == done("1 0 0 0\n"));
}

TEST_CASE("a preset leaves the names alone that it does not mention") {
    // Catches a preset that is refused or does too much.
    CHECK(run("-f dcm:scipy -t quat:scipy 0 0 1 1 0 0 0 1 0") == done("0.5 0.5 0.5 0.5\n"));
    CHECK(run("-f dcm:matlab -t quat:matlab 0 0 1 1 0 0 0 1 0") == done("0.5 -0.5 -0.5 -0.5\n"));
    CHECK(run("-f dcm:spice -t quat:spice 0 0 1 1 0 0 0 1 0") == done("0.5 0.5 0.5 0.5\n"));
    CHECK(run("-f dcm:trawny -t quat:trawny 0 0 1 1 0 0 0 1 0") == done("-0.5 -0.5 -0.5 0.5\n"));
    CHECK(run("-f dcm:stuelpnagel -t quat:stuelpnagel 0 0 1 1 0 0 0 1 0") == done("0.5 0.5 0.5 0.5\n"));
    CHECK(run("-f euler:ZYX:spice:deg -t dcm 90 0 0") == done("0 -1 0 1 0 0 0 0 1\n"));
    CHECK(run("-f mrp:trawny -t mrp:tum 0 0 0") == done("0 0 0\n"));
}

TEST_CASE("a word that an option does not know is answered with the legal ones") {
    // Catches a default that hides a slip of the pen.
    const std::string convert = "-f quat -t dcm ";
    check_usage_error(convert + "--header maybe", {"maybe", "auto", "yes", "no", "add"});
    check_usage_error(convert + "--on-error nam", {"nam", "stop", "nan", "skip", "did you mean nan?"});
    check_usage_error(convert + "--format jsn", {"jsn", "csv", "json", "pretty", "did you mean json?"});
    check_usage_error(convert + "--diagnostics colums",
                      {"colums", "off", "summary", "rows", "columns", "did you mean columns?"});
    check_usage_error(convert + "--delimiter colon", {"colon", "comma", "tab", "semicolon", "blank"});
}

TEST_CASE("an unknown option is answered with the nearest") {
    // Catches options that are ignored or taken for VALUEs.
    check_usage_error("-f quat -t dcm --precison 3", {"--precison", "did you mean --precision?"});
    check_usage_error("-f quat -t dcm --degree", {"--degree", "did you mean --degrees?"});
    check_usage_error("-f quat -t dcm -x", {"-x"});
    check_usage_error("-f quat -t dcm --strict=maybe", {"--strict"});
}

TEST_CASE("an option without its argument is a usage error") {
    // Catches the next option taken for the argument's absence, or a crash.
    for (const char* option : {"-i", "-o", "--columns", "--delimiter", "--header", "--format", "-p", "--decimals",
                               "--diagnostics", "--on-error", "--tolerance", "--lock-margin", "--threads"}) {
        check_usage_error(std::string("-f quat -t dcm ") + option, {option});
    }
}

TEST_CASE("an option that is given twice, or a flag with an argument, is named") {
    // Catches the parser's own sentence, and an argument that is dropped.
    check_usage_error("-f quat -f dcm -t dcm", {"rotconv: --from is given twice"});
    check_usage_error("-fquat --from=dcm -t dcm", {"rotconv: --from is given twice"});
    check_usage_error("rates -f quat -p 3 --precision 4", {"rotconv: --precision is given twice"});
    check_usage_error("-f quat -t dcm --append=5", {"rotconv: --append takes no argument"});
    check_usage_error("-f quat -t dcm --help=5", {"rotconv: --help takes no argument"});
    CHECK(run("-f quat -t rpy -d -d 1 0 0 0") == done("0 0 0\n"));
}

TEST_CASE("whatever comes from outside is shown without its control characters") {
    // Catches a name that writes lines of its own, or moves the cursor of a terminal.
    // Beside control characters: of the direction of text, a soft hyphen, a vowel separator, an annotation, a tag.
    const Words hidden{"\x1B",     "\x07",         "\xC2\x9B",     "\xE2\x80\xAE",     "\xD8\x9C",
                       "\xC2\xAD", "\xE1\xA0\x8E", "\xEF\xBF\xB9", "\xF3\xA0\x80\x81", "\xFF"};
    std::string evil = "a\x1B]0;x\x07\nrotconv: b:1: fake";
    for (const std::string& bytes : hidden) {
        evil += bytes;
    }
    const Folder folder;
    const auto file = (folder / evil).string();
    write_file(file, "1 0 0 zero" + evil.substr(0, 5) + "\n");
    const std::vector<Words> command_lines{{"-f", "quat", "-t", "rpy", "-i", evil},
                                           {"-f", "quat", "-t", "rpy", "-o", "absent/" + evil, "1", "0", "0", "0"},
                                           {"-f", "quat", "-t", "rpy", evil},
                                           {"-f", "quat", "-t", "rpy", file},
                                           {"-f", "quat", "-t", "rpy", "-i", file},
                                           {"-f", "quat", "-t", "rpy", file, file},
                                           {"-f", "quat", "-t", "rpy", file, "1"},
                                           {"-f", evil, "-t", "rpy"},
                                           {"-f", "quat:" + evil, "-t", "rpy"},
                                           {"-f", "quat", "-t", "euler:" + evil},
                                           {"-f", "quat", "-t", "rpy", "--columns", evil + ",b,c,d"},
                                           {"-f", "quat", "-t", "rpy", "--columns", evil},
                                           {"-f", "quat", "-t", "rpy", "--header", evil},
                                           {"-f", "quat", "-t", "rpy", "--delimiter", evil},
                                           {"-f", "quat", "-t", "rpy", "--precision", evil},
                                           {"-f", "quat", "-t", "rpy", "--tolerance", evil},
                                           {"-f", "quat", "-t", "dcm", "--method", evil},
                                           {"-f", "quat", "-t", "rpy", "--" + evil},
                                           {"-f", "quat", "-t", "rpy", "-" + evil},
                                           {"propagate", "-t", "quat", "--initial", "quat: 1 0 0 " + evil},
                                           {"propagate", "-t", "quat", "--initial", evil},
                                           {"propagate", "-t", "quat", "--integrator", evil},
                                           {"propagate", "-t", "quat", evil},
                                           {"list", evil},
                                           {"list", "quat", evil}};
    for (const Words& arguments : command_lines) {
        const auto result = run(arguments, "1,0,0,zero\n");
        INFO(result);
        CHECK(result.exit_code == 2);
        CHECK(result.err.find("\nrotconv: b:1: fake") == std::string::npos);
        for (const std::string& bytes : hidden) {
            CHECK(result.err.find(bytes) == std::string::npos);
        }
    }
    // What a person can read is shown as it is.
    CHECK(missing(run("-f quat -t rpy m\xC3\xA4rz.csv").err, {"'m\xC3\xA4rz.csv'"}) == "");
}

TEST_CASE("an empty argument of an option is a usage error") {
    // Catches a shell variable without a value that is taken for the default.
    for (const std::string option :
         {"--from", "--columns", "--delimiter", "--header", "--format", "--precision", "--decimals", "--diagnostics",
          "--on-error", "--tolerance", "--lock-margin", "--threads"}) {
        for (const auto& words : {Words{option, ""}, Words{option + "="}}) {
            INFO(option);
            Words arguments{"-f", "quat", "-t", "dcm"};
            if (option == "--from") {
                arguments = {"-t", "dcm"};
            }
            arguments.insert(arguments.end(), words.begin(), words.end());
            CHECK(run(arguments, "1 0 0 0\n") == stopped(""));
        }
    }
}

TEST_CASE("numbers of options are checked") {
    // Catches digits that are cut off, and senseless amounts.
    const std::string convert = "-f quat -t dcm ";
    for (const std::string digits : {"0", "-1", "2.5", "x", "nan", "1e99", "3x"}) {
        check_usage_error(convert + "-p " + digits, {"precision", digits});
        if (digits != "0") {
            check_usage_error(convert + "--decimals " + digits, {"decimals", digits});
        }
        check_usage_error(convert + "--threads " + digits, {"threads", digits});
    }
    check_usage_error(convert + "--decimals 101", {"--decimals '101' must be a whole number from 0 to 100"});
    check_usage_error(convert + "-p 3 --decimals 3", {"--precision cannot be combined with --decimals"});
    for (const std::string amount : {"-1", "x", "nan", "-inf", "1e-3x"}) {
        check_usage_error(convert + "--tolerance " + amount, {"tolerance", amount});
        check_usage_error(convert + "--lock-margin " + amount, {"lock-margin", amount});
    }
}

TEST_CASE("no line of a help is wider than 100 columns") {
    // Catches a help that breaks in the middle of words.
    for (const char* command : {"", "list", "rates", "propagate", "survey", "compare", "identify", "sample"}) {
        const auto printed = run(command + std::string(" --help"));
        CHECK(printed.exit_code == 0);
        CHECK(count_rows(printed.out) > 5);
        std::istringstream help(printed.out);
        for (std::string line; std::getline(help, line);) {
            INFO(line);
            CHECK(line.size() <= 100);
        }
    }
}

TEST_CASE("help and version go to stdout with exit 0") {
    // Catches help that is an error message.
    const auto help = run("--help");
    CHECK(help.exit_code == 0);
    CHECK(help.err == "");
    CHECK(missing(help.out, {"rotconv", "--from", "--to", "--columns", "--on-error", "axis-angle", "mrp"}) == "");
    CHECK(run("-f quat --help") == help);
    const auto version = run("--version");
    CHECK(version.exit_code == 0);
    CHECK(version.err == "");
    CHECK(missing(version.out, {"rotconv", "."}) == "");
    CHECK(count_rows(version.out) == 1);
}

TEST_CASE("the version names the kernels that the processor can run") {
    // Catches a name that is not of the kernels chosen, and a choice that does not look at the processor.
    std::ifstream processor("/proc/cpuinfo");
    const std::string flags(std::istreambuf_iterator<char>(processor), {});
    const bool has_fma = flags.find(" avx2 ") != std::string::npos && flags.find(" fma ") != std::string::npos;
    CHECK(missing(run("--version").out, {has_fma ? "(kernels: avx2_fma)" : "(kernels: any_processor)"}) == "");
}

TEST_CASE("list knows every representation") {
    // Catches a representation that cannot be looked up.
    const auto all = run("list");
    CHECK(all.exit_code == 0);
    CHECK(all.err == "");
    for (const std::string name :
         {"dcm", "6d", "5d", "quat", "axis-angle", "rotvec", "euler", "rpy", "cayley", "mrp"}) {
        CHECK(missing(all.out, {name}) == "");
        const auto one = run("list " + name);
        CHECK(one.exit_code == 0);
        CHECK(missing(one.out, {name}) == "");
    }
    check_usage_error("list quaternoin", {"quaternoin", "quaternion"});
    check_usage_error("lst", {"lst", "list"});
}

TEST_CASE("a help fits on a screen or two, and an option that all commands share is explained once") {
    // Catches a help that nobody reads to its end, and an option that is explained nowhere.
    CHECK(count_rows(run("--help").out) <= 75);
    for (const char* command :
         {"list", "rates", "propagate", "survey", "compare", "compose", "rotate", "identify", "sample"}) {
        INFO(command);
        CHECK(count_rows(run(command + std::string(" --help")).out) <= 45);
    }
    const auto shared = run("compare --help").out;
    CHECK(missing(shared, {"shared: --columns --header", "--worst N ", "rotconv --help explains"}) == "");
    CHECK(shared.find("What comments begin with") == std::string::npos);
    CHECK(missing(run("--help").out, {"--comment PREFIX ", "What comments begin with"}) == "");
}
