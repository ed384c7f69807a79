#include "inputs.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

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
