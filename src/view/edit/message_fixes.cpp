#include "view/edit/message_fixes.h"

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include "base/suggest.h"
#include "scene/file_lookup.h"
#include "system/folder.h"
#include "view/edit/source_lines.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

struct Stub {
    std::string_view ending, text;
};
/// The shortest shaders that show something, in the names that glibra supplies (language, 7).
constexpr std::array kStubs{
    Stub{".vert",
         "#version 330\nout vec2 vST;\n\nvoid main() {\n    vST = aTexCoord0.st;\n"
         "    gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n"},
    Stub{".frag", "#version 330\nout vec4 fColor;\n\nvoid main() {\n    fColor = vec4(1., .6, .2, 1.);\n}\n"},
    Stub{".geom",
         "#version 330\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n\n"
         "void main() {\n    for (int i = 0; i < 3; ++i) {\n        gl_Position = "
         "gl_in[i].gl_Position;\n        EmitVertex();\n    }\n    EndPrimitive();\n}\n"},
    Stub{".tesc",
         "#version 410\nlayout(vertices = 3) out;\n\nvoid main() {\n    "
         "gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n    for (int i = "
         "0; i < 3; ++i) gl_TessLevelOuter[i] = 4.;\n    gl_TessLevelInner[0] = 4.;\n}\n"},
    Stub{".tese",
         "#version 410\nlayout(triangles) in;\n\nvoid main() {\n    gl_Position = gl_TessCoord.x * "
         "gl_in[0].gl_Position + gl_TessCoord.y * gl_in[1].gl_Position +\n        gl_TessCoord.z * "
         "gl_in[2].gl_Position;\n}\n"},
    Stub{".comp", "#version 430\nlayout(local_size_x = 8, local_size_y = 8) in;\n\nvoid main() {\n}\n"}};

/// The ordinary files with that ending in a folder.
std::vector<std::string> filesLike(const fs::path& folder, const fs::path& ending) {
    std::vector<std::string> names;
    std::error_code failure;
    constexpr std::size_t kMost = 2000;
    for (fs::directory_iterator each(folder.empty() ? fs::path(".") : folder, failure), end;
         !failure && each != end && names.size() < kMost; each.increment(failure))
        if (each->path().extension() == ending) names.push_back(each->path().filename().generic_string());
    std::sort(names.begin(), names.end());
    return names;
}

void addFileFixes(const Diagnostic& message, const fs::path& scene, std::vector<MessageFix>& fixes) {
    const fs::path name = message.subject;
    const auto stub = std::ranges::find(kStubs, name.extension(), &Stub::ending);
    const bool isInside = name.is_relative() && std::ranges::find(name, fs::path("..")) == name.end();
    if (stub != kStubs.end() && isInside)
        fixes.push_back({.label = "Create " + name.generic_string(),
                         .file = fs::path(message.place.file).parent_path() / name,
                         .made = std::string(stub->text)});
    std::string other = message.suggestion;
    if (other.empty()) {
        const std::vector<std::string> names = filesLike(scene.parent_path(), name.extension());
        const std::vector<std::string_view> views(names.begin(), names.end());
        other = base::nearestName(name.filename().generic_string(), views);
        // A shader for the same stage is better than nothing if it is the only one.
        if (other.empty() && names.size() == 1 && stub != kStubs.end()) other = names.front();
    }
    if (!other.empty())
        fixes.push_back({.label = "Use '" + other + "'",
                         .file = message.place.file,
                         .line = message.place.line,
                         .from = message.subject,
                         .to = other.find(' ') == std::string::npos ? other : '"' + other + '"'});
}

/// " uA <0. .5 1.>": a value with a control for the type of the uniform; empty if there is none.
std::string sliderFor(const plan::ActiveUniform& uniform) {
    if (uniform.arraySize != 1) return {};
    const std::string& word = uniform.type.word;
    if (word == "float") return uniform.name + " <0. .5 1.>";
    if (word == "int" || word == "uint") return uniform.name + " <0 1 10>";
    if (word == "bool") return uniform.name + " <true>";
    if (word == "vec3") return uniform.name + " {1. .6 .2}";
    if (word == "vec4") return uniform.name + " {1. .6 .2 1.}";
    if (word == "vec2") return uniform.name + " [.5 .5]";
    return {};
}

