#pragma once
// Pictures of scenes for comparison: as anyone draws them, and with many samples.

#include <glibra/render.h>
#include <glibra/result.h>

#include <filesystem>

#include "gpu/context.h"
#include "image/image.h"

namespace glibra::bench {

/// The picture at time 0: RGB, bytes.
Result<image::Image> scenePicture(gpu::Context& context, const std::filesystem::path& scene,
                                  const RenderOptions& options);

/// Bytes that the picture takes: what goes to the device for it, and its pixels with their depth.
double scenePictureBytes(gpu::Context& context, const std::filesystem::path& scene,
                         const RenderOptions& options);

/// The mean of side * side pictures, shifted by equal parts of a pixel against each other (a box filter of
/// one pixel): RGB, floats. Each sample is limited to 0..1 first, as a screen's are. Every pass into a
/// texture is shifted by the same parts of its texels, in an order of its own, so that textures are sampled
/// as often as the window is.
Result<image::Image> sampledPicture(gpu::Context& context, const std::filesystem::path& scene,
                                    RenderOptions options, int side);

/// How far a picture is from the reference; both RGB of one size.
struct PictureError {
    double rootMeanSquare = 0;  ///< over all components, 0..1
    double differing = 0;       ///< share of the pixels with a component off by more than 8/255
    double flip = 0;            ///< mean FLIP, 0..1
};
PictureError pictureError(const image::Image& reference, const image::Image& picture);

}  // namespace glibra::bench
