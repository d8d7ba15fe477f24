#pragma once
// One context for all tests of a suite, and helpers from a shader to pixels.

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"
#include "gpu/object/readback.h"
#include "gpu/object/uniform.h"

namespace glibra::gpu::test {

/// One message per line.
std::string text(const Diagnostics& diagnostics);

using Rgba = std::array<float, 4>;

/// Reads colour `index` as floats, top row first.
std::vector<Rgba> pixels(const Context& context, const Target& target, int index = 0);

/// A vertex shader that covers everything with one triangle, without vertex data.
extern const char* const kCoverAll;

class GpuTest : public testing::Test {
  protected:
    static void SetUpTestSuite();
    static void TearDownTestSuite();
    void SetUp() override;
    /// Fails the test if it leaves a GL error unchecked.
    void TearDown() override;

    static Context& context() { return *opened; }
    static const Capabilities& driver() { return opened->capabilities(); }

    /// Builds a program; fails the test if it does not link.
    static std::optional<Program> build(std::string_view vertex, std::string_view fragment);
    /// Runs a fragment stage for every pixel of a new RGBA32F target of that size and reads back its `out
    /// vec4 fColor`.
    static std::vector<Rgba> shade(const Program& program, int width = 1, int height = 1);

  private:
    static std::unique_ptr<Context> opened;
};

}  // namespace glibra::gpu::test
