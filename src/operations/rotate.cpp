#include "operations.hpp"

namespace rotconv::operations {

stream::RowNumbers rotation_numbers(const Spec& spec) {
    return {.names = joined(names_of(spec), {"x", "y", "z"}), .attitude = spec};
}

Operation rotate(const VectorRotation& rotation) {
    auto made = std::make_shared<RowsAtOnce>(function_of(rotation), std::vector<std::string>{"x", "y", "z"});
    made->keeps_names = true;
    return made;
}

} // namespace rotconv::operations
