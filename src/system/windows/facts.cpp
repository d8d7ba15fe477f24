// What Windows says of itself and of the processor.

#include <cpuid.h>

#include <array>

#include "system/places.h"
#include "system/windows/win.h"

#include <winternl.h>

// Not in the headers of MinGW.
extern "C" NTSTATUS NTAPI RtlGetVersion(PRTL_OSVERSIONINFOW);

namespace glibra::system {
namespace {

std::string processorValue(const wchar_t* name) {
    constexpr DWORD kLongest = 256;
    std::array<wchar_t, kLongest> text{};
    DWORD bytes = sizeof text - sizeof(wchar_t);
    if (::RegGetValueW(HKEY_LOCAL_MACHINE, LR"(HARDWARE\DESCRIPTION\System\CentralProcessor\0)", name,
                       RRF_RT_REG_SZ, nullptr, text.data(), &bytes) != ERROR_SUCCESS)
        return {};
    std::string value = narrowOf(text.data());
    while (!value.empty() && value.back() == ' ') value.pop_back();
    return value;
}

/// Instruction sets by their names on Linux: those that change how programs compute.
std::string flags() {
    struct Flag {
        const char* name;
        bool isThere;
    };
    unsigned a = 0, b = 0, c = 0, d = 0, extendedB = 0, extendedC = 0, unused = 0;
    __get_cpuid(1, &a, &b, &c, &d);
    __get_cpuid_count(7, 0, &unused, &extendedB, &extendedC, &unused);
    const Flag all[] = {{"sse2", (d & bit_SSE2) != 0},
                        {"pni", (c & bit_SSE3) != 0},
                        {"ssse3", (c & bit_SSSE3) != 0},
                        {"fma", (c & bit_FMA) != 0},
                        {"sse4_1", (c & bit_SSE4_1) != 0},
                        {"sse4_2", (c & bit_SSE4_2) != 0},
                        {"popcnt", (c & bit_POPCNT) != 0},
                        {"avx", (c & bit_AVX) != 0},
                        {"f16c", (c & bit_F16C) != 0},
                        {"bmi1", (extendedB & bit_BMI) != 0},
                        {"avx2", (extendedB & bit_AVX2) != 0},
                        {"bmi2", (extendedB & bit_BMI2) != 0},
                        {"avx512f", (extendedB & bit_AVX512F) != 0},
                        {"avx512dq", (extendedB & bit_AVX512DQ) != 0},
                        {"avx512cd", (extendedB & bit_AVX512CD) != 0},
                        {"avx512bw", (extendedB & bit_AVX512BW) != 0},
                        {"avx512vl", (extendedB & bit_AVX512VL) != 0}};
    std::string names;
    for (const auto& [name, isThere] : all)
        if (isThere) names += (names.empty() ? "" : " ") + std::string(name);
    return names;
}

}  // namespace

std::string systemName() {
    RTL_OSVERSIONINFOW version{};
    version.dwOSVersionInfoSize = sizeof version;
    if (::RtlGetVersion(&version) < 0) return {};
    SYSTEM_INFO machine{};
    ::GetNativeSystemInfo(&machine);
    const char* kind = machine.wProcessorArchitecture == PROCESSOR_ARCHITECTURE_ARM64 ? "arm64" : "x86_64";
    return "Windows " + std::to_string(version.dwMajorVersion) + "." +
           std::to_string(version.dwMinorVersion) + "." + std::to_string(version.dwBuildNumber) + " " + kind;
}

std::string processorFact(std::span<const std::string_view> names) {
    for (const std::string_view name : names) {
        std::string value;
        if (name == "model name") value = processorValue(L"ProcessorNameString");
        if (name == "vendor_id") value = processorValue(L"VendorIdentifier");
        if (name == "flags") value = flags();
        if (!value.empty()) return value;
    }
    return {};
}

std::string processorModel() {
    return processorValue(L"ProcessorNameString");
}

/// Cards have drivers of their own. Windows draws what has none, and what is far away, by itself.
GraphicsCard graphicsCard(const std::filesystem::path& devices) {
    if (!devices.empty()) return GraphicsCard::none;  // there are no such files
    DISPLAY_DEVICEW found{};
    found.cb = sizeof found;
    for (DWORD i = 0; ::EnumDisplayDevicesW(nullptr, i, &found, 0); ++i)
        if (!std::wstring_view(found.DeviceString).starts_with(L"Microsoft ")) return GraphicsCard::ownDriver;
    return GraphicsCard::none;
}

}  // namespace glibra::system
