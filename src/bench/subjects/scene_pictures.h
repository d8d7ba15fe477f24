#pragma once
// Pictures of scenes for comparison: drawn as usual, and with many samples; and the scenes that ship with
// glibra.

#include <glibra/render.h>

#include <filesystem>
#include <functional>

#include "bench/core/bench.h"
#include "image/image.h"
#include "render/stats.h"

namespace glibra::bench {

struct ShippedScene {
    std::string name;  ///< "shading/sphere"
    std::filesystem::path path;
    /// "NAME=VALUE" settings that make its tessellation as fine as its sliders allow; empty if it has none,
    /// or if the level is the subject of the picture.
    std::vector<std::string> finest;
};

/// Sorted by name. They are searched in the folders of GLIBRA_PATH, then in the nearest folder with `glib`
/// and `shaders` above the current folder, then above the program. Throws Failed with bench-E05 if there are
/// none.
std::vector<ShippedScene> shippedScenes();

/// The picture at time 0 as RGB bytes.
Result<image::Image> scenePicture(gpu::Context& context, const std::filesystem::path& scene,
                                  const RenderOptions& options);

/// The GPU time of each pass, dispatch and clear of the picture at time 0: of its second drawing, since
/// drivers do more when something is drawn for the first time. Nothing if the driver has no timer.
std::optional<std::vector<render::Stats::GpuTime>> sceneGpuTimes(gpu::Context& context,
                                                                 const std::filesystem::path& scene,
                                                                 const RenderOptions& options);

/// A picture as it is measured.
struct DrawnScene {
    image::Image picture{};
    Timing time{};     ///< of the whole picture, from the text of the scene on
    double bytes = 0;  ///< its data on the device, and its pixels with their depth
};
/// `enough`: as Bench::time() takes it.
DrawnScene drawnScene(Bench& bench, const std::filesystem::path& scene, const RenderOptions& options,
                      double enough = .5);

/// Calls visit(scene) for every `stride`-th shipped scene, and returns sentences about those that cannot be
/// drawn. Throws Failed with bench-E05 if all visits fail.
std::vector<std::string> forEachScene(Bench& bench, std::size_t stride,
                                      const std::function<void(const ShippedScene&)>& visit);

/// The mean of side * side pictures, shifted against each other by equal parts of a pixel (a box filter one
/// pixel wide), as RGB floats. Each sample is first limited to 0..1, as on a screen. Every pass into a
/// texture is shifted by the same parts of its texels, in an order of its own, so that textures are sampled
/// as often as the window.
image::Image sampledPicture(gpu::Context& context, const std::filesystem::path& scene, RenderOptions options,
                            int side);

/// The difference of a picture from its reference; both are RGB of equal size.
struct PictureError {
    double rootMeanSquare = 0;  ///< over all components, 0..1
    double differing = 0;       ///< share of the pixels with a component that differs by more than 8/255
    double flip = 0;            ///< mean FLIP, 0..1
};
PictureError pictureError(const image::Image& reference, const image::Image& picture);

/// The displacement between two pictures in pixels: the smallest radius r, 0 to `most`, such that at least
/// 999 of 1000 pixels of either picture have values that lie, to within 8/255, between the smallest and the
/// largest value of the other within r pixels around the same place. Both are RGB or RGBA bytes of equal
/// size. `most` + 1 if there is no such radius.
int displacement(const image::Image& a, const image::Image& b, int most);

struct SceneSweep {
    std::filesystem::path scene;
    RenderOptions options;                    ///< the time of the picture is one of them
    std::string name;                         ///< of the variable or uniform
    std::vector<double> values;               ///< at least two; the last one is the finest
    std::string curve{};                      ///< its name; empty: that of the scene's file
    const image::Image* reference = nullptr;  ///< null: the picture at the last value
};

/// One figure: the root mean square of the difference from the reference, and the time to draw the picture
/// once more, whole. Of a picture at a time above 0 it contains the steps since 0.
std::vector<Figure> measureSweep(Bench& bench, const SceneSweep& sweep);

}  // namespace glibra::bench
