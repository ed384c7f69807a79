// What a SPEC may be.

#include <set>
#include <string>

#include "../../src/core/projects.hpp"
#include "accuracy.hpp"
#include "catch.hpp"

using accuracy::spec;
using rotconv::parse_spec;
using rotconv::SpecError;
using What = rotconv::SpecError::What;

namespace {

What fault_of(const std::string& text) {
    const auto parsed = parse_spec(text);
    const auto* error = std::get_if<SpecError>(&parsed);
    REQUIRE(error != nullptr);
    return error->what;
}

} // namespace

// Catches a sequence that is refused, a non-sequence that is taken.
TEST_CASE("there are 24 Euler sequences") {
    std::set<std::string> found;
    const std::string letters = "xyzXYZwW";
    for (const char a : letters) {
        for (const char b : letters) {
            for (const char c : letters) {
                const std::string text{a, b, c};
                const auto sequence = rotconv::EulerSequence::parse(text);
                if (sequence) {
                    found.insert(text);
                    CHECK(sequence->text() == text);
                    CHECK(sequence->intrinsic() == (a < 'a'));
                }
            }
        }
    }
    CHECK(found.size() == 24);
    CHECK(rotconv::EulerSequence::all().size() == 24);
    CHECK_FALSE(rotconv::EulerSequence::parse("ZYX "));
    CHECK_FALSE(rotconv::EulerSequence::parse("ZYx"));
}

// Catches a sign that is lost or counts for another letter, and signs where none belongs.
TEST_CASE("a sequence may have signs") {
    std::set<std::string> found;
    for (const std::string& text : accuracy::signed_sequences()) {
        const auto sequence = rotconv::EulerSequence::parse(text);
        REQUIRE(sequence);
        CHECK(sequence->text() == text);
        CHECK(spec("euler:" + text + ":deg").text() == "euler:" + text + ":deg");
        CHECK(sequence->has_signs() == (text.find('-') != std::string::npos));
        found.insert(text);
    }
    CHECK(found.size() == 192);
    constexpr rotconv::EulerSequence unreal = "Z-Y-X";
    static_assert(unreal.sign(0) == 1.0 && unreal.sign(1) == -1.0 && unreal.sign(2) == -1.0);
    for (const char* wrong : {"-", "--ZYX", "ZYX-", "Z--YX", "Z-YY", "+ZYX", "Z-Y", "-Z-Y-x", "Z Y-X"}) {
        INFO(wrong);
        CHECK_FALSE(rotconv::EulerSequence::parse(wrong));
    }
}

// Catches a name that only one spelling has, and letters of a sequence whose case is lost.
TEST_CASE("names and modifiers are known in any case, with and without - and _") {
    CHECK(spec("Quaternion:XYZW").text() == "quat:xyzw");
    CHECK(spec("AXIS_ANGLE:Deg").text() == "axis-angle:deg");
    CHECK(spec("axisangle").text() == "axis-angle");
    CHECK(spec("RotationVector").text() == "rotvec");
    CHECK(spec("twocolumn:Matlab").text() == "6d:passive");
    CHECK(spec("Euler:zyx").text() == "euler:zyx");
    CHECK(spec("euler:Bunge").text() == "euler:ZXZ");
    CHECK(spec("Universal_Robots").text() == "rotvec");
    CHECK(spec("tum").text() == "quat:xyzw");
    CHECK(fault_of("eulerzyx") == What::unknown_name);
    CHECK(fault_of("euler:ZyX") == What::unknown_sequence);
}

// Catches digits that negate, and those that are letters in lower case.
TEST_CASE("the axes of a sequence may be digits") {
    CHECK(spec("euler:321").text() == "euler:ZYX");
    CHECK(spec("euler321:deg").text() == "euler:ZYX:deg");
    CHECK(spec("euler:3-1-3").text() == "euler:ZXZ");
    CHECK(spec("Euler_3-2-1").text() == "euler:ZYX");
    for (const char* wrong : {"-3-1-3", "3--1-3", "31", "3133", "311", "3Y1", "343", "3-1-3-"}) {
        INFO(wrong);
        CHECK_FALSE(rotconv::EulerSequence::parse(wrong));
    }
}

// Catches a sequence that a preset overrides, or gives to what has none.
TEST_CASE("a preset may stand in the place of the sequence that it has") {
    CHECK(spec("euler:bunge").text() == "euler:ZXZ");
    CHECK(spec("euler:bunge:deg:positive").text() == "euler:ZXZ:deg:positive");
    CHECK(spec("euler:opk:deg").text() == "euler:XYZ:deg");
    CHECK(spec("euler:ZYX:opk").text() == "euler:ZYX");
    CHECK(spec("euler:bunge:bunge").text() == "euler:ZXZ");
    CHECK(spec("rpy:bunge").text() == "rpy");
    CHECK(fault_of("euler:bunge:opk") == What::second_preset);
    CHECK(fault_of("euler:bunge:spice") == What::second_preset);
    CHECK(fault_of("euler:px4") == What::unknown_sequence);
}

// Catches modifiers that are counted instead of set.
TEST_CASE("modifiers are a set") {
    CHECK(spec("dcm:passive:passive").passive);
    CHECK(spec("dcm:matlab:passive").passive);
    CHECK(spec("quat:scipy:xyzw").scalar_last);
    CHECK(spec("dcm:col:passive").column_major);
    CHECK_FALSE(spec("euler:ZYX:spice").passive);
    CHECK(spec("rotvec:deg:bunge").passive);
    CHECK_FALSE(spec("rotvec:stuelpnagel").passive);
    CHECK(spec("quat:tum:tum").scalar_last);
}

// Catches a wrong word that is taken for something, or explained as something else.
TEST_CASE("a text that is no SPEC says why") {
    CHECK(fault_of("") == What::unknown_name);
    CHECK(fault_of("quat ") == What::unknown_name);
    CHECK(fault_of("euler") == What::no_sequence);
    CHECK(fault_of("euler:") == What::unknown_sequence);
    CHECK(fault_of("euler:XXY") == What::unknown_sequence);
    CHECK(fault_of("euler:deg:ZYX") == What::unknown_sequence);
    CHECK(fault_of("quat:") == What::unknown_modifier);
    CHECK(fault_of("quat::xyzw") == What::unknown_modifier);
    CHECK(fault_of("quat:xyz") == What::unknown_modifier);
    CHECK(fault_of("quat:deg") == What::meaningless_modifier);
    CHECK(fault_of("6d:col") == What::meaningless_modifier);
    CHECK(fault_of("mrp:xyzw") == What::meaningless_modifier);
    CHECK(fault_of("quat:ros:tum") == What::second_preset);
    CHECK(fault_of("quat:wxyz:passive:xyzw") == What::two_orders);
    CHECK(fault_of("quat:tum:wxyz") == What::two_orders);
}

// Catches a preset that a representation refuses.
TEST_CASE("every preset is legal on every representation") {
    for (const auto id : rotconv::all_representations) {
        const auto& entry = rotconv::representation(id);
        for (const auto& preset : rotconv::presets()) {
            const std::string name =
                entry.name == rotconv::RepresentationId::euler ? "euler:zxz" : std::string(entry.text);
            CHECK_NOTHROW(spec(name + ":" + std::string(preset.text)));
        }
    }
}
