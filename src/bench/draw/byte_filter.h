#pragma once
// llvmpipe filters byte textures with eight-bit arithmetic unless an environment variable is set before it
// loads. So comparing the two takes two processes.

#include <glibra/result.h>

#include <optional>
#include <string>
#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {

inline constexpr double kByte = 255;  ///< errors of pictures are in steps of a byte

/// Points as text and back without loss.
std::string pointsToText(const std::vector<Point>& points);
std::optional<std::vector<Point>> pointsFromText(const std::string& text);

/// Opens a context that filters bytes with byte arithmetic, in a process that has no context yet, and returns
/// the result of `measure` as text, or an empty text. `request` is the name of the driver, followed by "
/// quick" for a quick run.
std::string measureWithByteFilter(const std::string& request,
                                  Result<std::vector<Point>> (*measure)(const Bench&,
                                                                        const gpu::Capabilities&));
/// The request for a process with the settings of `bench`.
std::string byteFilterRequest(Bench& bench, const gpu::Context& context);

/// The result of Measure in a separate process whose driver filters bytes with byte arithmetic; nothing on
/// drivers other than llvmpipe, or if that process fails.
template <auto Measure>
std::optional<std::vector<Point>> withByteFilter(Bench& bench, const gpu::Context& context) {
    if (context.capabilities().family.find("llvmpipe") == std::string::npos) return std::nullopt;
    const std::optional<std::string> answer =
        bench.apart().run([](const std::string& request) { return measureWithByteFilter(request, Measure); },
                          byteFilterRequest(bench, context));
    return answer ? pointsFromText(*answer) : std::nullopt;
}

}  // namespace glibra::bench
