// Fields and what parts them.

#include <string>
#include <vector>

#include "catch.hpp"
#include "stream/delimiter.hpp"

using rotconv::stream::Delimiter;

namespace {

using Fields = std::vector<std::string_view>;

Fields fields_of(const Delimiter& delimiter, std::string_view row) {
    Fields fields;
    CHECK(delimiter.split(row, fields));
    return fields;
}

const Delimiter comma = Delimiter::character(',');

} // namespace

// Catches a wrong order of preference, a delimiter found inside quotes.
TEST_CASE("the delimiter is comma else tab else semicolon else blanks") {
    CHECK(Delimiter::of_row("1\t2;3,4 5").text() == ',');
    CHECK(Delimiter::of_row("1;2\t3 4").text() == '\t');
    CHECK(Delimiter::of_row("1;2 3").text() == ';');
    CHECK(Delimiter::of_row("1 2").is_blanks());
    CHECK(Delimiter::of_row("1").is_blanks());
    CHECK(Delimiter::of_row("\"a,b\";1").text() == ';');
    CHECK(Delimiter::of_row("5\" disk, 3").text() == ',');
}

// Catches an inch sign that hides the delimiters behind it.
TEST_CASE("a quote hides delimiters only where a field begins with it") {
    CHECK(Delimiter::of_row("5\" pipe,1,0,0,0,6\" pipe").text() == ',');
    CHECK(Delimiter::of_row("1\t\"a,b\"\t2").text() == '\t');
    CHECK(Delimiter::of_row("\"a \"\"b\"\", c\";1").text() == ';');
    CHECK(Delimiter::of_row("\"left open,1").text() == ',');
}

// Catches a named delimiter that is another, one that would cut numbers.
TEST_CASE("delimiters by name and by character") {
    CHECK(Delimiter::parse("comma")->text() == ',');
    CHECK(Delimiter::parse("tab")->text() == '\t');
    CHECK(Delimiter::parse("semicolon")->text() == ';');
    CHECK(Delimiter::parse("blank")->is_blanks());
    CHECK(Delimiter::parse("\\t")->text() == '\t');
    CHECK(Delimiter::parse("|")->text() == '|');
    CHECK(Delimiter::parse("x")->text() == 'x');
    CHECK(Delimiter::parse(" ")->is_blanks());
    for (const std::string text : {"", "ab", "e", "n", "1", "-", "+", ".", "\"", "\n", "\xC3\xA4", "#"}) {
        INFO(text);
        CHECK_FALSE(Delimiter::parse(text));
    }
}

// Catches a field lost at an end, quotes that are not seen.
TEST_CASE("rows are split after RFC 4180") {
    CHECK(fields_of(comma, "a,b,c") == Fields{"a", "b", "c"});
    CHECK(fields_of(comma, ",a,") == Fields{"", "a", ""});
    CHECK(fields_of(comma, "\"a,b\",c") == Fields{"\"a,b\"", "c"});
    CHECK(fields_of(comma, "\"a\"\"b,\",c") == Fields{"\"a\"\"b,\"", "c"});
    CHECK(fields_of(comma, "a\"b,c\"d") == Fields{"a\"b", "c\"d"});
    CHECK(fields_of(Delimiter::blanks(), "  a \t b  ") == Fields{"a", "b"});
    CHECK(fields_of(Delimiter::blanks(), "\"a b\"") == Fields{"\"a", "b\""});
    Fields fields;
    CHECK_FALSE(comma.split("a,\"b", fields));
    CHECK_FALSE(comma.split("\"a\"\",b", fields));
}

// Catches quotes or blanks that stay in a name or number.
TEST_CASE("a field's content is free of quotes and blanks around it") {
    CHECK(comma.text_of(" a ") == "a");
    CHECK(comma.text_of("\"1.5\"") == "1.5");
    CHECK(comma.text_of(" \" 1 \" ") == "1");
    CHECK(comma.text_of("\"") == "\"");
    CHECK(comma.text_of("") == "");
    CHECK(Delimiter::blanks().text_of("\"1.5\"") == "\"1.5\""); // where nothing is quoted
}
