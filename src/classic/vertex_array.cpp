#include <glibra/classic/vertex_array.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "classic/gl_functions.h"
#include "classic/label.h"
#include "classic/linked_program.h"
#include "classic/vertex_lists.h"
#include "gpu/format/gl_names.h"

namespace glibra::classic {
namespace {

// Private to this room: what a VertexArray holds, and how it comes to the device.

/// What glDrawElementsIndirect reads.
struct Command {
    GLuint count = 0;
    GLuint instances = 1;
    GLuint firstIndex = 0;
    GLint baseVertex = 0;
    GLuint baseInstance = 0;
};

inline const void* at(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);
}

/// Binds what drawing changes as it was before, so that the calling program does not notice.
class Restored {
  public:
    explicit Restored(const Gl& gl)
        : gl_(gl),
          array_(gl.number(GL_VERTEX_ARRAY_BINDING)),
          buffer_(gl.number(GL_ARRAY_BUFFER_BINDING)),
          indirect_(gl.number(GL_DRAW_INDIRECT_BUFFER_BINDING)) {}
    Restored(const Restored&) = delete;
    Restored& operator=(const Restored&) = delete;
    ~Restored() {
        gl_.BindVertexArray(static_cast<GLuint>(array_));
        gl_.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(buffer_));
        gl_.BindBuffer(GL_DRAW_INDIRECT_BUFFER, static_cast<GLuint>(indirect_));
    }

  private:
    const Gl& gl_;
    GLint array_;
    GLint buffer_;
    GLint indirect_;
};

}  // namespace

struct __attribute__((visibility("hidden"))) VertexArray::State {
    /// The indices and commands for programs of one kind: those that tessellate and the others.
    struct Variant {
        DrawnIndices drawn;
        GLuint indices = 0;
        GLuint commands = 0;
        bool isBuilt = false;
        bool areCommandsCurrent = false;
    };

    VertexLists given;
    std::optional<VertexList> open;
    int patchVertices = 3;
    float tolerance = 0;
    bool collapses = false;
    bool keepsBuffers = true;
    bool isVerbose = false;
    std::vector<int> instances;  ///< by list; a list beyond them has one
    std::set<std::string, std::less<>> reported;

    mutable Collapsed vertices;
    mutable bool isCollapsed = false;  ///< `vertices` is that of `given`

    Owner owner;
    GLuint array = 0;
    GLuint buffer = 0;
    bool isUploaded = false;
    std::vector<std::size_t> offsets;  ///< in the buffer, by column
    std::array<Variant, 2> variants;   ///< the second for programs that tessellate
    // The inputs that the vertex array object has pointers for.
    std::uint64_t program = 0;
    std::set<GLuint> enabled;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() { release(); }

    void once(const std::string& text) {
        if (reported.insert(text).second) complainOf("VertexArray", text);
    }

    void changed() {
        isCollapsed = false;
        isUploaded = false;
        program = 0;
        for (Variant& each : variants) {
            each.isBuilt = false;
            each.areCommandsCurrent = false;
        }
    }

    void release() {
        if (array == 0 || !owner.isCurrent()) return;
        const Gl& gl = *owner.gl();
        gl.DeleteVertexArrays(1, &array);
        gl.DeleteBuffers(1, &buffer);
        for (const Variant& each : variants) {
            gl.DeleteBuffers(1, &each.indices);
            gl.DeleteBuffers(1, &each.commands);
        }
    }

    const Collapsed& collapsedVertices() const {
        if (!isCollapsed) vertices = collapses ? collapse(given, tolerance) : uncollapsed(given);
        isCollapsed = true;
        return vertices;
    }

    bool prepare(const char* call);
    void uploadVertices();
    void point(GLuint name, const LinkedProgram* facts);
    Variant& variantFor(bool tessellates);
    void uploadCommands(Variant& variant);
    /// Everything bound for the program in use, and its variant; null, with a message, if nothing can be
    /// drawn.
    Variant* bind(const char* call);
    template <class DrawGroup>
    void drawGroups(const Variant& variant, DrawGroup&& draw) const;
    void draw(const char* call, int count);
};

/// Calls draw(first list, number of lists) for lists of one mode that follow each other.
template <class DrawGroup>
void VertexArray::State::drawGroups(const Variant& variant, DrawGroup&& draw) const {
    const Gl& gl = *owner.gl();
    const std::vector<DrawnList>& lists = variant.drawn.lists;
    for (std::size_t begin = 0; begin < lists.size();) {
        std::size_t end = begin;
        while (end < lists.size() && lists[end].mode == lists[begin].mode &&
               lists[end].hasRestarts == lists[begin].hasRestarts &&
               lists[end].patchVertices == lists[begin].patchVertices)
            ++end;
        const bool restarts = lists[begin].hasRestarts && gl.IsEnabled(GL_PRIMITIVE_RESTART) == GL_FALSE;
        if (lists[begin].hasRestarts) gl.PrimitiveRestartIndex(kRestart);
        if (restarts) gl.Enable(GL_PRIMITIVE_RESTART);
        if (lists[begin].mode == GL_PATCHES)
            gl.PatchParameteri(GL_PATCH_VERTICES, lists[begin].patchVertices);
        draw(begin, end - begin);
        if (restarts) gl.Disable(GL_PRIMITIVE_RESTART);
        begin = end;
    }
}

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
