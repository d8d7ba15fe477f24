#pragma once
// Pictures of scenes for comparison: drawn as usual, and with many samples.

#include <glibra/render.h>
#include <glibra/result.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "gpu/context/context.h"
#include "image/image.h"
#include "render/stats.h"

namespace glibra::bench {

/// The picture at time 0 as RGB bytes.
Result<image::Image> scenePicture(gpu::Context& context, const std::filesystem::path& scene,
                                  const RenderOptions& options);

/// The GPU time of each pass, dispatch and clear of the picture at time 0: of its second drawing, since
/// drivers do more when something is drawn for the first time. Nothing if the driver has no timer.
std::optional<std::vector<render::Stats::GpuTime>> sceneGpuTimes(gpu::Context& context,
                                                                 const std::filesystem::path& scene,
                                                                 const RenderOptions& options);

/// Bytes of the picture: its data on the device, and its pixels with their depth.
double scenePictureBytes(gpu::Context& context, const std::filesystem::path& scene,
                         const RenderOptions& options);

/// The mean of side * side pictures, shifted against each other by equal parts of a pixel (a box filter one
/// pixel wide), as RGB floats. Each sample is first limited to 0..1, as on a screen. Every pass into a
/// texture is shifted by the same parts of its texels, in an order of its own, so that textures are sampled
/// as often as the window.
Result<image::Image> sampledPicture(gpu::Context& context, const std::filesystem::path& scene,
                                    RenderOptions options, int side);

/// The difference of a picture from its reference; both are RGB of equal size.
struct PictureError {
    double rootMeanSquare = 0;  ///< over all components, 0..1
    double differing = 0;       ///< share of the pixels with a component that differs by more than 8/255
    double flip = 0;            ///< mean FLIP, 0..1
};
PictureError pictureError(const image::Image& reference, const image::Image& picture);

}  // namespace glibra::bench
