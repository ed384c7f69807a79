#pragma once

// The one header of Catch2 2.13, or the one that stands for all of them in version 3.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

#ifdef ROTCONV_SANITIZED
inline constexpr bool is_sanitized = true; // with memory of its own
#else
inline constexpr bool is_sanitized = false;
#endif

/// Of so many cases a tenth under a sanitizer, which looks at memory, not at digits, and takes four times as long.
constexpr int tried(int cases) { return is_sanitized ? cases / 10 : cases; }
