#include "processes.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

Time least(const Time& a, const Time& b) { return {std::min(a.clock, b.clock), std::min(a.processor, b.processor)}; }

Time time_of(const std::string& command) {
    const auto start = std::chrono::steady_clock::now();
    const pid_t id = ::fork();
    if (id == 0) {
        ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        std::_Exit(127);
    }
    int status = 0;
    rusage used{};
    ::wait4(id, &status, 0, &used);
    const std::chrono::duration<double> clock = std::chrono::steady_clock::now() - start;
    if (status != 0) {
        throw std::runtime_error("this failed: " + command);
    }
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return {clock.count(), seconds(used.ru_utime) + seconds(used.ru_stime)};
}

Folder::Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "rotconv-bench-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
        throw std::runtime_error("no temporary folder can be made");
    }
    path_ = name;
}

Folder::~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

Attitudes::Components Attitudes::next() {
    const Components q{normal_(engine_), normal_(engine_), normal_(engine_), normal_(engine_)};
    const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return {q.w / norm, q.x / norm, q.y / norm, q.z / norm};
}

std::string Attitudes::next_row() {
    const auto [w, x, y, z] = next();
    return fmt::format("{:.17g},{:.17g},{:.17g},{:.17g}", w, x, y, z);
}
