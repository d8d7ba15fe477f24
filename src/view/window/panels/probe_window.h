#pragma once
// The pixel probe: a click on the picture shows what the fragment there has.

#include <cstdint>
#include <optional>

#include "view/debug_view/pixel_probe.h"

namespace glibra::view {

struct Ui;

/// The title of the window and its id.
inline constexpr const char* kProbeWindow = "Probe###pixel probe";

struct ProbeWindow {
    bool isOn = false;
    std::optional<ProbedPixel> pixel;
    std::uint64_t frame = 0;  ///< Session::framesDrawn() of `pixel`
    double time = 0;          ///< seconds, of `pixel`
};

/// Turns the probe on or off.
void toggleProbe(Ui& ui);
/// A check box for it, for the section View.
void probeSwitch(Ui& ui);
/// Probes a pixel of the picture.
void probeAt(Ui& ui, int x, int y);
/// The window with the numbers, and a mark on the picture. The numbers follow the picture while time stands
/// still.
void probeWindow(Ui& ui);

}  // namespace glibra::view
