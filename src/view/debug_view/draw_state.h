#pragma once
// The state of a draw: as text, and the parts of it that can be tried with another value.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/raster_state.h"
#include "plan/frame_plan.h"
#include "render/draw/view_matrices.h"
#include "scene/scene.h"

namespace glibra::view {

struct StateLine {
    std::string name;               ///< "depth test"
    std::string value;              ///< "lequal, writes"; the rows of a matrix as lines
    bool isChanged = false;         ///< differs from the state at the beginning of a pass
    scene::TextureIndex texture{};  ///< that the line is about; none
};

/// `aspect`: width / height of what is drawn into. `view`: of its pass.
std::vector<StateLine> stateOf(const scene::Scene& scene, const plan::FramePlan& plan,
                               const plan::PlannedDraw& draw, const render::ViewMatrices& view,
                               double aspect);

/// The matrix as lines with its rows.
std::string matrixText(const glm::dmat4& matrix);

// The parts of a draw's state that can be tried with another value, as the words of the statement `State`
// (language, 12.6).

/// A key of `State` with its words.
struct StateChoice {
    std::string_view key;
    std::vector<std::string_view> words;
    /// The index of the word that the state has; words.size(): it has none of them.
    std::size_t (*wordOf)(const base::RasterState&);
    /// Gives the state the word of that index.
    void (*choose)(base::RasterState&, std::size_t);
};

/// In the order of the language's table. `blend` and `write` are those of all colour targets.
std::span<const StateChoice> stateChoices();

/// The statement that makes the state `to` of the state `from`, "State depth less  offset 2 4"; empty if
/// these parts are equal.
std::string stateStatement(const base::RasterState& from, const base::RasterState& to);

}  // namespace glibra::view
