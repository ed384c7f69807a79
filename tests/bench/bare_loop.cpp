// bare_loop dcm|rotvec|rpy|quat [libraries]: quaternions to matrices or rotation vectors, matrices to roll, pitch and
// yaw in degrees, or these to quaternions, in plain double, from stdin to stdout, with no check, no other field and no
// line counted. Numbers are read and printed as the program does it or, with `libraries`, by fast_float and by
// Dragonbox, with an exponent each.

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include <unistd.h>

#include <Eigen/Geometry>
#include <dragonbox/dragonbox_to_chars.h>
#include <fast_float/fast_float.h>

#include "stream/numbers/number_text.hpp"
#include "stream/numbers/scan_number.hpp"

namespace {

using rotconv::stream::Buffer;

constexpr double degree = std::numbers::pi / 180.0;

/// @return the place after the row
template <bool by_libraries> const char* scan(const char* at, const char* end, std::span<double> numbers) {
    for (double& number : numbers) {
        at = (by_libraries ? fast_float::from_chars(at, end, number).ptr
                           : rotconv::stream::scan_number(at, end, number)) +
             1;
    }
    return at;
}

template <bool by_libraries> void print(Buffer& out, std::span<const double> numbers) {
    if constexpr (by_libraries) {
        std::array<char, 9 * 25> text;
        char* at = text.data();
        for (const double number : numbers) {
            at = jkj::dragonbox::to_chars_n(number, at);
            *at++ = ',';
        }
        *(at - 1) = '\n';
        out.append(text.data(), at);
    } else {
        rotconv::stream::append_numbers(out, numbers, ',', {});
        out.push_back('\n');
    }
}

template <bool by_libraries> void to_dcm(Buffer& out, const double* q) {
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double m[9] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                         2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                         2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    print<by_libraries>(out, m);
}

template <bool by_libraries> void to_rotvec(Buffer& out, const double* q) {
    const Eigen::AngleAxisd turn(Eigen::Quaterniond(q[0], q[1], q[2], q[3]));
    const Eigen::Vector3d rotvec = turn.angle() * turn.axis();
    print<by_libraries>(out, {rotvec.data(), 3});
}

template <bool by_libraries> void to_rpy(Buffer& out, const double* numbers) {
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> m(numbers);
    const Eigen::Vector3d angles = m.eulerAngles(2, 1, 0).reverse() / degree;
    print<by_libraries>(out, {angles.data(), 3});
}

template <bool by_libraries> void to_quat(Buffer& out, const double* rpy) {
    const Eigen::Quaterniond q = Eigen::AngleAxisd(degree * rpy[2], Eigen::Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(degree * rpy[1], Eigen::Vector3d::UnitY()) *
                                 Eigen::AngleAxisd(degree * rpy[0], Eigen::Vector3d::UnitX());
    const double numbers[4] = {q.w(), q.x(), q.y(), q.z()};
    print<by_libraries>(out, numbers);
}

/// A conversion, with either way of printing.
struct Loop {
    std::string_view to;
    std::size_t size; ///< of what is read
    void (*convert[2])(Buffer& out, const double* numbers);
};

constexpr Loop loops[] = {{"dcm", 4, {to_dcm<false>, to_dcm<true>}},
                          {"rotvec", 4, {to_rotvec<false>, to_rotvec<true>}},
                          {"rpy", 9, {to_rpy<false>, to_rpy<true>}},
                          {"quat", 3, {to_quat<false>, to_quat<true>}}};

} // namespace

int main(int argc, char** argv) {
    const auto* const loop = std::ranges::find(loops, argc > 1 ? std::string_view(argv[1]) : "", &Loop::to);
    if (loop == std::end(loops)) {
        return 2;
    }
    const bool by_libraries = argc > 2;
    const auto convert = loop->convert[by_libraries ? 1 : 0];
    const auto scan_row = by_libraries ? scan<true> : scan<false>;
    const std::size_t size = loop->size;
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
            at = scan_row(at, block.data() + end, {numbers, size});
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
