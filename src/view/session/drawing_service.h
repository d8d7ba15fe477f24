#pragma once
// The other side of DrawingProcess: what it is asked for, and the process that draws it.

#include <glibra/render.h>

#include <string>

#include "view/scene/live_scene.h"

namespace glibra::view {

/// What a frame of a live scene depends on, besides the scene's files.
struct DrawnState {
    std::filesystem::path scene;
    std::uint64_t loading = 0;  ///< another number: the scene is loaded again
    RenderOptions options;      ///< of loading: view policy, library roots, shim, texts
    std::vector<Knob> knobs;    ///< title, tag and current values
    ViewState view;
    std::string camera;
    double time = 0;
    bool axes = false, wireframe = false;
    double mouseX = .5, mouseY = .5;
    bool isMouseDown = false;
    bool watchesLoops = false;  ///< LiveScene::watchLoops() comes first
    int width = 1, height = 1, samples = 1;
};

/// As JSON, which serveDrawing() takes.
std::string orderText(const DrawnState& state);

/// The work of the process: draws what the messages of the socket ask for into the memory, until the socket
/// is closed. Returns the exit status.
int serveDrawing();

}  // namespace glibra::view
