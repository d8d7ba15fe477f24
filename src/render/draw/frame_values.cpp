// What the shaders of a draw or dispatch read: values of uniforms and inputs, textures, buffers.

#include <algorithm>
#include <ranges>
#include <utility>

#include "glsl/es/additions.h"
#include "gpu/object/texture.h"
#include "gpu/object/uniform.h"
#include "plan/uniform_names.h"
#include "render/draw/frame.h"

namespace glibra::render {

void FrameDrawer::forgetLiterals(plan::PlannedProgramIndex program) {
    ProgramState& state = states_[program];
    state.literalsSet = false;
    state.blocks.clear();
    // Other values may make its loops longer.
    if (const BuiltProgram* built = programs_.find(plan_.programs[program].variant)) {
        device_.secondsPerPixel(built) = 0;
        built->tried.pixels = 0;
    }
}

void FrameDrawer::resetUniforms(plan::PlannedProgramIndex program, const BuiltProgram& built) {
    if (built.initialValues.empty()) return;
    built.piece.reset();
    std::set<std::pair<plan::UniformIndex, int>> given;
    for (const plan::UniformBinding& each : plan_.programs[program].values)
        given.emplace(each.uniform, each.firstElement);
    for (const InitialValue& each : built.initialValues)
        if (!given.contains({each.uniform, each.element}))
            gpu::setUniform(*built.program, at(built.interface.uniforms, each.uniform), each.values,
                            each.element);
}

void FrameDrawer::setLiterals(plan::PlannedProgramIndex program, const BuiltProgram& built) {
    ProgramState& state = states_[program];
    const bool hasBlocks = std::exchange(state.literalsSet, true);
    if (hasBlocks && built.literalsOf == &state) return;
    built.literalsOf = &state;
    resetUniforms(program, built);
    for (const plan::UniformBinding& binding : plan_.programs[program].values) {
        const auto* literal = std::get_if<plan::Literal>(&binding.value);
        const base::ActiveUniform& uniform = at(built.interface.uniforms, binding.uniform);
        if (literal && uniform.block < 0)
            gpu::setUniform(*built.program, uniform, literal->values, binding.firstElement);
    }
    if (!hasBlocks) makeBlocks(state, program, built);
}

void FrameDrawer::makeBlocks(ProgramState& state, plan::PlannedProgramIndex program,
                             const BuiltProgram& built) {
    state.blocks.clear();
    bindings_.forgetBuffers();  // new buffers may get the names of those
    std::vector<std::vector<std::byte>> blocks;
    for (const base::UniformBlock& each : built.interface.blocks)
        blocks.emplace_back(static_cast<std::size_t>(each.bytes));
    for (const plan::UniformBinding& binding : plan_.programs[program].values) {
        const auto* literal = std::get_if<plan::Literal>(&binding.value);
        const base::ActiveUniform& uniform = at(built.interface.uniforms, binding.uniform);
        if (literal && uniform.block >= 0)
            gpu::writeBlockMember(blocks[static_cast<std::size_t>(uniform.block)], uniform, literal->values,
                                  binding.firstElement);
    }
    for (const plan::BlockUse& each : plan_.programs[program].blocks)
        if (each.kind == plan::BlockUse::Kind::uniform) blocks.at(each.index).clear();
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        glUniformBlockBinding(built.program->id(), built.interface.blocks[i].index, static_cast<GLuint>(i));
        gpu::Buffer& values = state.blocks.emplace_back();
        if (blocks[i].empty()) continue;
        if (Result<gpu::Buffer> buffer = gpu::Buffer::create(blocks[i])) values = std::move(*buffer);
    }
    for (std::size_t i = 0; i < built.interface.storageBlocks.size(); ++i)
        glShaderStorageBlockBinding(built.program->id(), built.interface.storageBlocks[i].index,
                                    static_cast<GLuint>(i));
}

void FrameDrawer::setBuiltins(const BuiltProgram& built, const DrawFacts& facts) {
    for (std::size_t i = 0; i < built.interface.uniforms.size(); ++i)
        if (const glsl::BuiltinUniform* row = plan::suppliedBy(built.interface.uniforms[i]))
            gpu::setUniform(*built.program, built.interface.uniforms[i],
                            suppliedValue(row->value, facts, built.interface.uniforms[i].arraySize).span());
}

void FrameDrawer::setSupplied(plan::PlannedProgramIndex program, const BuiltProgram& built,
                              const DrawFacts& facts) {
    for (const plan::UniformBinding& binding : plan_.programs[program].values) {
        const auto* supplied = std::get_if<plan::Supplied>(&binding.value);
        if (!supplied) continue;
        const base::ActiveUniform& uniform = at(built.interface.uniforms, binding.uniform);
        gpu::setUniform(*built.program, uniform,
                        suppliedValue(supplied->value, facts, uniform.arraySize).span());
    }
}

