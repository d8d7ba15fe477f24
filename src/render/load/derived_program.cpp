#include "render/load/derived_program.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "gpu/object/uniform.h"
#include "render/load/gl_names.h"

namespace glibra::render {

std::vector<gpu::NamedLocation> inputLocations(const BuiltProgram& of) {
    std::vector<gpu::NamedLocation> locations;
    for (const base::ActiveInput& each : of.interface.inputs)
        if (each.location >= 0) locations.push_back({each.name, static_cast<GLuint>(each.location)});
    return locations;
}

std::optional<gpu::Program> capturingProgram(const gpu::Capabilities& capabilities, const BuiltProgram& of,
                                             const std::vector<glsl::TranslatedStage>& stages,
                                             std::vector<std::string> captured) {
    std::vector<gpu::StageSource> sources;
    for (const glsl::TranslatedStage& each : stages) sources.push_back({glStage(each.stage), each.source});
    return gpu::buildProgram(capabilities, {.stages = sources,
                                            .vertexInputs = inputLocations(of),
                                            .fragmentOutputs = {},
                                            .captured = std::move(captured)})
        .program;
}

void copyUniforms(const BuiltProgram& from, const gpu::Program& program,
                  const base::ActiveResources& reflected) {
    for (const base::ActiveUniform& to : reflected.uniforms)
        for (const base::ActiveUniform& each : from.interface.uniforms) {
            if (each.emittedName != to.emittedName || each.block >= 0 || to.block >= 0) continue;
            for (int element = 0; element < std::min(each.arraySize, to.arraySize); ++element)
                gpu::setUniform(program, to, gpu::getUniform(*from.program, each, element), element);
        }
    for (const base::UniformBlock& to : reflected.blocks)
        for (std::size_t i = 0; i < from.interface.blocks.size(); ++i)
            if (from.interface.blocks[i].name == to.name)
                glUniformBlockBinding(program.id(), to.index, static_cast<GLuint>(i));
    for (const base::StorageBlock& to : reflected.storageBlocks)
        for (std::size_t i = 0; i < from.interface.storageBlocks.size(); ++i)
            if (from.interface.storageBlocks[i].name == to.name)
                glShaderStorageBlockBinding(program.id(), to.index, static_cast<GLuint>(i));
}

}  // namespace glibra::render
