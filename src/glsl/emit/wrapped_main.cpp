#include "glsl/emit/wrapped_main.h"

#include <algorithm>

namespace glibra::glsl {
namespace {

/// Length of the #version line, with which a translated source begins; 0 if it has none.
std::size_t versionLength(std::string_view source) {
    if (!source.starts_with("#version")) return 0;
    return std::min(source.find('\n'), source.size() - 1) + 1;
}

}  // namespace

std::string wrappedMain(const TranslatedStage& stage, const MainWrapper& wrapper) {
    const std::size_t version = versionLength(stage.source);
    std::string text = stage.source.substr(0, version);
    text += "#define main glibra_sceneMain\n";
    text.append(stage.source, version);
    text += "\n#undef main\n";
    text += wrapper.declarations;
    text += "void main() {\n";
    text += wrapper.before;
    text += "    glibra_sceneMain();\n";
    text += wrapper.after;
    text += "}\n";
    return text;
}

std::string versionLine(const TranslatedStage& stage) {
    const std::size_t version = versionLength(stage.source);
    return version == 0 ? "#version 410 core\n" : stage.source.substr(0, version);
}

}  // namespace glibra::glsl
