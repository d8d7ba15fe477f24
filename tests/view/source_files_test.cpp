#include "view/edit/source_files.h"

#include <algorithm>

#include "scene_folder.h"

namespace glibra::test {
namespace {

using view::Session;

const std::string kIncluding =
    "#version 330\n#include \"common.glsl\"\nout vec4 c;\nvoid main() { c = vec4(level(), 0., 0., 1.); }\n";

TEST(SourceFiles, AreTheSceneItsShadersAndWhatTheyInclude) {
    const SceneFolder folder(
        "WindowSize 16 16\nVertex a.vert\nFragment a.frag\nProgram One\nQuadXY 0 1\nFragment b.frag\nProgram "
        "Two\n"
        "Texture 5 none.png\nQuadXY 0 1\n",
        {{"a.vert", kPlainVertex},
         {"a.frag", kIncluding},
         {"b.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\n"},
         {"common.glsl", "float level() { return 1.; }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    std::string listed;
    for (const view::SourceFile& each : view::sourceFiles(session.live()))
        listed += each.label + ": " + each.role + "\n";
    EXPECT_EQ(listed,
              "scene.glib: scene\na.vert: vertex shader of One, Two\na.frag: fragment shader of One\n"
              "b.frag: fragment shader of Two\ncommon.glsl: included\n");
}

TEST(SourceFiles, OfTheSameNameAreToldApartByTheirFolders) {
    const SceneFolder folder("");
    std::filesystem::create_directory(folder / "left");
    std::filesystem::create_directory(folder / "right");
    folder.write("left/a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\n");
    folder.write("right/a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(0.); }\n");
    folder.write("a.vert", kPlainVertex);
    folder.write(
        "scene.glib",
        "Vertex a.vert\nFragment left/a.frag\nProgram L\nQuadXY 0 1\nFragment right/a.frag\nProgram R\n"
        "QuadXY 1 1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    std::vector<std::string> labels;
    for (const view::SourceFile& each : view::sourceFiles(session.live())) labels.push_back(each.label);
    EXPECT_EQ(labels, (std::vector<std::string>{"scene.glib", "a.vert", "left/a.frag", "right/a.frag"}));
}

TEST(TranslatedLines, ShowWhatTheDriverGotOfARefusedLine) {
    const std::string fragment =
        "varying vec2 vST;\nuniform float uR;\nvoid main() {\n    gl_FragColor = vec4(uR, oops, 0., "
        "1.);\n}\n";
    const SceneFolder folder(
        "WindowSize 16 16\nVertex a.vert\nFragment a.frag\nProgram P uR <0 .2 1>\nQuadXY 0 1\n",
        {{"a.vert",
          "varying vec2 vST;\nvoid main() { vST = gl_MultiTexCoord0.st; gl_Position = ftransform(); }\n"},
         {"a.frag", fragment}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    ASSERT_TRUE(hasError(session.diagnostics()));
    const auto wrong = std::find_if(session.diagnostics().begin(), session.diagnostics().end(),
                                    [](const Diagnostic& each) { return each.severity == Severity::error; });
    const Place place = wrong->place;
    EXPECT_EQ(place.line, 4) << text(session.diagnostics());
    const std::vector<glsl::EmittedLine> lines = session.live().translatedLines(place);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NE(lines[0].text.find("vec4(uR, oops, 0., 1.)"), std::string::npos) << lines[0].text;
    EXPECT_EQ(lines[0].text.find("gl_FragColor"), std::string::npos) << "core GLSL does not have this name";
    EXPECT_GT(lines[0].number, 4) << "declarations precede it";
    EXPECT_TRUE(session.live().translatedLines({place.file, 99, 1}).empty());

    folder.write("a.frag", "uniform float uR;\nvoid main() { gl_FragColor = vec4(uR, 0., 0., 1.); }\n");
    ASSERT_TRUE(session.reload());
    EXPECT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
    EXPECT_TRUE(session.live().translatedLines(place).empty());
}

}  // namespace
}  // namespace glibra::test
