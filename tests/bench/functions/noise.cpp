// Noise textures, against writing as many bytes on all processors into new memory.

#include "noise/noise.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

namespace {

using namespace glibra;

constexpr std::size_t kBytes = std::size_t{4} * 256 * 256 * 256;

void setAll(std::uint8_t* bytes, std::size_t count, int value) {
    const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
    const auto set = [&](std::size_t i) {
        const std::size_t begin = count / threads * i;
        const std::size_t end = i + 1 == threads ? count : begin + count / threads;
        std::memset(bytes + begin, value, end - begin);
    };
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < threads; ++i) others.emplace_back(set, i);
    set(0);
}

void noise3Of256(benchmark::State& state) {
    for (auto _ : state) {
        const auto texels = std::make_unique_for_overwrite<std::uint8_t[]>(kBytes);
        noise::writeNoise3(256, {texels.get(), kBytes});
        benchmark::DoNotOptimize(texels.get());
    }
}

void noise2Of4096(benchmark::State& state) {
    for (auto _ : state) {
        const auto texels = std::make_unique_for_overwrite<std::uint8_t[]>(kBytes);
        noise::writeNoise2(4096, {texels.get(), kBytes});
        benchmark::DoNotOptimize(texels.get());
    }
}

/// The least that the function must do: allocate memory and write it.
void writeNewMemory(benchmark::State& state) {
    for (auto _ : state) {
        const auto bytes = std::make_unique_for_overwrite<std::uint8_t[]>(kBytes);
        setAll(bytes.get(), kBytes, 1);
        benchmark::DoNotOptimize(bytes.get());
    }
}

/// Memory that the process already has: the bandwidth alone.
void writeOwnMemory(benchmark::State& state) {
    const auto bytes = std::make_unique<std::uint8_t[]>(kBytes);
    for (auto _ : state) {
        setAll(bytes.get(), kBytes, 1);
        benchmark::DoNotOptimize(bytes.get());
        benchmark::ClobberMemory();
    }
}

BENCHMARK(noise3Of256)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(noise2Of4096)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(writeNewMemory)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(writeOwnMemory)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
