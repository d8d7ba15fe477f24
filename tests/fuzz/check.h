#pragma once
// Conditions that every fuzzed input must satisfy. A broken one ends the process, as an error of a sanitizer
// does.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace glibra::fuzz {

/// The status with which a broken condition ends the process; 0: as an error of a sanitizer does.
inline int statusOfBroken = 0;

/// Ends the process, so that the fuzzer keeps the input, if `holds` is false.
inline void check(bool holds, std::string_view what) {
    if (holds) return;
    std::fprintf(stderr, "not true: %.*s\n", static_cast<int>(what.size()), what.data());
    if (statusOfBroken != 0) std::_Exit(statusOfBroken);
    std::abort();
}

/// Every message has an id, a text without line ends, and lines and columns that count from 1.
inline void checkMessages(const Diagnostics& diagnostics) {
    for (const Diagnostic& each : diagnostics) {
        check(!each.text.empty(), "a message has a text");
        check(each.place.line >= 1 && each.place.column >= 1, "lines and columns count from 1");
        check(each.text.find('\n') == std::string::npos, "a message is one line");
    }
}

/// The input as text.
inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

}  // namespace glibra::fuzz

/// The entry point of libFuzzer (llvm.org/docs/LibFuzzer.html); driver.cpp calls it too.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
