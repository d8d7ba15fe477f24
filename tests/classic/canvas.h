#pragma once
// A context that the classes find as that of the calling program, and a framebuffer to read pixels of.

#include <glad/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "gpu/context/context.h"

namespace glibra::classic {

inline constexpr int kSide = 32;

class Canvas : public testing::Test {
  protected:
    using Pixel = std::array<int, 3>;

    void SetUp() override {
        context_ = gpu::openContext();
        ASSERT_TRUE(context_) << context_.message();
        glGenFramebuffers(1, &framebuffer_);
        glGenRenderbuffers(1, &pixels_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glBindRenderbuffer(GL_RENDERBUFFER, pixels_);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kSide, kSide);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels_);
        glViewport(0, 0, kSide, kSide);
        clear();
    }
    void TearDown() override {
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteRenderbuffers(1, &pixels_);
    }

    static void clear() {
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    static Pixel pixel(int x, int y) {
        std::array<GLubyte, 4> read{};
        glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
        return {read[0], read[1], read[2]};
    }
    /// The pixels that are not black.
    static int drawn() {
        std::vector<GLubyte> read(std::size_t{4} * kSide * kSide);
        glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
        int count = 0;
        for (std::size_t i = 0; i < read.size(); i += 4)
            if (read[i] != 0 || read[i + 1] != 0 || read[i + 2] != 0) ++count;
        return count;
    }

    Result<gpu::Context> context_;

  private:
    GLuint framebuffer_ = 0;
    GLuint pixels_ = 0;
};

inline int countIn(const std::string& text, const std::string& part) {
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

}  // namespace glibra::classic
