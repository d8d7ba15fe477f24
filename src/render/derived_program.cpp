#include "render/derived_program.h"

#include <algorithm>
#include <cstddef>

#include "gpu/uniform.h"

namespace glibra::render {

std::vector<gpu::NamedLocation> inputLocations(const BuiltProgram& of) {
    std::vector<gpu::NamedLocation> locations;
    for (const gpu::ActiveInput& each : of.reflected.inputs)
        if (each.location >= 0) locations.push_back({each.name, static_cast<GLuint>(each.location)});
    return locations;
}

void copyUniforms(const BuiltProgram& from, const gpu::Program& program,
                  const gpu::ProgramInterface& reflected) {
    for (const gpu::ActiveUniform& to : reflected.uniforms)
        for (const gpu::ActiveUniform& each : from.reflected.uniforms) {
            if (each.name != to.name || each.block >= 0 || to.block >= 0) continue;
            for (int element = 0; element < std::min(each.arraySize, to.arraySize); ++element)
                gpu::setUniform(program, to, gpu::getUniform(*from.program, each, element), element);
        }
    for (const gpu::UniformBlock& to : reflected.blocks)
        for (std::size_t i = 0; i < from.reflected.blocks.size(); ++i)
            if (from.reflected.blocks[i].name == to.name)
                glUniformBlockBinding(program.id(), to.index, static_cast<GLuint>(i));
}

}  // namespace glibra::render
