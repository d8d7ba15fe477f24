#pragma once
// Reads textures and buffers of a scene from the device as numbers.

#include <glibra/result.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "render/conductor.h"
#include "scene/conditions.h"
#include "scene/scene.h"

namespace glibra::render {

// What a picture, a texture or a buffer holds, as numbers.

/// Texels in rows from bottom to top, like gl_FragCoord, and layers after one another; or the elements of a
/// buffer, one per column.
struct Content {
    std::string name;  ///< for messages: "window", "life", "glow.level(2)"
    int width = 0, height = 1, depth = 1;
    int components = 4;
    double step = 0;  ///< the distance of neighbouring values of a normalised format; 0: exact values
    std::vector<double> values;
    bool isCube = false;       ///< the layers are faces
    bool isOfDoubles = false;  ///< the values are doubles, not floats or integers
    bool isBuffer = false;
    std::vector<plan::BufferColumn> members{};  ///< of an element of a buffer
    std::vector<plan::NumberKind> kinds{};      ///< of the numbers of an element
    bool hasRows = false;                       ///< of a part: the whole has several rows
    int left = 0, bottom = 0;                   ///< of a part: where it begins in the whole
    std::vector<std::size_t> picked{};          ///< of a part: the components of the whole

    [[nodiscard]] std::size_t size() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
               static_cast<std::size_t>(depth);
    }
    /// The components of an element, counted from 0.
    [[nodiscard]] std::span<const double> at(std::size_t index) const {
        return std::span(values).subspan(index * static_cast<std::size_t>(components),
                                         static_cast<std::size_t>(components));
    }
};

/// The content of a texture, a part of it, or a buffer. Textures of integers give the integers, depth
/// textures one component. Makes the mipmaps if a level above 0 is read. Reports check-E02 with the reason
/// for what cannot be read.
Result<Content> contentOf(Conductor& conductor, const scene::ObjectView& object);

/// What the objects of a scene hold at one moment, each read from the device once.
class Contents {
  public:
    /// `window` reads the picture.
    Contents(Conductor& conductor, std::function<Result<Content>()> window)
        : conductor_(conductor), window_(std::move(window)) {}

    /// What is selected. Reports check-E02 with the reason for what cannot be read.
    Result<std::shared_ptr<const Content>> of(const scene::Selection& selection) {
        return selected(selection, false);
    }
    /// The number, vector or matrix that a function of conditions gives. Sums are those of Neumaier (1974),
    /// so that their rounding does not grow with the number of values. A value that is not a number makes the
    /// result of its component not a number.
    scene::Measured measured(const scene::Measure& measure);

  private:
    using Whole = std::pair<std::optional<scene::ObjectView>, std::shared_ptr<const Content>>;
    Result<std::shared_ptr<const Content>> wholeOf(const std::optional<scene::ObjectView>& object);
    /// The same in elements of the type that the scene declares, if its block has longer or shorter ones.
    std::shared_ptr<const Content> asDeclared(std::shared_ptr<const Content> whole,
                                              const scene::ObjectView& object) const;
    Result<std::shared_ptr<const Content>> selected(const scene::Selection& selection, bool isAsDeclared);

    Conductor& conductor_;
    std::function<Result<Content>()> window_;
    std::vector<Whole> read_;
};

/// The sum of each component over all texels or elements, as Contents::measured() computes it.
std::vector<double> sumsOf(const Content& content);

/// The content of one level of a texture without samples, in all layers or one; level and layer must exist.
Result<Content> contentOf(const gpu::Texture& texture, int level, std::optional<int> layer);

}  // namespace glibra::render
