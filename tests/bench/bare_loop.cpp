// bare_loop dcm|euler|rpy: quaternions to matrices or Euler angles, or matrices to roll, pitch and yaw in degrees by
// Eigen, from stdin to stdout, read and printed by the program's own libraries, with no check, no other field and no
// line counted.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string_view>
#include <vector>

#include <unistd.h>

#include <Eigen/Geometry>

#include "stream/number_text.hpp"
#include "stream/scan_number.hpp"

namespace {

using rotconv::stream::Buffer;

void print(Buffer& out, std::span<const double> numbers) {
    rotconv::stream::append_numbers(out, numbers, ',', {});
    out.push_back('\n');
}

void to_dcm(Buffer& out, const double* q) {
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double m[9] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                         2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                         2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    print(out, m);
}

void to_euler(Buffer& out, const double* q) {
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double angles[3] = {std::atan2(2 * (x * y + w * z), w * w + x * x - y * y - z * z),
                              std::asin(std::clamp(2 * (w * y - x * z), -1.0, 1.0)),
                              std::atan2(2 * (y * z + w * x), w * w - x * x - y * y + z * z)};
    print(out, angles);
}

void to_rpy(Buffer& out, const double* numbers) {
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> m(numbers);
    const Eigen::Vector3d angles = m.eulerAngles(2, 1, 0).reverse() * (180 / std::numbers::pi);
    print(out, {angles.data(), 3});
}

} // namespace

int main(int argc, char** argv) {
    const std::string_view to = argc > 1 ? argv[1] : "dcm";
    const auto convert = to == "rpy" ? to_rpy : to == "euler" ? to_euler : to_dcm;
    const std::size_t size = to == "rpy" ? 9 : 4;
    std::vector<char> block(std::size_t{64} << 10U);
    Buffer out;
    std::size_t held = 0;
    while (true) {
        const auto count = ::read(STDIN_FILENO, block.data() + held, block.size() - held);
        if (count <= 0) {
            return 0;
        }
        const std::size_t filled = held + static_cast<std::size_t>(count);
        const std::size_t end = std::string_view(block.data(), filled).rfind('\n') + 1;
        const char* at = block.data();
        while (at < block.data() + end) {
            double numbers[9];
            for (std::size_t i = 0; i < size; ++i) {
                at = rotconv::stream::scan_number(at, block.data() + end, numbers[i]) + 1;
            }
            convert(out, numbers);
        }
        held = filled - end;
        std::memmove(block.data(), block.data() + end, held);
        if (::write(STDOUT_FILENO, out.data(), out.size()) < 0) {
            return 1;
        }
        out.clear();
    }
}
