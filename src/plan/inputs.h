#pragma once
// Finds what feeds the vertex inputs of a program, and the attributes that meshes have for them.

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "plan/program_variant.h"
#include "scene/scene.h"

namespace glibra::plan {

/// What feeds one vertex input.
struct InputSource {
    /// A mesh attribute by its name in geometry; numbers; or a buffer. An attribute that the mesh lacks reads
    /// (0, 0, 0, 1), and the current colour where it is geometry::kColor.
    std::variant<std::string, std::array<double, 4>, scene::BufferView> from;
    bool isPerInstance = false;  ///< of a buffer
    scene::ElementPart part{};   ///< of a buffer
    bool isKnown = true;         ///< false: nothing feeds it but perhaps a list with an attribute of its name
    friend bool operator==(const InputSource&, const InputSource&) = default;
};

/// The sources of all inputs of a program, in the order of ProgramInterface::inputs, for draws with one set
/// of attributes. Inputs read, in this order: what the set gives them by name; what the runtime supplies
/// (language, 6); where names are supplied what they say in books (glsl::wellKnownAttribute); the attribute
/// of a list that has the same name.
std::vector<InputSource> inputSources(const scene::Scene& scene, scene::AttributeSetIndex attributes,
                                      const ProgramInterface& interface);

/// The name of an input or output as the user wrote it.
std::string userNameOf(const ProgramInterface& interface, const std::string& name);

/// The attributes that the mesh of a shape may have, in the order of the constants of geometry.
std::vector<std::string> attributesOf(const scene::Shape& shape);

}  // namespace glibra::plan
