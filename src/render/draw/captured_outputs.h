#pragma once
// What a vertex stage that does the work of others tells of its instances before they are drawn (glsl/es).

#include <glad/gl.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "gpu/object/buffer.h"
#include "render/load/programs.h"

namespace glibra::render {

/// Sets a uniform that the translation added, if the program has it.
void setOwnUniform(const BuiltProgram& built, std::string_view name, double value);

/// Draws lines, or the edges of triangles, as quads: so many vertices in each of so many instances. False: it
/// cannot (LineWidener).
using QuadDrawer = std::function<bool(GLenum mode, int vertices, int instances)>;

class CapturedOutputs {
  public:
    /// The uniform that makes a program tell, 0 otherwise.
    struct Switch {
        const char* uniform;
        double value;
    };
    /// Runs the program and the vertex array that are bound once for each of `count` instances, and reads
    /// the outputs that the program captures, instance after instance. Waits for the device. False if the
    /// device lacks memory, which `problems` then says (gpu-E04).
    bool read(const BuiltProgram& built, const Switch& tells, int count, std::span<std::byte> to,
              Diagnostics& problems);

  private:
    std::optional<gpu::Buffer> room_;
};

}  // namespace glibra::render
