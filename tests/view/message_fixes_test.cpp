// What a click does about a message.

#include <algorithm>

#include "scene_folder.h"
#include "view/edit/message_fixes.h"

namespace glibra::test {
namespace {

using view::MessageFix;
using view::Session;

std::vector<MessageFix> fixesIn(const Session& session) {
    std::vector<MessageFix> all;
    for (const Diagnostic& each : session.diagnostics())
        for (MessageFix& fix : view::fixesOf(each, session.live())) all.push_back(std::move(fix));
    return all;
}

std::vector<std::string> labelsIn(const Session& session) {
    std::vector<std::string> labels;
    for (const MessageFix& each : fixesIn(session)) labels.push_back(each.label);
    return labels;
}

void carryOut(const SceneFolder& folder, const MessageFix& fix) {
    const std::string name = fix.file.filename().string();
    folder.write(name, fix.made.empty() ? view::withFix(folder.read(name), fix) : fix.made);
}

TEST(MessageFixes, MakeAMissingShaderOrTakeTheNearest) {
    const SceneFolder folder(kHead + "Vertex lit.vert  # lit.vert\nFragment a.frag\nProgram P\nQuadXY 0 1\n",
                             {{"light.vert", kPlainVertex},
                              {"a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    ASSERT_EQ(labelsIn(session), (std::vector<std::string>{"Create lit.vert", "Use 'light.vert'"}))
        << text(session.diagnostics());
    std::string searched;
    for (const Diagnostic& each : session.diagnostics()) searched += view::searchedFor(each, session.live());
    EXPECT_NE(searched.find(folder.scene().parent_path().string()), std::string::npos) << searched;
    const std::vector<MessageFix> fixes = fixesIn(session);
    carryOut(folder, fixes[1]);
    EXPECT_NE(folder.read("scene.glib").find("Vertex light.vert  # lit.vert\n"), std::string::npos);
    ASSERT_TRUE(session.reload());
    EXPECT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
}

TEST(MessageFixes, StubsOfAllStagesCompileAndShowSomething) {
    const SceneFolder folder(kHead +
                             "Vertex a.vert\nTessControl a.tesc\nTessEvaluation a.tese\nGeometry "
                             "a.geom\nFragment a.frag\nProgram P\nQuadXY 0 1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    for (const MessageFix& each : fixesIn(session))
        if (!each.made.empty()) carryOut(folder, each);
    folder.write("scene.glib", kHead + "Vertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 1\n");
    ASSERT_TRUE(session.reload());
    EXPECT_TRUE(session.diagnostics().empty()) << text(session.diagnostics());
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 20, 20), (Color{255, 153, 51}));
    folder.write("scene.glib",
                 kHead + "Vertex a.vert\nGeometry a.geom\nFragment a.frag\nProgram P\nQuadXY 0 1\n");
    ASSERT_TRUE(session.reload());
    EXPECT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
}

TEST(MessageFixes, CorrectAMisspeltUniformAndAddNoSliderBesideIt) {
    const SceneFolder folder(kHead +
                                 "Background 0 0 0\nVertex a.vert\nFragment a.frag\n"
                                 "Program P \\\n uAm 1 uAmout <0. .8 1.>\nQuadXY 0 1\n",
                             {{"a.vert", kPlainVertex},
                              {"a.frag",
                               "#version 330\nuniform float uAmount, uAm; out vec4 c;\n"
                               "void main() { c = vec4(uAmount * uAm); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    ASSERT_EQ(labelsIn(session), (std::vector<std::string>{"Rename to 'uAmount'"}))
        << text(session.diagnostics());
    carryOut(folder, fixesIn(session).front());
    EXPECT_NE(folder.read("scene.glib").find(" uAm 1 uAmount <0. .8 1.>\n"), std::string::npos)
        << folder.read("scene.glib");
    ASSERT_TRUE(session.reload());
    EXPECT_TRUE(session.diagnostics().empty()) << text(session.diagnostics());
    EXPECT_EQ(session.values().knobs().at(knobIndex(session, "uAmount")).current, std::vector<double>{.8});
}

TEST(MessageFixes, AddASliderForAUniformThatIsNotSet) {
    for (const auto& [type, use] : std::map<std::string, std::string>{{"float", "uX"},
                                                                      {"int", "float(uX)"},
                                                                      {"bool", "(uX ? 1. : 0.)"},
                                                                      {"vec3", "uX.r"},
                                                                      {"vec2", "uX.y"}}) {
        const SceneFolder folder(
            "WindowSize 40 40\nOrtho -1 1 -1 1 -1 1\nBackground 0 0 0\nVertex a.vert\nFragment a.frag\n"
            "Program P uY 1  # a comment\nQuadXY 0 1\n",
            {{"a.vert", kPlainVertex},
             {"a.frag", "#version 330\nuniform float uY; uniform " + type +
                            " uX; out vec4 c;\nvoid main() { c = vec4(uY * " + use + "); }\n"}});
        Session session(context(), {});
        ASSERT_TRUE(session.open(folder.scene()));
        const std::vector<MessageFix> fixes = fixesIn(session);
        ASSERT_EQ(fixes.size(), 1U) << type << ": " << text(session.diagnostics());
        carryOut(folder, fixes.front());
        ASSERT_TRUE(session.reload());
        EXPECT_TRUE(session.diagnostics().empty())
            << text(session.diagnostics()) << folder.read("scene.glib");
        EXPECT_NE(session.values().knob("", "uX"), nullptr) << type;
        EXPECT_NE(folder.read("scene.glib").find("  # a comment"), std::string::npos);
    }
}

}  // namespace
}  // namespace glibra::test
