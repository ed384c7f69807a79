// bench_tools OUT.csv: what a user would pick to turn matrices into roll, pitch and yaw in degrees, text to text, as
// processes: rows a second, and the worst attitude error against 36 digits.
//
// The input is one block of rows, again and again. The first run of each tool is scored, on one block; then all are
// timed in turns, and the least time counts.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include "figures.hpp"
#include "oracle.hpp"
#include "processes.hpp"
#include "stream/bytes/file.hpp"

namespace {

constexpr std::size_t each = 12500; ///< rows of a kind in the block
constexpr std::size_t blocks = 20;
constexpr int rounds = 3;

/// In the order of the figures' columns.
enum class Kind : std::size_t { clean, half_turn, lock, noise };
constexpr std::size_t kinds = 4;
constexpr std::size_t rows = each * kinds * blocks;

const rotconv::Spec from{.name = rotconv::RepresentationId::dcm};
const rotconv::Spec to{.name = rotconv::RepresentationId::rpy, .unit = rotconv::AngleUnit::degrees};

/// The kinds take turns.
struct Block {
    std::string text;
    std::vector<oracle::Quaternion> exact;
};

/// The matrix of a random attitude of that kind. Half-turns and gimbal lock are 1e-9 to 1e-3 rad away or, once in eight
/// times, exact; noise is up to as large in every number.
std::array<double, 9> matrix_of(Kind kind, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const auto uniform = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const double size = std::pow(10.0, uniform(-9.0, -3.0));
    const double distance = random() % 8 == 0 ? 0.0 : size;
    const Eigen::Vector4d numbers(normal(random), normal(random), normal(random), normal(random));
    Eigen::Quaterniond q(numbers.normalized());
    if (kind == Kind::half_turn) {
        q.w() = std::sin(distance / 2.0);
        q.vec() = std::cos(distance / 2.0) * q.vec().normalized();
    }
    Eigen::Matrix3d matrix = q.toRotationMatrix();
    if (kind == Kind::lock) {
        const double sign = random() % 2 == 0 ? 1.0 : -1.0;
        Eigen::Matrix3d pitch;
        pitch << std::sin(distance), 0.0, sign * std::cos(distance), 0.0, 1.0, 0.0, -sign * std::cos(distance), 0.0,
            std::sin(distance);
        matrix = Eigen::AngleAxisd(uniform(-3.0, 3.0), Eigen::Vector3d::UnitZ()).toRotationMatrix() * pitch *
                 Eigen::AngleAxisd(uniform(-3.0, 3.0), Eigen::Vector3d::UnitX()).toRotationMatrix();
    }
    std::array<double, 9> row{};
    for (std::size_t i = 0; i < row.size(); ++i) {
        row.at(i) = matrix(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) +
                    (kind == Kind::noise ? uniform(-size, size) : 0.0);
    }
    return row;
}

Block make_block() {
    std::mt19937_64 random(20261124);
    Block block;
    for (std::size_t i = 0; i < each * kinds; ++i) {
        const auto row = matrix_of(static_cast<Kind>(i % kinds), random);
        block.text += fmt::format("{:.17g}\n", fmt::join(row, ","));
        block.exact.push_back(oracle::attitude(from, row));
    }
    return block;
}

struct Tool {
    std::string name;
    std::string version; ///< a command that prints it; nothing where the tool is not installed
    std::string command; ///< a filter
};

std::vector<Tool> tools() {
    const std::string eigen =
        fmt::format("echo Eigen {}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
    // The noise leaves defects of up to 0.003.
    const std::string rotconv = ROTCONV_PROGRAM " -f dcm -t rpy:deg --tolerance 0.01 --diagnostics off --threads ";
    const std::string python = PYTHON " " PEERS "/";
    return {
        {"rotconv on 1 thread", ROTCONV_PROGRAM " --version", rotconv + "1"},
        {"rotconv on 2 threads", ROTCONV_PROGRAM " --version", rotconv + "2"},
        {"pandas + SciPy",
         PYTHON " -c 'import pandas, scipy; print(\"pandas\", pandas.__version__, \"SciPy\", scipy.__version__)'",
         python + "pandas_scipy.py"},
        {"NumPy", PYTHON " -c 'import numpy; print(\"NumPy\", numpy.__version__)'", python + "numpy_formula.py"},
        {"mawk", "mawk -W version", "mawk -f " PEERS "/formula.awk"},
        {"Miller", "mlr --version",
         "mlr --csvlite --implicit-csv-header --headerless-csv-output put -f " PEERS "/formula.mlr"},
        {"DuckDB",
         "node -p '\"DuckDB \" + require(\"@duckdb/node-api\").version() + \" in Node.js \" + process.version'",
         "node " PEERS "/duckdb.js"},
        {"C++: Eigen + iostreams", eigen, EIGEN_IOSTREAMS},
        {"C++: Eigen + fast_float", eigen + " and Dragonbox", BARE_LOOP " rpy"},
    };
}

/// The first line that a command prints.
std::string first_line(const std::string& command) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen((command + " 2> /dev/null").c_str(), "r"),
                                                               ::pclose);
    std::array<char, 200> line{};
    if (pipe == nullptr || std::fgets(line.data(), static_cast<int>(line.size()), pipe.get()) == nullptr) {
        return {};
    }
    std::string text(line.data());
    std::erase_if(text, [](char c) { return c == '\n' || c == ','; }); // a field of the figures
    return text;
}

