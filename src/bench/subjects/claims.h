#pragma once
// Claims that one way of drawing is faster than another: what measures a claim, and the claims by what they
// are about.

#include <functional>
#include <string>
#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {

using Draw = std::function<void()>;  ///< without waiting for the device

inline constexpr const char* kOtherPicture = "the picture of the other way";

/// One claim: a way that is said to be slower, and one that is said to be faster.
struct Claim {
    std::string name;       ///< of the figure: "pf06-length"
    std::string text;       ///< "A built-in function is never slower than the form written by hand"
    std::string work;       ///< what both do: "512 x 512 pixels, 32 times"
    std::string errorName;  ///< of the ways, and what it is measured against
    std::string errorUnit{}, reference{};
    struct Way {
        std::string name;
        Draw draw;
        double error = 0;   ///< against the reference
        double memory = 0;  ///< bytes
    } slower{}, faster{};
    bool mayBeEqual = false;  ///< the claim holds without a difference, too
};

/// Draws both in turn and waits each time.
PairedTiming timedInTurn(Bench& bench, const Draw& slower, const Draw& faster);
/// Measures both ways.
Figure claimFigure(Bench& bench, const Claim& claim);

/// "512 x 512 pixels"
std::string pixelsText(int side);

// Each adds one figure per claim.

/// Functions and statements of fragment shaders.
void addFragmentClaims(std::vector<Figure>& figures, Bench& bench);
/// Textures in place of computations and geometry, and lookups in shadow maps.
void addTextureClaims(std::vector<Figure>& figures, Bench& bench);
/// Strips, geometry and tessellation stages, and culled faces.
void addMeshClaims(std::vector<Figure>& figures, Bench& bench);

}  // namespace glibra::bench
