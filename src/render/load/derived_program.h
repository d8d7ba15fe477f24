#pragma once
// What a program takes over from the program that it was made from.

#include <optional>
#include <string>
#include <vector>

#include "gpu/object/program.h"
#include "render/load/programs.h"

namespace glibra::render {

/// The locations of its vertex inputs. A program with equal locations can be drawn with the same vertex
/// arrays.
std::vector<gpu::NamedLocation> inputLocations(const BuiltProgram& of);

/// A program of these stages with the same locations of vertex inputs, which captures outputs of the last
/// stage. Nothing if the driver does not link it.
std::optional<gpu::Program> capturingProgram(const gpu::Capabilities& capabilities, const BuiltProgram& of,
                                             const std::vector<glsl::TranslatedStage>& stages,
                                             std::vector<std::string> captured);

/// Gives every uniform, sampler and block of `program` its value in `from`. `program` must be in use, and
/// `reflected` is its interface.
void copyUniforms(const BuiltProgram& from, const gpu::Program& program,
                  const base::ActiveResources& reflected);

}  // namespace glibra::render
