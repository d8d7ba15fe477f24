#pragma once
// The words that an editor proposes while a shader or a scene is written.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/text_range.h"
#include "glsl/types/stage.h"
#include "source/syntax.h"

namespace glibra::editor {

using source::CodeLanguage;

/// A name that the scene gives to the text: a uniform that it sets, a variable, a texture, a program.
struct KnownName {
    std::string name;
    std::string type;   ///< "vec3", "Texture2D"
    std::string what;   ///< a sentence, such as where it is declared
    std::string value;  ///< its current value; empty: it has none
    /// Which text reads it: a shader or a scene.
    CodeLanguage in = CodeLanguage::glsl;
    bool isStageVariable = false;  ///< an input or an output of a stage
};

/// What an editor knows about the text besides the text itself.
struct CodeContext {
    CodeLanguage language = CodeLanguage::glsl;  ///< of the file
    std::optional<glsl::Stage> stage;            ///< of a shader; nothing: not known
    std::vector<KnownName> names;
    /// The folders that names of files begin in (scene::searchFolders).
    std::vector<std::filesystem::path> folders{};
};

/// The stage that the suffix of a file says: ".frag", ".fs" and ".frag.glsl" are fragment shaders. Nothing if
/// it says none, as ".glsl" alone.
std::optional<glsl::Stage> stageOfFile(const std::filesystem::path& file);

struct Completion {
    std::string word;
    std::string type;       ///< "vec3", "T sin(T angle)", "keyword", "command"
    std::string what;       ///< one line; may be empty
    std::size_t begin = 0;  ///< the byte of the text from which on the word replaces what is typed
};

/// The language at a byte: scenes may contain shaders (InlineShaders). `stage` is that shader's.
struct LanguageAt {
    CodeLanguage language = CodeLanguage::glsl;
    std::optional<glsl::Stage> stage;
    TextRange part;  ///< the shader's text, or the whole text
};
/// The shaders in the text of a scene.
std::vector<LanguageAt> shadersIn(std::string_view scene);
LanguageAt languageAt(std::string_view text, std::size_t byte, const CodeContext& context);

/// The words that may stand at the cursor and begin with what stands before it, in any case: names that the
/// text declares first, then those of the scene, then what the language has. Words of a shader are those of
/// its version and stage; names are those that the scope shows, after a '.' members and swizzles, after
/// `#include` and in statements that take a file the files of CodeContext::folders. Empty in comments, in
/// numbers, where a new name is declared, and if the only word stands there already.
std::vector<Completion> completionsAt(std::string_view text, std::size_t cursor, const CodeContext& context);

}  // namespace glibra::editor
