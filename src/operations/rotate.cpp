#include "operations.hpp"

namespace rotconv::operations {

Operation rotate(const VectorRotation& rotation) {
    const std::vector<std::string> vector{"x", "y", "z"};
    const stream::RowNumbers numbers{.names = concatenated(names_of(rotation.from()), vector),
                                     .attitude = rotation.from()};
    auto made = std::make_shared<RowsAtOnce>(function_of(rotation), numbers, vector);
    made->keeps_names = true;
    return made;
}

} // namespace rotconv::operations
