#include <algorithm>
#include <fstream>

#include "usage.hpp"

using namespace program;

TEST_CASE("options of the conversion do not stand before a command") {
    // Catches an option that is taken and ignored.
    check_usage_error("-i rows rates -f quat 1 0 0 0 2 4 6", {"--input", "before rates"});
    check_usage_error("--append --precision 3 survey -f quat", {"before survey"});
    check_usage_error("-f quat list", {"before list"});
}

TEST_CASE("a sequence is three letters with different neighbours and of one case") {
    // Catches sequences that describe no attitude.
    for (const std::string& sequence : words_of("ZZX XYY ZY ZYXZ zYX ABC 123 passive")) {
        check_usage_error("-f quat -t euler:" + sequence, {sequence});
    }
    check_usage_error("-f quat -t euler", {"euler"});
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
    for (const std::string command_line : // @ stands for the evil word, % for the file of that name
         {"-f quat -t rpy -i @",
          "-f quat -t rpy -o absent/@ 1 0 0 0",
          "-f quat -t rpy @",
          "-f quat -t rpy %",
          "-f quat -t rpy -i %",
          "-f quat -t rpy % %",
          "-f quat -t rpy % 1",
          "-f @ -t rpy",
          "-f quat:@ -t rpy",
          "-f quat -t euler:@",
          "-f quat -t rpy --columns @,b,c,d",
          "-f quat -t rpy --columns @",
          "-f quat -t rpy --header @",
          "-f quat -t rpy --delimiter @",
          "-f quat -t rpy --precision @",
          "-f quat -t rpy --tolerance @",
          "-f quat -t dcm --method @",
          "-f quat -t rpy --@",
          "-f quat -t rpy -@",
          "propagate -t quat --initial quat:@",
          "propagate -t quat --initial @",
          "propagate -t quat --integrator @",
          "propagate -t quat @",
          "list @",
          "list quat @"}) {
        Words arguments = words_of(command_line);
        for (std::string& word : arguments) {
            const auto at = word.find_first_of("@%");
            word = at == std::string::npos ? word : word.replace(at, 1, word[at] == '@' ? evil : file);
        }
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

TEST_CASE("the version names the kernels that the processor can run") {
    // Catches a name that is not of the kernels chosen, and a choice that does not look at the processor.
    std::ifstream processor("/proc/cpuinfo");
    const std::string flags(std::istreambuf_iterator<char>(processor), {});
    const bool has_fma = flags.find(" avx2 ") != std::string::npos && flags.find(" fma ") != std::string::npos;
    const auto version = run("--version");
    CHECK(missing(version.out, {has_fma ? "(kernels: avx2_fma)" : "(kernels: any_processor)"}) == "");
    CHECK(version == done(last_line(version.out) + "\n"));
}

TEST_CASE("every command has a help that fits on a screen or two, and names what all share once") {
    // Catches a help that is an error message, that breaks in the middle of words or that has to be read from end to
    // end, and an option that is explained nowhere.
    for (const std::string command :
         {"", "list", "rates", "propagate", "survey", "compare", "compose", "rotate", "identify", "sample"}) {
        INFO(command);
        const auto help = run(command + " --help");
        CHECK(help == done(help.out));
        const auto lines = fields_of(help.out, '\n');
        CHECK(lines.size() <= (command.empty() ? 75 : 45));
        CHECK(std::ranges::all_of(lines, [](const std::string& line) { return line.size() <= 100; }));
        CHECK(help.out.find("\n\n\n") == std::string::npos);
        if (command != "list" && command != "sample") {
            CHECK(missing(help.out, {"\nWhat:\n", "\nColumns:\n", "\nErrors:\n", "\nMore:\n"}) == "");
        }
    }
    const auto help = run("--help");
    CHECK(run("-f quat --help") == help);
    CHECK(missing(help.out, {" passive deg col xyzw wxyz positive\n",
                             " scipy ros tum matlab basilisk spice bunge baruh trawny jpl ", "rotconv list presets",
                             "--comment PREFIX ", "What comments begin with", "\n  0  ", "\n  1  ", "\n  2  "}) == "");
    const auto shared = run("compare --help").out;
    CHECK(missing(shared, {"shared: --columns --header", "--worst N ", "rotconv --help explains"}) == "");
    CHECK(shared.find("What comments begin with") == std::string::npos);
}

TEST_CASE("list knows every representation") {
    // Catches a representation that cannot be looked up.
    const auto all = run("list");
    CHECK(all == done(all.out));
    for (const std::string& name : words_of("dcm 6d 5d quat axis-angle rotvec euler rpy cayley mrp")) {
        CHECK(missing(all.out, {"\n" + name}) == "");
        CHECK(run("list " + name).out.starts_with(name));
    }
}