Diagnostics FrameDrawer::setConstantInputs(const plan::PlannedDraw& planned, const BuiltProgram& built,
                                           const glm::dvec4& color) {
    const DeviceMesh& mesh = *device_.meshes().onDevice(plan_, planned.mesh);
    const glsl::ExpandedGeometry& expanded = built.interface.facts.expanded;
    const std::vector<plan::InputSource>& sources = device_.inputSources(plan_, planned.inputs, built);
    std::vector<FetchedInputs::Source> fetched;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const base::ActiveInput& input = built.interface.inputs[i];
        const bool isFetched = i + expanded.fetched.size() >= sources.size();
        if (input.location < 0 && !isFetched) continue;
        std::array<double, 4> value{0, 0, 0, 1};
        bool isKnown = true;
        if (const auto* name = std::get_if<std::string>(&sources[i].from)) {
            const auto own = std::ranges::find(mesh.attributes, *name, &DeviceMesh::Attribute::name);
            if (own != mesh.attributes.end()) {
                if (isFetched) fetched.emplace_back(&*own);
                continue;
            }
            if (*name == geometry::kColor) value = {color.r, color.g, color.b, color.a};
        } else if (const auto* numbers = std::get_if<std::array<double, 4>>(&sources[i].from)) {
            value = *numbers;
        } else {
            isKnown = false;
        }
        if (isFetched)
            fetched.emplace_back(value);
        else if (isKnown)
            for (int corner = 0; corner < std::max(1, expanded.corners); ++corner)
                gpu::setConstantAttribute(static_cast<GLuint>(input.location + corner), input.type, value);
    }
    if (fetched.empty()) return {};
    return fetched_.bind(context_.capabilities(), bindings_, built, planned, mesh, fetched);
}

/// The uniform of glsl/es/additions.h, if the program has it.
static void setBorder(const plan::TextureUse& use, const BuiltProgram& built) {
    const std::string name = glsl::kBorderOf + at(built.interface.uniforms, use.uniform).emittedName;
    const auto border = std::ranges::find(built.interface.uniforms, name, &base::ActiveUniform::emittedName);
    if (border == built.interface.uniforms.end()) return;
    const auto is = [](bool what) { return what ? 1.0 : 0.0; };
    const auto& [filter, wrap, anisotropy, color, compare] = use.sampler;
    const bool isLess = base::farthestDepth(compare) == 1;
    const std::array<double, 8> values{is(wrap[0] == base::Wrap::clampToBorder),
                                       is(wrap[1] == base::Wrap::clampToBorder),
                                       is(isLess),
                                       is(!gpu::isNearest(filter)),
                                       color[0],
                                       color[1],
                                       color[2],
                                       color[3]};
    gpu::setUniform(*built.program, *border, values);
}

bool FrameDrawer::lacksBorders(const plan::PlannedDraw& planned, const BuiltProgram& built) {
    if (!bordersChecked_.insert(&planned).second) return false;
    return std::ranges::any_of(planned.textures, [&](const plan::TextureUse& use) {
        const std::string name = glsl::kBorderOf + at(built.interface.uniforms, use.uniform).emittedName;
        return std::ranges::find(use.sampler.wrap, base::Wrap::clampToBorder) != use.sampler.wrap.end() &&
               std::ranges::find(built.interface.uniforms, name, &base::ActiveUniform::emittedName) ==
                   built.interface.uniforms.end();
    });
}

void FrameDrawer::bindTextures(const std::vector<plan::TextureUse>& textures, const BuiltProgram& built) {
    // The units are in rising order. Below GL 4.3 binding a part of a texture may replace what is on unit 0,
    // so that one comes last.
    for (const auto& use : std::ranges::reverse_view(textures)) {
        device_.bind(use, bindings_);
        const std::array<double, 1> unit{static_cast<double>(use.driverUnit)};
        gpu::setUniform(*built.program, at(built.interface.uniforms, use.uniform), unit, use.element);
        if (context_.capabilities().isEs) setBorder(use, built);
    }
}

void FrameDrawer::bindBlocks(plan::PlannedProgramIndex program, const BuiltProgram& built) {
    if (built.record) bindings_.bindBase(*built.record, GL_SHADER_STORAGE_BUFFER, built.recordBinding);
    const std::vector<gpu::Buffer>& blocks = states_[program].blocks;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        if (blocks[i].size() > 0) bindings_.bindBase(blocks[i], GL_UNIFORM_BUFFER, static_cast<GLuint>(i));
    for (const plan::BlockUse& each : plan_.programs[program].blocks) {
        const gpu::Buffer* buffer = device_.buffers().buffer(each.buffer);
        if (!buffer) continue;
        const auto index = static_cast<GLuint>(each.index);
        switch (each.kind) {
            case plan::BlockUse::Kind::uniform:
                bindings_.bindBase(*buffer, GL_UNIFORM_BUFFER, index);
                break;
            case plan::BlockUse::Kind::storage:
                bindings_.bindBase(*buffer, GL_SHADER_STORAGE_BUFFER, index);
                break;
            case plan::BlockUse::Kind::counters:
                bindings_.bindBase(
                    *buffer, GL_ATOMIC_COUNTER_BUFFER,
                    static_cast<GLuint>(built.interface.counterBuffers.at(each.index).binding));
                break;
        }
    }
}

}  // namespace glibra::render
