#pragma once
// Chooses counts of meshes whose programs compute more at the vertices than their places, such as light. No
// theorem bounds what a program does, so the error is measured on pictures with finer meshes.

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "budget/budget.h"
#include "budget/surface_model.h"

namespace glibra::budget {

/// A draw with the numbers that its shape needs.
struct VertexDraw {
    std::size_t pass = 0, step = 0;  ///< indices into Scene::passes and Pass::steps
    const SurfaceModel* model = nullptr;
    std::vector<double> numbers;  ///< complete
    std::vector<double> before;   ///< those of the scene, or the defaults
    std::array<bool, 2> isFree{};
    plan::PlannedProgramIndex program{};
    Fidelity fidelity = Fidelity::shape;
    double scale = 0;  ///< pixels per model unit
};

struct VertexRequest {
    std::vector<VertexDraw> draws;
    double maxError = 0;  ///< pixels
    /// Measures the change from one set of shapes to another.
    std::function<std::optional<ContourShifts>(std::span<const ShapeChoice> from,
                                               std::span<const ShapeChoice> to)>
        shift;
};

/// The measured error of the values that a program computes at its vertices.
struct VertexError {
    double pixels = 0;   ///< how far contours are off, beyond the error of the shapes themselves
    double colored = 0;  ///< the share of the picture whose light is off by more than 8/255
    bool isKept = false;
};

/// The result for the draws of one program.
struct VertexResult {
    plan::PlannedProgramIndex program{};
    VertexError error;
};

struct VertexValues {
    std::vector<std::vector<double>> numbers;  ///< by draw of the request
    std::vector<VertexResult> programs;
};

/// Raises the free counts of a program's draws by one factor until contours are within the bound and all but
/// one of 1000 pixels have their colour. The error falls with the square of the counts, so the difference to
/// a picture with half as many again is five ninths of it. Counts along straight lines are compared with at
/// least those of the scene, because a program may show what repeats along them, and become those if they do
/// not keep the bound. Errors below a tenth of a pixel of the small pictures are not detected. The search
/// ends early, with isKept false, if meshes would become larger than kMostBudgetVertices or if finer ones do
/// not help. If no count of a program is free, only its error is measured. Returns nothing if pictures cannot
/// be drawn.
std::optional<VertexValues> vertexValues(const VertexRequest& request);

}  // namespace glibra::budget