/// True if the scene sets a name that comes near to the uniform's and that no uniform has: what is right is
/// to correct that name.
bool isMisspelt(std::string_view uniform, const scene::Program& program,
                const plan::ProgramInterface& interface) {
    std::vector<std::string_view> unknown;
    for (const glib::UniformSpec& each : program.uniforms)
        if (std::ranges::find(interface.uniforms, each.tag, &plan::ActiveUniform::name) ==
            interface.uniforms.end())
            unknown.push_back(each.tag);
    return !base::nearestName(uniform, unknown).empty();
}

void addSlider(const Diagnostic& message, const render::LiveScene& live, std::vector<MessageFix>& fixes) {
    for (const plan::PlannedProgram& each : live.plan().programs) {
        if (!each.variant.program || live.scene().programs[each.variant.program].place != message.place)
            continue;
        for (const plan::ActiveUniform& uniform : each.interface->uniforms) {
            if (uniform.name != message.subject) continue;
            if (isMisspelt(uniform.name, live.scene().programs[each.variant.program], *each.interface))
                return;
            if (const std::string value = sliderFor(uniform); !value.empty())
                fixes.push_back(
                    {.label = value.find('<') == std::string::npos ? "Add a value" : "Add a slider",
                     .file = message.place.file,
                     .line = message.place.line,
                     .to = " " + value});
            return;
        }
    }
}

}  // namespace

std::vector<MessageFix> fixesOf(const Diagnostic& message, const render::LiveScene& live) {
    std::vector<MessageFix> fixes;
    if (message.subject.empty() || message.place.file.empty()) return fixes;
    if (message.id == "file-E01") addFileFixes(message, live.scene().path, fixes);
    if (message.id == "glib-W37") addSlider(message, live, fixes);
    if (message.id == "glib-W23" && !message.suggestion.empty())
        fixes.push_back({.label = "Rename to '" + message.suggestion + "'",
                         .file = message.place.file,
                         .line = message.place.line,
                         .from = message.subject,
                         .to = message.suggestion});
    return fixes;
}

std::string searchedFor(const Diagnostic& message, const render::LiveScene& live) {
    if (message.id != "file-E01" || message.subject.empty()) return {};
    const scene::SearchFolders folders = live.searchFolders();
    std::string text;
    const auto add = [&](const fs::path& folder) {
        text += (text.empty() ? "Looked for in " : ", ") + system::wholePath(folder).generic_string();
    };
    for (const fs::path& each : folders.beside) add(each.empty() ? fs::path(".") : each);
    for (const fs::path& each : folders.library) add(each);
    return text;
}

std::string withFix(std::string_view text, const MessageFix& fix) {
    std::size_t begin = 0;
    for (int line = 1; line < fix.line; ++line) {
        begin = text.find('\n', begin);
        if (begin == std::string_view::npos) return std::string(text);
        ++begin;
    }
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line(text.substr(begin, end - begin));
    if (!fix.from.empty()) {
        const std::size_t quoted = line.find('"' + fix.from + '"');
        const std::vector<TextRange> words = findAll(line, {fix.from, true, true});
        if (quoted == std::string::npos && words.empty()) return std::string(text);
        const std::size_t at = quoted != std::string::npos ? quoted : words.front().begin;
        line.replace(at, fix.from.size() + (quoted != std::string::npos ? 2 : 0), fix.to);
    } else {
        const std::string_view statement = std::string_view(line).substr(0, line.find('#'));
        line.insert(statement.find_last_not_of(" \t\\\r") + 1, fix.to);
    }
    return std::string(text.substr(0, begin)) + line + std::string(text.substr(end));
}

}  // namespace glibra::view
