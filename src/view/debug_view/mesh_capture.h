#pragma once
// The vertices of a draw before its vertex stage, and after each stage that places vertices, by transform
// feedback of the scene's own stages.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "render/live/live_scene.h"

namespace glibra::view {

struct MeshColumn {
    std::string name;  ///< as the user wrote it: "aVertex", "gl_Position"
    std::string type;  ///< GLSL word
    int components = 1;
    std::size_t first = 0;  ///< of a row's numbers
};

/// The vertices at one place of the pipeline, in the order in which they are drawn.
struct MeshStage {
    std::string
        title;  ///< "inputs", "after the vertex stage", "after tessellation", "after the geometry stage"
    std::vector<MeshColumn> columns;
    std::vector<double> values;  ///< row after row
    std::size_t rows = 0, rowSize = 0;
    std::uint64_t allRows = 0;  ///< that were drawn; more than `rows` if there are too many to show
    int corners = 1;            ///< rows of a primitive: 1 to 3
    int position = -1;          ///< the column of a position; -1: none
    bool isClip = false;        ///< the position is in clip space, otherwise in that of the inputs
    bool isReversed = false;    ///< z of clip space is larger where it is nearer
    std::string problem;        ///< why there are none

    [[nodiscard]] const double* row(std::size_t index) const { return values.data() + index * rowSize; }
};

inline constexpr std::size_t kMostMeshRows = 3 << 16;

/// The stages of a draw of the frame that was drawn last, in a picture of that size at that time. Empty if
/// nothing of it is drawn. Stages that store to memory do so once more for each of the results.
std::vector<MeshStage> captureMesh(gpu::Context& context, render::LiveScene& scene, scene::StepIndex step,
                                   int width, int height, double time);

/// Comma-separated values (RFC 4180), with a line of names: "gl_Position.x" and so on.
std::string csvOf(const MeshStage& stage);

}  // namespace glibra::view
