#pragma once
// A case of the oracle: shaders of a dialect and a small scene around them.

#include <string>
#include <vector>

#include "compatibility_picture.h"

namespace glibra::oracle {

/// The stages of a program. An empty text means that there is no such stage.
struct Stages {
    std::string vertex{};
    std::string tessControl{};
    std::string tessEvaluation{};
    std::string geometry{};
    std::string fragment{};
};

/// The scene consists of a square window, Perspective 90, a LookAt (kView), `before`, the stage files, the
/// Program with `tags`, and `draws`. With a field of view of 90 degrees the projection scales x and y by
/// exactly 1. Both sides therefore get the same clip coordinates bit for bit, no matter in which order
/// matrices are multiplied, and cover the same pixels.
struct Case {
    std::string name;
    Stages stages{};
    std::string before{};  ///< statements before the stage files: textures, topologies
    std::string tags{};    ///< uniforms of the Program
    std::string draws = "Rotate 35 1 2 0\nTorus 1.1 .5 24 36\n";
    Stages show{};  ///< a second program, which shows textures that the first has rendered
    std::string showTags{};
    std::string
        showDraws{};  ///< statements for it; `draws` then ends with those that lead back to the window
    WrittenOutputs written{};
    /// Stages that the oracle compiles in place of those above, where Mesa's compiler refuses the dialect.
    /// They are written by hand in a dialect that Mesa knows. A comment at each says why.
    Stages byHand{};
};

/// A vertex stage with a position and a varying for the fragment stage to compute with.
inline constexpr const char* kPointVertex = R"glsl(
varying vec3 vPoint;
void main() {
    vPoint = gl_Vertex.xyz;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)glsl";

/// The same, with a texture coordinate.
inline constexpr const char* kPointCoordinateVertex = R"glsl(
varying vec3 vPoint;
varying vec2 vST;
void main() {
    vPoint = gl_Vertex.xyz;
    vST = gl_MultiTexCoord0.st;
    gl_Position = ftransform();
}
)glsl";

/// The cases by the version that the shaders declare.
std::vector<Case> casesOf110();
std::vector<Case> casesOf110State();
std::vector<Case> casesOf110Textures();
std::vector<Case> casesOf120();
std::vector<Case> casesOf130();
std::vector<Case> casesOfGeometryShader4();
std::vector<Case> casesOf150();
std::vector<Case> casesOf330();
std::vector<Case> casesOf400();
std::vector<Case> casesOfNames();
std::vector<Case> casesOfMacros();
std::vector<Case> casesOfStructures();
std::vector<Case> casesOfIdioms();
std::vector<Case> casesOfCollisions();
std::vector<Case> casesOfExtensions();

}  // namespace glibra::oracle
