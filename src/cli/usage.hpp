#pragma once

#include <stdexcept>

namespace rotconv::cli {

/// Thrown while the command line is read, with words for the user.
class Usage : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The same, where a SPEC is not given.
class MissingSpec : public Usage {
    using Usage::Usage;
};

} // namespace rotconv::cli
