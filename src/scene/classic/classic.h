#pragma once
// Private to this room: what the files of classic statements give to others.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "scene/run/state.h"

namespace glibra::scene {

std::span<const CommandAction> viewActions();     // view.cpp
std::span<const CommandAction> drawActions();     // geometry.cpp
std::span<const CommandAction> passActions();     // textures.cpp
std::span<const CommandAction> textureActions();  // textures.cpp
std::span<const CommandAction> programActions();  // programs.cpp

// view.cpp

/// Reports glib-W31 for a PushMatrix without PopMatrix.
void checkStack(Interpreter&);

// passes.cpp

/// Returns the pass into the current target. If there is none, begins it with its implicit clears. Inside
/// Pass it is that pass. Inside Once and Step there is no current target: null, with glib-E25 reported.
Pass* currentPass(Interpreter&, const Command&);
/// The number of the depth buffer that belongs to a list of targets of that size. 0 is the window's.
int depthBufferOf(Interpreter&, const std::vector<int>& key, int width, int height);
/// True unless an earlier pass into the same depth has another order of depths, which is reported as
/// glib-E11 at that place.
bool checkDepthOrder(Interpreter&, const Pass& pass, const Place& at);
/// True if nothing has cleared the part since the beginning of the frame or block. From now on it counts as
/// cleared. The `layers` are those of the level.
bool isFirstUse(Interpreter&, TextureIndex texture, const TargetPart& part, int layers);
/// Makes sure that the window is shown, even if nothing is drawn into it.
void finishPasses(Interpreter&);

// textures.cpp

/// Adds to the bytes of all textures and buffers. False, with glib-E15, if they are too many.
bool chargeTexels(Interpreter&, const Command&, std::uint64_t bytes);
/// A texture from a file; the built-in noise replaces a missing noise file. `dimensions` 0: as the file has.
Texture pictureTexture(Interpreter&, const std::string& name, const Place& place, std::size_t dimensions);
void addNoiseTextures(Interpreter&);
/// Sets the sizes of the noise textures, which are known only at the end of the file.
void finishNoise(Interpreter&);

// geometry.cpp

/// Reports glib-E07 for a list without glEnd.
void checkList(Interpreter&);
/// The action of every primitive.
void doPrimitive(Interpreter&, const Command&);
/// The thing that a geometry command draws with the current state. `size` describes it for Verbose; `color`
/// replaces the current colour.
struct Drawing {
    ShapeIndex shape{};
    std::string word;
    std::string size;
    std::optional<glm::dvec4> color;
    CountFrom verticesFrom{};
    BufferView indices{};
    bool drawsAllIndices = false;
};
void draw(Interpreter&, const Command&, const Drawing&);
/// The shape's index; equal shapes share one.
ShapeIndex shareShape(Interpreter&, Shape shape);
/// The index of the set; equal sets share one.
AttributeSetIndex shareAttributes(Interpreter&, AttributeSet set);
/// The number of a draw or dispatch among those of the same line.
DrawId nextDrawId(Interpreter&, const Place& place);
/// The index of the current slot table.
SlotTableIndex currentSlots(Interpreter&);
/// Adds the vertices to those of the scene. Returns false and reports glib-E15 if a limit is exceeded.
bool countVertices(Interpreter&, const Command&, std::uint64_t vertices);
/// Returns the shape with that mesh; equal meshes share one shape.
ShapeIndex shapeOfMesh(Interpreter&, CommandId command, geometry::Mesh mesh);

// programs.cpp

/// The shader that stands in the script after this statement.
FileIndex inlineShader(Interpreter&, const Command&);

}  // namespace glibra::scene
