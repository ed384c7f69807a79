// Lists of columns.

#include <string>
#include <vector>

#include "catch.hpp"
#include "stream/column_list.hpp"

using namespace rotconv::stream;
using What = ColumnError::What;

namespace {

using Positions = std::vector<std::size_t>;

What fault_of(const std::string& list, std::size_t count) {
    const auto parsed = ColumnList::parse(list, count);
    INFO(list);
    REQUIRE(std::holds_alternative<ColumnError>(parsed));
    return std::get<ColumnError>(parsed).what;
}

Positions positions(const std::string& list, std::size_t count, const std::vector<std::string>& header = {}) {
    const auto parsed = std::get<ColumnList>(ColumnList::parse(list, count));
    return header.empty() ? parsed.positions() : std::get<Positions>(parsed.positions(header));
}

} // namespace

// Catches an order that is not that of the list, an index that starts at 0.
TEST_CASE("indices and ranges select in the order of the list") {
    CHECK(positions("8,5-7", 4) == Positions{7, 4, 5, 6});
    CHECK(positions(" 1 , 2,3", 3) == Positions{0, 1, 2});
    CHECK(positions("3-3,1,2", 3) == Positions{2, 0, 1});
}

// Catches a list that selects something else than n different columns.
TEST_CASE("a list that does not fit is a error") {
    CHECK(fault_of("1-4", 3) == What::wrong_count);
    CHECK(fault_of("a,b", 3) == What::wrong_count);
    CHECK(fault_of("1-4000000", 4) == What::wrong_count);
    CHECK(fault_of("1,2,2", 3) == What::twice);
    CHECK(fault_of("2,1-3", 4) == What::twice);
    CHECK(fault_of("a,b,a", 3) == What::twice);
    CHECK(fault_of("0,1,2", 3) == What::not_an_item);
    CHECK(fault_of("3-1,2", 3) == What::not_an_item);
    CHECK(fault_of("1,,2", 3) == What::not_an_item);
    CHECK(fault_of("99999999999999999999,1,2", 3) == What::not_an_item);
}

// Catches a name that is looked up in a part of a field, or found twice and taken.
TEST_CASE("names match a field or its first word") {
    const std::vector<std::string> header{"timestamp", "q_w []", "q_x", "q_y [1]", "q_y [2]", "q_z", "q_z [3]"};
    CHECK(positions("q_w,q_x,1", 3, header) == Positions{1, 2, 0});
    CHECK(positions("q_z,q_x,q_w", 3, header) == Positions{5, 2, 1});
    CHECK(positions("q_y [2],1,2", 3, header) == Positions{4, 0, 1});
    const auto missing = std::get<ColumnList>(ColumnList::parse("q,1,2", 3));
    CHECK(std::get<ColumnError>(missing.positions(header)).what == What::missing);
    const auto some = std::get<ColumnError>(
        std::get<ColumnList>(ColumnList::parse("a,q_x,b,q_y,1", 5)).positions(header)); // before what is ambiguous
    CHECK(some.lacking == std::vector<std::string>{"a", "b"});
    CHECK(some.present == std::vector<std::string>{"q_x", "q_y"});
    const auto list = std::get<ColumnList>(ColumnList::parse("q_y,1,2", 3));
    CHECK(std::get<ColumnError>(list.positions(header)).what == What::ambiguous);
    const auto twice = std::get<ColumnList>(ColumnList::parse("q_w,2,1", 3));
    CHECK(std::get<ColumnError>(twice.positions(header)).what == What::twice);
}
