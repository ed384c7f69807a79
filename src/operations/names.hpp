#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <rotconv/spec.hpp>

/// What operations share: the names of columns, and rows with keys.
namespace rotconv::operations {

/// The numbers of a SPEC, as they are written, each followed by the ending.
[[nodiscard]] std::vector<std::string> names_of(const Spec& spec, const std::string& ending = {});
/// An angular velocity.
[[nodiscard]] std::vector<std::string> velocity_names(bool degrees);
[[nodiscard]] std::vector<std::string> joined(std::vector<std::string> names, const std::vector<std::string>& others);

/// Of rows of a key, n numbers, another key and m numbers those without the keys, until the next call.
class KeyRemover {
public:
    std::span<const double> operator()(std::span<const double> rows, std::size_t n, std::size_t m);

private:
    std::vector<double> room_;
};

} // namespace rotconv::operations
