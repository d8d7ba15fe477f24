#pragma once
// Counts of meshes whose programs make more of the vertices than places, such as light. No theorem bounds
// what a program does, so pictures with finer meshes tell.

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "budget/budget.h"
#include "budget/surface_model.h"

namespace glibra::budget {

/// A draw with the numbers that its shape needs.
struct VertexDraw {
    std::size_t pass = 0, step = 0;  ///< indices into Scene::passes and Pass::steps
    const SurfaceModel* model = nullptr;
    std::vector<double> numbers;  ///< complete
    std::array<bool, 2> isFree{};
    plan::PlannedProgramIndex program{};
    Fidelity fidelity = Fidelity::shape;
    double scale = 0;  ///< pixels a model unit
};

struct VertexRequest {
    std::vector<VertexDraw> draws;
    double maxError = 0;  ///< pixels
    /// What changes from the one numbers of shapes to the other.
    std::function<std::optional<ContourShifts>(std::span<const ShapeChoice> from,
                                               std::span<const ShapeChoice> to)>
        shift;
};

/// What pictures tell of what a program makes of its vertices.
struct VertexError {
    double pixels = 0;   ///< by which contours are off beyond what the shapes themselves are
    double colored = 0;  ///< share of the picture whose light is off by more than 8/255
    bool isKept = false;
};

/// "about 0.2 px off, and 3 of 1000 pixels have another colour"
std::string vertexText(const VertexError& error);

/// What became of the draws of one program.
struct VertexResult {
    plan::PlannedProgramIndex program{};
    VertexError error;
};

struct VertexValues {
    std::vector<std::vector<double>> numbers;  ///< by draw of the request
    std::vector<VertexResult> programs;
};

/// Raises the free counts of a program's draws by one factor until contours are within the bound and all but
/// one of 1000 pixels have their colour. The error falls with the square of the counts, so beside half as
/// many again it is five ninths of the whole. Less than a tenth of the pictures' pixels is not told. It ends
/// before that where meshes would become larger than kMostBudgetVertices, or where finer ones do not help:
/// then isKept is false. If no count of a program is free its error alone is told. Nothing if pictures cannot
/// be drawn.
std::optional<VertexValues> vertexValues(const VertexRequest& request);

}  // namespace glibra::budget
