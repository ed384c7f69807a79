#pragma once

#if __cplusplus < 202002L && !(defined(_MSVC_LANG) && _MSVC_LANG >= 202002L)
#error "rotconv needs C++20: compile with -std=c++20 or later"
#endif

/// The version of rotconv; the build reads it here. Macros, so that users can ask for it with #if.

#define ROTCONV_VERSION_MAJOR 1
#define ROTCONV_VERSION_MINOR 0
#define ROTCONV_VERSION_PATCH 0

/// As a text, "MAJOR.MINOR.PATCH".
#define ROTCONV_VERSION                                                                                                \
    ROTCONV_DETAIL_TEXT(ROTCONV_VERSION_MAJOR)                                                                         \
    "." ROTCONV_DETAIL_TEXT(ROTCONV_VERSION_MINOR) "." ROTCONV_DETAIL_TEXT(ROTCONV_VERSION_PATCH)

#define ROTCONV_DETAIL_TEXT(number) ROTCONV_DETAIL_QUOTE(number)
#define ROTCONV_DETAIL_QUOTE(number) #number
