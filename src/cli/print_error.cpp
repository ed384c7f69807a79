#include "print_error.hpp"

#include <unistd.h>

#include "../stream/file.hpp"
#include "../stream/fmt.hpp"

namespace rotconv::cli {

void print_error(std::string_view message) {
    static_cast<void>(stream::File(STDERR_FILENO).write(fmt::format("rotconv: {}\n", message)));
}

} // namespace rotconv::cli
