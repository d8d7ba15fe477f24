#include "classic/vertex_array_state.h"

#include <algorithm>
#include <utility>

#include "gpu/format/value_type.h"

namespace glibra::classic {
namespace {

void upload(const Gl& gl, GLenum target, GLuint buffer, const void* data, std::size_t bytes, GLenum usage) {
    gl.BindBuffer(target, buffer);
    gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, usage);
}

}  // namespace

bool VertexArray::State::prepare(const char* call) {
    if (open) {
        once(fmt::format("{} between glBegin and glEnd draws nothing", call));
        return false;
    }
    if (given.count() == 0) return false;
    if (array != 0 && !gpu::isForked()) return true;
    if (!owner.open("VertexArray")) return false;
    const Gl& gl = *owner.gl();
    gl.GenVertexArrays(1, &array);
    gl.GenBuffers(1, &buffer);
    for (Variant& each : variants) {
        gl.GenBuffers(1, &each.indices);
        gl.GenBuffers(1, &each.commands);
    }
    return true;
}

void VertexArray::State::uploadVertices() {
    if (isUploaded && keepsBuffers) return;
    const Gl& gl = *owner.gl();
    const Collapsed& all = collapsedVertices();
    offsets.clear();
    std::size_t bytes = 0;
    for (const VertexColumn& each : all.columns) {
        offsets.push_back(bytes);
        bytes += each.values.size() * sizeof(float);
    }
    upload(gl, GL_ARRAY_BUFFER, buffer, nullptr, bytes, keepsBuffers ? GL_STATIC_DRAW : GL_STREAM_DRAW);
    for (std::size_t i = 0; i < offsets.size(); ++i)
        if (const std::vector<float>& values = all.columns[i].values; !values.empty())
            gl.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(offsets[i]),
                             static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data());
    if (isVerbose && !isUploaded)
        complainOf("VertexArray", fmt::format("{} vertices, {} unique, {} lists", given.count(), all.count,
                                              given.lists().size()));
    isUploaded = true;
}

/// Lets the inputs of a program read the columns of their names. Locations are asked for once per program of
/// GLSLProgram; GL may give the number of a program of others to another one.
void VertexArray::State::point(GLuint name, const LinkedProgram* facts) {
    if (facts != nullptr && facts->serial == program) return;
    const Gl& gl = *owner.gl();
    const Collapsed& all = collapsedVertices();
    const auto locationOf = [&](const VertexColumn& column) -> std::optional<GLuint> {
        if (facts == nullptr) {
            const GLint location = gl.GetAttribLocation(name, column.name.c_str());
            return location < 0 ? std::nullopt : std::optional(static_cast<GLuint>(location));
        }
        const auto found = facts->inputs.find(column.name);
        if (found == facts->inputs.end()) return std::nullopt;
        if (!gpu::valueType(found->second.type).isInteger()) return found->second.location;
        once(fmt::format("'{}' is an integer in the vertex shader; the array has floats", column.name));
        return std::nullopt;
    };
    std::set<GLuint> wanted;
    for (std::size_t i = 0; i < all.columns.size(); ++i) {
        const std::optional<GLuint> location = locationOf(all.columns[i]);
        if (!location) continue;
        gl.VertexAttribPointer(*location, all.columns[i].components, GL_FLOAT, GL_FALSE, 0, at(offsets[i]));
        if (!enabled.contains(*location)) gl.EnableVertexAttribArray(*location);
        wanted.insert(*location);
    }
    for (const GLuint each : enabled)
        if (!wanted.contains(each)) gl.DisableVertexAttribArray(each);
    if (wanted.empty())
        once("the vertex shader reads none of the array's values: aVertex, aNormal, aColor, ...");
    enabled = std::move(wanted);
    program = facts != nullptr ? facts->serial : 0;
}

VertexArray::State::Variant& VertexArray::State::variantFor(bool tessellates) {
    Variant& variant = variants[tessellates ? 1 : 0];
    const Gl& gl = *owner.gl();
    if (!variant.isBuilt) {
        variant.drawn = drawnIndices(given.lists(), collapsedVertices().vertexOf, tessellates);
        upload(gl, GL_ELEMENT_ARRAY_BUFFER, variant.indices, variant.drawn.indices.data(),
               variant.drawn.indices.size() * sizeof(std::uint32_t), GL_STATIC_DRAW);
        variant.isBuilt = true;
    } else {
        gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, variant.indices);
    }
    return variant;
}

void VertexArray::State::uploadCommands(Variant& variant) {
    const Gl& gl = *owner.gl();
    if (variant.areCommandsCurrent) {
        gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, variant.commands);
        return;
    }
    std::vector<Command> commands;
    for (std::size_t i = 0; i < variant.drawn.lists.size(); ++i)
        commands.push_back({.count = variant.drawn.lists[i].count,
                            .instances = i < instances.size() ? static_cast<GLuint>(instances[i]) : 1,
                            .firstIndex = variant.drawn.lists[i].firstIndex});
    upload(gl, GL_DRAW_INDIRECT_BUFFER, variant.commands, commands.data(), commands.size() * sizeof(Command),
           GL_STATIC_DRAW);
    variant.areCommandsCurrent = true;
}

VertexArray::State::Variant* VertexArray::State::bind(const char* call) {
    const Gl& gl = *owner.gl();
    const auto name = static_cast<GLuint>(gl.number(GL_CURRENT_PROGRAM));
    if (name == 0) {
        once(fmt::format("{} without a program in use draws nothing", call));
        return nullptr;
    }
    const std::shared_ptr<const LinkedProgram> facts = linkedProgram(owner.context(), name);
    gl.BindVertexArray(array);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    uploadVertices();
    point(name, facts.get());
    Variant& variant = variantFor(facts != nullptr && facts->hasTessellation);
    const auto& lists = variant.drawn.lists;
    if (facts != nullptr && !facts->hasTessellation &&
        std::ranges::find(lists, GLenum{GL_PATCHES}, &DrawnList::mode) != lists.end()) {
        once(fmt::format("{}: patches need a program with tessellation shaders", call));
        return nullptr;
    }
    return &variant;
}

void VertexArray::State::draw(const char* call, int count) {
    if (count < 1 || !prepare(call)) return;
    const Gl& gl = *owner.gl();
    const Restored restored(gl);
    const Variant* variant = bind(call);
    if (variant == nullptr) return;
    const std::vector<DrawnList>& lists = variant->drawn.lists;
    drawGroups(*variant, [&](std::size_t first, std::size_t number) {
        if (count == 1 && number > 1) {
            std::vector<GLsizei> counts;
            std::vector<const void*> starts;
            for (std::size_t i = first; i < first + number; ++i) {
                counts.push_back(static_cast<GLsizei>(lists[i].count));
                starts.push_back(at(lists[i].firstIndex * sizeof(std::uint32_t)));
            }
            gl.MultiDrawElements(lists[first].mode, counts.data(), GL_UNSIGNED_INT, starts.data(),
                                 static_cast<GLsizei>(number));
            return;
        }
        for (std::size_t i = first; i < first + number; ++i)
            gl.DrawElementsInstanced(lists[i].mode, static_cast<GLsizei>(lists[i].count), GL_UNSIGNED_INT,
                                     at(lists[i].firstIndex * sizeof(std::uint32_t)), count);
    });
}

}  // namespace glibra::classic
