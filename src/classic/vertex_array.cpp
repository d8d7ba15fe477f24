#include <glibra/classic/vertex_array.h>

#include <algorithm>
#include <utility>

#include "classic/label.h"
#include "classic/vertex_array_state.h"

namespace glibra::classic {

VertexArray::VertexArray() : state_(std::make_unique<State>()) {}
VertexArray::~VertexArray() = default;
VertexArray::VertexArray(VertexArray&&) noexcept = default;
VertexArray& VertexArray::operator=(VertexArray&&) noexcept = default;

void VertexArray::CollapseCommonVertices(bool isOn) {
    if (state_->collapses != isOn) state_->changed();
    state_->collapses = isOn;
}

void VertexArray::SetTol(float tolerance) {
    if (!(tolerance >= 0)) {
        state_->once(fmt::format("SetTol: {} is no tolerance", tolerance));
        return;
    }
    if (state_->tolerance != tolerance) state_->changed();
    state_->tolerance = tolerance;
}

void VertexArray::UseBufferObjects(bool isOn) {
    state_->keepsBuffers = isOn;
}
void VertexArray::SetVerbose(bool isOn) {
    state_->isVerbose = isOn;
}

void VertexArray::NumPatchVertices(int count) {
    if (count < 1 || count > 32)
        state_->once(fmt::format("NumPatchVertices: {} is not between 1 and 32", count));
    else
        state_->patchVertices = count;
}

void VertexArray::Begin(unsigned int topology) {
    if (state_->open) {
        state_->once("glBegin before the glEnd of the last glBegin");
        return;
    }
    if (!isTopology(topology)) {
        state_->once(fmt::format("glBegin: {:#06x} is no topology", topology));
        return;
    }
    state_->open = VertexList{.topology = topology,
                              .patchVertices = state_->patchVertices,
                              .first = state_->given.count(),
                              .count = 0,
                              .restarts = {}};
}

void VertexArray::End() {
    if (!state_->open) {
        state_->once("glEnd without glBegin");
        return;
    }
    state_->open->count = state_->given.count() - state_->open->first;
    state_->given.lists().push_back(std::move(*state_->open));
    state_->open.reset();
    state_->changed();
}

void VertexArray::Vertex(float x, float y, float z, float w, int components) {
    if (state_->open)
        state_->given.add({x, y, z, w}, components);
    else
        state_->once("glVertex outside of glBegin and glEnd has no effect");
}

void VertexArray::Color(float r, float g, float b, float a, int components) {
    state_->given.setCurrent("aColor", {r, g, b, a}, components);
}
void VertexArray::Normal(float x, float y, float z) {
    state_->given.setCurrent("aNormal", {x, y, z, 1}, 3);
}
void VertexArray::TexCoord(float s, float t) {
    state_->given.setCurrent("aTexCoord0", {s, t, 0, 1}, 2);
}

void VertexArray::Attribute(const char* name, float x) {
    state_->given.setCurrent(bookName(name), {x, 0, 0, 1}, 1);
}
void VertexArray::Attribute(const char* name, float x, float y) {
    state_->given.setCurrent(bookName(name), {x, y, 0, 1}, 2);
}
void VertexArray::Attribute(const char* name, float x, float y, float z) {
    state_->given.setCurrent(bookName(name), {x, y, z, 1}, 3);
}
void VertexArray::Attribute(const char* name, float x, float y, float z, float w) {
    state_->given.setCurrent(bookName(name), {x, y, z, w}, 4);
}

void VertexArray::RestartPrimitive() {
    if (state_->open)
        state_->open->restarts.push_back(state_->given.count());
    else
        state_->once("RestartPrimitive outside of glBegin and glEnd has no effect");
}

void VertexArray::Draw() {
    state_->draw("Draw", 1);
}
void VertexArray::DrawInstanced(int count) {
    state_->draw("DrawInstanced", count);
}

void VertexArray::DrawIndirect() {
    if (!state_->prepare("DrawIndirect")) return;
    const Gl& gl = *state_->owner.gl();
    const Restored restored(gl);
    State::Variant* variant = state_->bind("DrawIndirect");
    if (variant == nullptr) return;
    state_->uploadCommands(*variant);
    state_->drawGroups(*variant, [&](std::size_t first, std::size_t number) {
        const GLenum mode = variant->drawn.lists[first].mode;
        if (gl.MultiDrawElementsIndirect != nullptr) {
            gl.MultiDrawElementsIndirect(mode, GL_UNSIGNED_INT, at(first * sizeof(Command)),
                                         static_cast<GLsizei>(number), 0);
            return;
        }
        for (std::size_t i = first; i < first + number; ++i)
            gl.DrawElementsIndirect(mode, GL_UNSIGNED_INT, at(i * sizeof(Command)));
    });
}

void VertexArray::SetInstances(std::size_t list, int count) {
    if (list >= state_->given.lists().size() || count < 0) {
        state_->once(fmt::format("SetInstances: there are {} lists, and {} instances of list {} cannot be",
                                 state_->given.lists().size(), count, list));
        return;
    }
    if (state_->instances.size() <= list) state_->instances.resize(list + 1, 1);
    state_->instances[list] = count;
    for (State::Variant& each : state_->variants) each.areCommandsCurrent = false;
}

unsigned int VertexArray::CommandBuffer() {
    if (!state_->prepare("CommandBuffer")) return 0;
    const Restored restored(*state_->owner.gl());
    State::Variant* variant = state_->bind("CommandBuffer");
    if (variant == nullptr) return 0;
    state_->uploadCommands(*variant);
    return variant->commands;
}

void VertexArray::Clear() {
    state_->given = VertexLists();
    state_->open.reset();
    state_->instances.clear();
    state_->changed();
}

std::size_t VertexArray::NumVertices() const {
    return state_->given.count();
}
std::size_t VertexArray::NumUnique() const {
    return state_->collapsedVertices().count;
}

void VertexArray::Print(std::FILE* file) const {
    Print("", file);
}
void VertexArray::Print(const char* label, std::FILE* file) const {
    const Collapsed& all = state_->collapsedVertices();
    std::string text =
        fmt::format("{} {} vertices, {} unique\n", labelled(label), state_->given.count(), all.count);
    for (std::size_t i = 0; i < all.count; ++i) {
        text += fmt::format("{:6}:", i);
        for (const VertexColumn& column : all.columns) {
            const auto width = static_cast<std::size_t>(column.components);
            text += " " + column.name;
            for (std::size_t c = 0; c < width; ++c)
                text += fmt::format(" {:g}", column.values[i * width + c]);
        }
        text += "\n";
    }
    const DrawnIndices drawn = drawnIndices(state_->given.lists(), all.vertexOf, false);
    for (const DrawnList& list : drawn.lists) {
        text += fmt::format("mode {:#06x}:", list.mode);
        for (std::uint32_t i = 0; i < list.count; ++i) {
            const std::uint32_t index = drawn.indices[list.firstIndex + i];
            text += index == kRestart ? " restart" : fmt::format(" {}", index);
        }
        text += "\n";
    }
    std::fputs(text.c_str(), file);
}

}  // namespace glibra::classic
