// checkOrder: what depends on the order of invocations is named with the statement that makes it.

#include <gtest/gtest.h>

#include <string>

#include "modern_text.h"
#include "render/check/run_checks.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

class OrderCheck : public testing::Test {
  protected:
    void SetUp() override {
        if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    }
    static Diagnostics found(const std::string& scene, bool isStrict = false) {
        const SceneFolder folder(scene);
        RenderOptions options;
        options.strict = isStrict;
        return render::checkOrder(sharedContext(), folder / "scene.glib", options);
    }
    /// A compute stage of 64 invocations in groups of `size`.
    static std::string computing(const std::string& body, int size = 8) {
        return "WindowSize 8 8\nBuffer list int 64\nBuffer count int [0]\nBuffer sum int [0]\nCompute "
               "inline\n"
               "#version 430\nlayout(local_size_x = " +
               std::to_string(size) +
               ") in;\nlayout(std430) buffer List { int list[]; };\n"
               "layout(std430) buffer Count { int count; };\nlayout(std430) buffer Sum { int sum; };\n"
               "void main() { int i = int(gl_GlobalInvocationID.x);\n" +
               body + "\n}\nEndCompute\nProgram Fill  List list Count count Sum sum\nDispatch Fill " +
               std::to_string(64 / size) + "\n";
    }
    /// Shows the buffer's first element.
    static constexpr const char* kShown =
        "Fragment inline\n#version 430\nout vec4 f;\nlayout(std430) readonly buffer List { int list[]; };\n"
        "void main() { f = vec4(float(list[int(gl_FragCoord.x)]) / 64.); }\nEndFragment\n"
        "Program Show  List list\nFill window with Show\n";
};

TEST_F(OrderCheck, NamesTheListThatAtomicsFill) {
    for (const int size : {1, 8, 64}) {
        const Diagnostics all = found(computing("list[atomicAdd(count, 1)] = i;", size) + kShown);
        ASSERT_EQ(all.size(), 1U) << size << text(all);
        EXPECT_EQ(all.front().id, "memory-W07");
        EXPECT_EQ(all.front().place.line, 16) << text(all);
        EXPECT_NE(all.front().text.find("Dispatch: 'list' depends on the order"), std::string::npos)
            << text(all);
        // How many differ depends on the threads of the driver.
        EXPECT_NE(all.front().text.find(" of its 64 values differ"), std::string::npos) << text(all);
        EXPECT_NE(all.front().text.find(" pixels of the picture"), std::string::npos) << text(all);
    }
}

TEST_F(OrderCheck, IsSilentWhereTheOrderDoesNotMatter) {
    for (const char* body :
         {"atomicAdd(sum, i); list[i] = i * i;", "list[i] = int(gl_LocalInvocationIndex + gl_WorkGroupID.x);",
          "list[63 - i] = int(gl_NumWorkGroups.x) + list[63 - i]; atomicMax(count, i);"})
        EXPECT_EQ(text(found(computing(body) + kShown)), "") << body;
}

TEST_F(OrderCheck, IsANoteIfOnlyAnIntermediateListDiffers) {
    const std::string scene = computing("list[atomicAdd(count, 1)] = i; atomicAdd(sum, i);");
    const std::string shown =
        "Fragment inline\n#version 430\nout vec4 f;\nlayout(std430) readonly buffer List { int list[]; };\n"
        "void main() { int s = 0; for (int i = 0; i < 64; ++i) s += list[i]; f = vec4(float(s) / 4000.); }\n"
        "EndFragment\nProgram Show  List list\nFill window with Show\n";
    const Diagnostics note = found(scene + shown, true);
    ASSERT_EQ(note.size(), 1U);
    EXPECT_EQ(note.front().id, "memory-N01");
    // What the scene expects or prints is a result, too.
    const Diagnostics printed = found(scene + shown + "Print list\n");
    ASSERT_EQ(printed.size(), 1U);
    EXPECT_EQ(printed.front().id, "memory-W07") << text(printed);
    const Diagnostics strict = found(scene + shown + "Print list\n", true);
    EXPECT_EQ(strict.front().severity, Severity::error);
}

TEST_F(OrderCheck, CoversFragmentsAndSteps) {
    const std::string fragment =
        "WindowSize 8 8\nBuffer count int [0]\nFragment inline\n#version 430\nout vec4 f;\n"
        "layout(std430) buffer Count { int count; };\n"
        "void main() { f = vec4(float(atomicAdd(count, 1)) / 64.); }\nEndFragment\nProgram P  Count count\n"
        "Fill window with P\n";
    const Diagnostics drawn = found(fragment);
    ASSERT_EQ(drawn.size(), 1U) << text(drawn);
    EXPECT_EQ(drawn.front().id, "memory-W07");
    EXPECT_EQ(drawn.front().place.line, 10) << text(drawn);
    const std::string stepped = computing("list[atomicAdd(count, 1) % 64] += i * count;");
    const std::string dispatch = "Dispatch Fill 8\n";
    const std::string head = stepped.substr(0, stepped.size() - dispatch.size());
    const Diagnostics all = found(head + "Once\n" + dispatch + "EndOnce\n" + kShown);
    ASSERT_EQ(all.size(), 1U) << text(all);
    EXPECT_EQ(all.front().place.line, 17);
}

TEST_F(OrderCheck, SkipsScenesThatStoreNothing) {
    EXPECT_EQ(text(found("WindowSize 8 8\nFragment inline\n#version 430\nout vec4 f;\nvoid main() { f = "
                         "vec4(1.); }\nEndFragment\nProgram P\nFill window with P\n")),
              "");
}

}  // namespace
}  // namespace glibra::test