struct Measurement {
    Tool tool;
    std::string version;
    bool broke = false;                ///< it is installed, and a run of it failed
    std::array<double, kinds> worst{}; ///< radians
    std::size_t failed = 0;            ///< rows of the block without three finite angles, and rows that lack
    std::vector<double> seconds{};
};

bool read_angles(const std::string& row, std::array<double, 3>& angles) {
    const char* at = row.c_str();
    for (double& angle : angles) {
        char* end = nullptr;
        angle = std::strtod(at, &end);
        if (end == at || !std::isfinite(angle)) {
            return false;
        }
        at = end + (*end == ',' ? 1 : 0);
    }
    return *at == '\0';
}

void score(Measurement& made, const Block& block, const std::string& output) {
    std::ifstream file(output);
    std::string row;
    std::size_t i = 0;
    for (; std::getline(file, row); ++i) {
        std::array<double, 3> angles{};
        if (i >= block.exact.size()) {
            continue;
        }
        if (!read_angles(row, angles)) {
            ++made.failed;
            continue;
        }
        double& worst = made.worst.at(i % kinds);
        worst = std::fmax(worst, oracle::eps * oracle::error_in_eps(block.exact[i], oracle::attitude(to, angles)));
    }
    made.failed += std::max(rows, i) - std::min(rows, i);
}

std::vector<Measurement> measure(const Block& block) {
    const Folder folder;
    const std::string input = folder / "input";
    const std::string output = folder / "output";
    std::ofstream file(input);
    for (std::size_t i = 0; i < blocks; ++i) {
        file << block.text;
    }
    file.close();
    const auto run = [&](const Tool& tool, const std::string& to_file) {
        return time_of("exec " + tool.command + " < " + input + " > " + to_file).clock;
    };
    // One that fails, and says why on stderr, is no reason to lose the others.
    const auto try_run = [&](Measurement& made, const std::string& to_file) {
        try {
            return run(made.tool, to_file);
        } catch (const std::exception& error) {
            fmt::print("failed, left out: {}: {}\n", made.tool.name, error.what());
            made.broke = true;
            return 0.0;
        }
    };
    std::vector<Measurement> all;
    for (const Tool& tool : tools()) {
        Measurement& made = all.emplace_back(Measurement{tool, first_line(tool.version)});
        if (made.version.empty()) {
            fmt::print("not installed, left out: {}\n", tool.name);
            continue;
        }
        if (try_run(made, output); !made.broke) {
            score(made, block, output);
        }
    }
    for (int round = 0; round < rounds; ++round) {
        for (Measurement& made : all) {
            if (!made.version.empty() && !made.broke) {
                made.seconds.push_back(try_run(made, "/dev/null"));
            }
        }
    }
    return all;
}

/// The processor, as Linux says it.
std::string processor() {
    std::string text = first_line("grep -m 1 'model name' /proc/cpuinfo");
    return text.substr(std::min(text.size(), text.find(':') + 2));
}

void write(std::ostream& csv, double load, const std::vector<Measurement>& all) {
    csv << "# cmake --build build/bench --target tools-chart\n"
        << fmt::format("# {}, {} processors, load {:.1f} before, {:%d %B %Y}\n", processor(),
                       rotconv::stream::processors(), load, fmt::localtime(std::time(nullptr)))
        << fmt::format(
               "# {} rows of 9 numbers of 17 digits, a quarter of each kind: uniform attitudes, half-turns, gimbal "
               "lock, noise, the last three 1e-9 to 1e-3\n# worst errors in radians, of {} rows a kind; DuckDB and "
               "Miller on all processors\n",
               rows, each)
        << "tool,version,rows,seconds_1,seconds_2,seconds_3,rows_per_second,clean,half_turn,lock,noise,failed\n";
    for (const Measurement& made : all) {
        if (made.version.empty() || made.broke) {
            csv << made.tool.name << (made.broke ? ",failed" : ",not installed") << ",,,,,,,,,,\n";
            continue;
        }
        csv << fmt::format("{},{},{},{:.3f},{:.4g},{:.3g},{}\n", made.tool.name, made.version, rows,
                           fmt::join(made.seconds, ","),
                           static_cast<double>(rows) / *std::ranges::min_element(made.seconds),
                           fmt::join(made.worst, ","), made.failed);
    }
}

} // namespace

int main(int argc, char** argv) {
    return write_figures(argc, argv, [](std::ostream& csv) {
        double load = 0;
        ::getloadavg(&load, 1);
        write(csv, load, measure(make_block()));
    });
}
