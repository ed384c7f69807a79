// bench_scaling OUT.csv: rows per second of quaternions to matrices, as text and as doubles, by threads and by the
// number of other fields in a row, from a file into a pipe; and of `cat`, which only copies the text.

#include <algorithm>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "figures.hpp"
#include "processes.hpp"
#include "stream/bytes/file.hpp"

namespace {

constexpr int numbers = 4; ///< of a quaternion

struct Form {
    const char* name;
    bool is_doubles;
    int rows;   ///< where a row has no other field
    int halved; ///< by so many other fields, which leaves wide rows enough to be measured
};
constexpr Form text{"text", false, 1'000'000, 16};
constexpr Form doubles{"doubles", true, 4'000'000, 4};

/// The number of rows shrinks as they get wider.
int rows_of(const Form& form, int others) { return form.rows * form.halved / (form.halved + others); }

/// Quaternions, each followed by `others` numbers.
void write_input(const std::string& path, const Form& form, int others) {
    Attitudes attitudes;
    std::ofstream file(path, std::ios::binary);
    for (int i = 0; i < rows_of(form, others); ++i) {
        if (form.is_doubles) {
            const auto q = attitudes.next();
            file.write(reinterpret_cast<const char*>(&q), sizeof q);
            for (int k = 0; k < others; ++k) {
                const double other = k;
                file.write(reinterpret_cast<const char*>(&other), sizeof other);
            }
        } else {
            file << attitudes.next_row();
            for (int k = 0; k < others; ++k) {
                file << ",12.34" << k % 10;
            }
            file << '\n';
        }
    }
}

std::string conversion(const Form& form, int others, int threads) {
    return fmt::format("{} -f quat -t dcm --diagnostics off --columns 1-4 --threads {} {}", ROTCONV_PROGRAM, threads,
                       form.is_doubles ? fmt::format("--input-format f64 --format f64 --width {}", numbers + others)
                                       : "");
}

/// From the file into a pipe, as into another program: to write to /dev/null takes no time.
double rows_per_second(const std::string& program, const std::string& path, int rows) {
    const std::string command = fmt::format("{} < {} | cat > /dev/null", program, path);
    Time time = time_of(command);
    for (int round = 1; round < 5; ++round) {
        time = least(time, time_of(command));
    }
    return rows / time.clock;
}

void measure(std::ostream& csv) {
    csv << "form,threads,others,rows_per_second\n";
    const Folder folder;
    const std::string input = folder / "input";
    const int processors = static_cast<int>(rotconv::stream::processors());
    for (const Form& form : {text, doubles}) {
        for (const int others : {0, 1, 4, 16, 64, 256}) {
            write_input(input, form, others);
            const auto add = [&](const char* name, int threads, const std::string& program) {
                csv << fmt::format("{},{},{},{:.4g}\n", name, threads, others,
                                   rows_per_second(program, input, rows_of(form, others)));
            };
            if (!form.is_doubles) {
                add("copy", 1, "cat");
            }
            for (int threads = 1; threads <= processors; ++threads) {
                add(form.name, threads, conversion(form, others, threads));
            }
        }
    }
}

} // namespace

int main(int argc, char** argv) { return write_figures(argc, argv, measure); }
