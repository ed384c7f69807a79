#include <algorithm>
#include <fstream>

#include <catch.hpp>

#include "process.hpp"

using namespace program;

// Catches a name that writes lines of its own, or moves the cursor of a terminal.
// Beside control characters: of the direction of text, a soft hyphen, a vowel separator, an annotation, a tag.
TEST_CASE("whatever comes from outside is shown without its control characters") {
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

// Catches a name that is not of the kernels chosen, and a choice that does not look at the processor.
TEST_CASE("the version names the kernels that the processor can run") {
    std::ifstream processor("/proc/cpuinfo");
    const std::string flags(std::istreambuf_iterator<char>(processor), {});
    const bool has_fma = flags.find(" avx2 ") != std::string::npos && flags.find(" fma ") != std::string::npos;
    const auto version = run("--version");
    CHECK(missing(version.out, {has_fma ? "(kernels: avx2_fma)" : "(kernels: any_processor)"}) == "");
    CHECK(version == done(last_line(version.out) + "\n"));
}

// Catches a help that is an error message, that breaks in the middle of words or that has to be read from end to
// end, and an option that is explained nowhere.
TEST_CASE("every command has a help that fits on a screen or two, and names what all share once") {
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

// Catches a program that reads stdin, which is still open.
TEST_CASE("with VALUEs the end of stdin is not waited for") {
    Process process(words_of("-f quat -t quat 1 0 0 0"));
    CHECK(process.wait() == done("1 0 0 0\n"));
}
