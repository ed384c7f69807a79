// The program on Windows: its arguments in UTF-8, as they stand, where the C library would expand `*`.

#include <string>
#include <vector>

#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX // libstdc++ defines it
#define NOMINMAX
#endif
#include <windows.h>

#include <shellapi.h>

#include "program.hpp"

int main() {
    ::SetConsoleOutputCP(CP_UTF8);
    int count = 0;
    wchar_t** const words = ::CommandLineToArgvW(::GetCommandLineW(), &count);
    std::vector<std::string> texts;
    std::vector<const char*> arguments;
    for (int i = 0; i < count; ++i) {
        const int size = ::WideCharToMultiByte(CP_UTF8, 0, words[i], -1, nullptr, 0, nullptr, nullptr); // with the NUL
        std::string& text = texts.emplace_back(static_cast<std::size_t>(size), '\0');
        ::WideCharToMultiByte(CP_UTF8, 0, words[i], -1, text.data(), size, nullptr, nullptr);
    }
    for (const std::string& text : texts) {
        arguments.push_back(text.c_str());
    }
    arguments.push_back(nullptr);
    return rotconv::cli::run_program(count, arguments.data());
}
