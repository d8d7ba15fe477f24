#pragma once
// Private to this room: what a VertexArray holds, and how it comes to the device.

#include <fmt/format.h>
#include <glibra/classic/vertex_array.h>

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "classic/gl_functions.h"
#include "classic/linked_program.h"
#include "classic/vertex_lists.h"

namespace glibra::classic {

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

}  // namespace glibra::classic
