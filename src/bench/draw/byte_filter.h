#pragma once
// llvmpipe filters textures of bytes with eight-bit arithmetic unless it is told otherwise before it is
// loaded, so that the two ways are compared in two processes.

#include <glibra/result.h>

#include <optional>
#include <string>
#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {

/// Points as text and back; every double survives.
std::string pointsToText(const std::vector<Point>& points);
std::optional<std::vector<Point>> pointsFromText(const std::string& text);

/// Opens a context that filters bytes in bytes, in a process that has none yet, and gives what `measure`
/// finds there, or an empty text. `request`: the driver's word, then " quick" for a quick run.
std::string measureWithByteFilter(const std::string& request,
                                  Result<std::vector<Point>> (*measure)(const Bench&,
                                                                        const gpu::Capabilities&));
/// The request for this bench.
std::string byteFilterRequest(Bench& bench, const gpu::Context& context);

/// What Measure finds in a process apart whose driver filters bytes in bytes; nothing on drivers other than
/// llvmpipe, or if that process fails.
template <auto Measure>
std::optional<std::vector<Point>> withByteFilter(Bench& bench, const gpu::Context& context) {
    if (context.capabilities().family.find("llvmpipe") == std::string::npos) return std::nullopt;
    const std::optional<std::string> answer =
        bench.apart().run([](const std::string& request) { return measureWithByteFilter(request, Measure); },
                          byteFilterRequest(bench, context));
    return answer ? pointsFromText(*answer) : std::nullopt;
}

}  // namespace glibra::bench
