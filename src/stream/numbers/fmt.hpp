#pragma once

#include <fmt/format.h>

// fmt's formatting function is a template that each source would otherwise compile again, in some three seconds.
#if !defined(FMT_HEADER_ONLY) && FMT_VERSION < 100000
extern template void fmt::detail::vformat_to<char>(buffer<char>&, basic_string_view<char>,
                                                   basic_format_args<FMT_BUFFER_CONTEXT(char)>, locale_ref);
#endif
