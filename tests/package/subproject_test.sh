#!/bin/sh
# subproject_test.sh CMAKE SOURCE PROGRAM: the library alone needs Eigen and Boost alone, by itself and as a part of another
# project, which builds it into a shared library with -ffast-math. Its numbers are still those of PROGRAM.
set -eu
cmake=$1
source=$2
program=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    cat "$work/log"
    echo "FAILED: $*"
    exit 1
}

without_packages=
for package in CLI11 dragonbox FastFloat fmt Threads Catch2 benchmark; do
    without_packages="$without_packages -DCMAKE_DISABLE_FIND_PACKAGE_$package=ON"
done
configure() {
    # shellcheck disable=SC2086 # the words are options
    "$cmake" $without_packages "$@" > "$work/log" 2>&1
}

# What is wanted of them needs the packages: so the test can fail.
! configure -S "$source" -B "$work/program" || fail "the program is configured without its libraries"
! configure -S "$source" -B "$work/tests" -DROTCONV_PROGRAM=OFF -DROTCONV_TESTS=ON || fail "tests are configured without the program"

configure -S "$source" -B "$work/library" -DROTCONV_PROGRAM=OFF || fail "the library needs more than Eigen and Boost"
"$cmake" --build "$work/library" --target help > "$work/log"
grep -q rotconv_core "$work/log" && ! grep -qE 'rotconv_(stream|cli)' "$work/log" || fail "more than the library is built"

cp -r "$source/examples/cpp" "$work/project"
cat > "$work/project/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(outside LANGUAGES CXX)
enable_testing()
add_subdirectory("$source" rotconv)
get_property(targets DIRECTORY "$source" PROPERTY BUILDSYSTEM_TARGETS)
get_property(tests DIRECTORY "$source" PROPERTY TESTS)
list(REMOVE_ITEM targets rotconv_options rotconv_core rotconv_any_processor rotconv_avx2_fma)
if(targets OR tests OR CMAKE_BUILD_TYPE)
  message(FATAL_ERROR "rotconv brings \${targets} \${tests} \${CMAKE_BUILD_TYPE}")
endif()
add_library(turns SHARED turns.cpp)
target_link_libraries(turns PRIVATE rotconv::core)
add_executable(outside main.cpp)
target_link_libraries(outside PRIVATE turns)
END
cat > "$work/project/turns.cpp" <<'END'
#include <rotconv/rotconv.hpp>

static_assert(ROTCONV_VERSION_MAJOR >= 0 && ROTCONV_VERSION_MINOR >= 0 && ROTCONV_VERSION_PATCH >= 0);
const char* version() { return ROTCONV_VERSION; }
void rows() {
    std::vector<double> in(4 * 2000);
    in.resize(std::fread(in.data(), sizeof(double), in.size(), stdin));
    std::vector<double> out(in.size() / 4 * 3);
    std::vector<rotconv::RowReport> reports;
    rotconv::Conversion({}, {.name = rotconv::RepresentationId::rotvec}).run(in, out, reports);
    std::fwrite(out.data(), sizeof(double), out.size(), stdout);
}
END
# The example's program is a function of the shared library here.
sed 's/int main()/void turn()/' "$source/examples/cpp/attitude.cpp" >> "$work/project/turns.cpp"
cat > "$work/project/main.cpp" <<'END'
#include <cstdio>

const char* version();
void turn();
void rows();

int main(int argc, char**) {
    if (argc > 1) {
        rows();
        return 0;
    }
    std::puts(version());
    turn();
}
END
configure -S "$work/project" -B "$work/build" -DCMAKE_CXX_FLAGS=-ffast-math || fail "another project does not take the library in"
"$cmake" --build "$work/build" --parallel 2 > "$work/log" 2>&1 || fail "a shared library does not take the library in"
"$work/build/outside" > "$work/log"
version=$(sed -n 's/^#define ROTCONV_VERSION_[A-Z]* //p' "$source/include/rotconv/version.hpp" | paste -sd .)
[ "$(head -n 1 "$work/log")" = "$version" ] || fail "not version $version"
grep -q '^roll -10 pitch 90 yaw 0$' "$work/log" || fail "the shared library does not turn"
"$program" sample -t quat --rows 2000 --format f64 > "$work/quaternions"
"$program" -f quat -t rotvec --input-format f64 --format f64 "$work/quaternions" > "$work/expected" 2> /dev/null
"$work/build/outside" rows < "$work/quaternions" | cmp - "$work/expected" || fail "with -ffast-math rows have other numbers"
"$cmake" --install "$work/build" --prefix "$work/usr" > "$work/log"
[ ! -e "$work/usr" ] || fail "rotconv is installed with the project that it is a part of"
