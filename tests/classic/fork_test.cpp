// The classes in a process that is forked from one that draws: messages in place of calls that wait for ever.

#include <glibra/classic/classic.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "../forked_process.h"
#include "canvas.h"

namespace glibra::classic {
namespace {

using tests::inChild;

class ClassicFork : public Canvas {};

TEST_F(ClassicFork, DrawsNothingInTheChildAndGoesOnInTheParent) {
    GLSLProgram program;
    ASSERT_TRUE(program.CreateFromText(
        {{"a.vert", "#version 330\nin vec4 aVertex;\nvoid main() { gl_Position = aVertex; }\n"},
         {"a.frag", "#version 330\nuniform float uK;\nout vec4 c;\nvoid main() { c = vec4(uK); }\n"}}));
    VertexArray array;
    array.glBegin(0x0004);  // GL_TRIANGLES
    array.glVertex3f(0, 0, 0);
    array.glVertex3f(1, 0, 0);
    array.glVertex3f(0, 1, 0);
    array.glEnd();
    program.SetUniform("uK", .5F);
    program.Use();
    array.Draw();
    EXPECT_EQ(inChild([&] {
                  testing::internal::CaptureStderr();
                  program.SetUniform("uK", 1.F);
                  program.Use();
                  array.Draw();
                  program.UseFixedFunction();
                  GLSLProgram own;
                  const bool isMade = own.CreateFromText(
                      {{"a.vert", "#version 330\nvoid main() { gl_Position = vec4(0.); }\n"}});
                  {
                      const GLSLProgram gone = std::move(program);
                  }
                  {
                      const VertexArray gone = std::move(array);
                  }
                  const std::string said = testing::internal::GetCapturedStderr();
                  return std::string(isMade ? "made" : "refused") +
                         (said.find("forked") != std::string::npos ? ", and says so" : "");
              }),
              "refused, and says so");
    program.SetUniform("uK", 1.F);
    array.Draw();
    EXPECT_TRUE(program.IsValid());
}

}  // namespace
}  // namespace glibra::classic
