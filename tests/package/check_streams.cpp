// check_streams FOLDER: converts the TUM, EuRoC and KITTI files of the folder as the examples do. Every attitude must
// be the input's to the table's limits, every other field the same bytes, every line there.

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "accuracy.hpp"
#include "oracle.hpp"
#include "process.hpp"

namespace {

struct Job {
    std::string file;
    std::string from;
    std::string to;
    std::string columns;
    std::vector<std::size_t> selected; ///< 0-based, in the order of the numbers
    char delimiter;
    bool append;
};

const std::vector<Job> jobs{
    {"tum_fr1_xyz.txt", "quat:tum", "rpy:deg", "5-8", {4, 5, 6, 7}, ' ', false},
    {"euroc.csv", "quat", "dcm", "q_RS_w,q_RS_x,q_RS_y,q_RS_z", {4, 5, 6, 7}, ',', false},
    {"kitti.txt", "dcm", "quat", "1-3,5-7,9-11", {0, 1, 2, 4, 5, 6, 8, 9, 10}, ' ', true},
};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// What a row should hold beside the result, in order.
std::vector<std::string> others(std::vector<std::string> fields, const Job& job) {
    if (job.append) {
        return fields;
    }
    auto sorted = job.selected;
    std::ranges::sort(sorted, std::greater<>());
    for (const std::size_t at : sorted) {
        fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(at));
    }
    return fields;
}

/// The worst attitude error in eps; negative where a row is not as it should be.
double check(const Job& job, const std::string& folder) {
    const auto from = accuracy::spec(job.from);
    const auto to = accuracy::spec(job.to);
    const std::string input = program::read_file(folder + "/" + job.file);
    program::Words arguments{"-f", job.from, "-t", job.to, "--columns", job.columns, "--diagnostics", "off"};
    if (job.append) {
        arguments.emplace_back("--append");
    }
    const auto result = program::run(arguments, input);
    const auto rows = lines_of(input);
    const auto answers = lines_of(result.out);
    if (result.exit_code != 0 || !result.err.empty() || rows.size() != answers.size()) {
        std::printf("%s: exit %d, %zu rows became %zu: %s\n", job.file.c_str(), result.exit_code, rows.size(),
                    answers.size(), result.err.c_str());
        return -1.0;
    }
    double worst = 0.0;
    std::size_t converted = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].starts_with('#')) {
            continue;
        }
        ++converted;
        const auto fields = program::fields_of(rows[i], job.delimiter);
        auto got = program::fields_of(answers[i], job.delimiter);
        const std::size_t start = job.append ? fields.size() : job.selected.front();
        std::vector<double> numbers;
        for (const std::size_t at : job.selected) {
            numbers.push_back(std::stod(fields.at(at)));
        }
        std::vector<double> answer;
        for (std::size_t k = 0; k < to.size(); ++k) {
            answer.push_back(std::stod(got.at(start + k)));
        }
        const auto first = got.begin() + static_cast<std::ptrdiff_t>(start);
        got.erase(first, first + static_cast<std::ptrdiff_t>(to.size()));
        if (got != others(fields, job)) {
            std::printf("%s: line %zu: other fields have changed: %s\n", job.file.c_str(), i + 1, answers[i].c_str());
            return -1.0;
        }
        worst = std::max(worst, oracle::error_in_eps(oracle::attitude(from, numbers), oracle::attitude(to, answer)));
    }
    const double limit = accuracy::limit_from(from) + accuracy::limit_to(to);
    std::printf("%s: %zu rows, worst %.2f eps, limit %g\n", job.file.c_str(), converted, worst, limit);
    return worst <= limit && converted > 0 ? worst : -1.0;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::puts("usage: check_streams FOLDER");
        return 2;
    }
    bool good = true;
    for (const Job& job : jobs) {
        good = check(job, argv[1]) >= 0.0 && good;
    }
    return good ? 0 : 1;
}
