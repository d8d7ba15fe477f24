#pragma once
// Reads the shaders of a scene's programs and what they include, and says for each program how it is to be
// translated. This needs no GL.

#include <glibra/render.h>

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/types/request.h"
#include "plan/frame_plan.h"
#include "render/stats.h"
#include "scene/file_lookup.h"
#include "scene/scene.h"

namespace glibra::render {

// ---- Hidden texts
// Messages about shaders that include files which a scene must not show: files outside of its folder and the
// library.

/// Which words of a compiler's message may come from the files that are not shown. The compiler quotes words
/// of the source, and words that the preprocessor has joined; it never quotes comments.
class HiddenWords {
  public:
    /// A source that may be shown, and one that may not.
    void addShown(std::string_view source);
    void addHidden(std::string_view source);
    /// The message with "..." in place of each word that is, or contains, a word of a hidden source, unless
    /// it stands in a shown source or is a keyword of GLSL.
    [[nodiscard]] std::string removedFrom(std::string_view message) const;

  private:
    [[nodiscard]] bool mayBeHidden(std::string_view word) const;

    std::set<std::string, std::less<>> shown_, hidden_;
};

// ---- Sources

/// The largest shader file, in bytes (language, 11).
inline constexpr std::uint64_t kLargestSource = 4ULL << 20;

class ProgramSources {
  public:
    /// All of them must outlive the object.
    ProgramSources(const scene::Scene& scene, const RenderOptions& options, Stats& stats);
    ProgramSources(const ProgramSources&) = delete;
    ProgramSources& operator=(const ProgramSources&) = delete;

    /// A shader file as read, or the diagnostics that prevented it.
    struct SourceFile {
        std::optional<std::string> text;
        std::string path;
        Diagnostics diagnostics;
    };
    const SourceFile& file(scene::FileIndex index);
    /// The request for a variant, without its target. Its functions refer to this object. `tiled`: the
    /// program can draw a part of a larger picture. `diagnostics` receives those of the files.
    [[nodiscard]] glsl::ProgramRequest request(const plan::ProgramVariant& variant, bool tiled,
                                               Diagnostics& diagnostics);
    /// A source of the program whose text may not be shown, because it lies outside of the scene's folder and
    /// the library; empty if there is none. It is known after the program's translation.
    [[nodiscard]] std::string hiddenSource(scene::ProgramIndex program) const;
    /// Removes what messages about a program with such a source may quote of it.
    void hideTexts(scene::ProgramIndex program, Diagnostics& diagnostics) const;
    /// Every file that was read for a program, including #include files.
    [[nodiscard]] std::vector<std::filesystem::path> filesRead() const;
    /// The paths at which #include files that are missing would be found.
    [[nodiscard]] const std::set<std::filesystem::path>& filesMissing() const { return missing_; }

  private:
    /// Notes that the program has a source that may not be shown (scene::shownRoots), if the file is one.
    void noteIfHidden(scene::ProgramIndex program, const std::string& file);
    /// True for files that the calling program has given, too.
    [[nodiscard]] bool isShown(const std::string& file) const;
    [[nodiscard]] std::vector<glsl::SamplerKind> samplerKinds(scene::ProgramIndex program,
                                                              std::string_view tag) const;

    const scene::Scene& scene_;
    const RenderOptions& options_;
    Stats& stats_;
    std::map<scene::FileIndex, SourceFile> sources_;
    std::map<std::filesystem::path, std::string> included_;  ///< what #include has read, with its text
    std::set<std::filesystem::path> missing_;
    scene::FolderListings listings_;
    scene::InterpretOptions search_;
    base::Roots shown_;
    std::map<scene::ProgramIndex, std::string> hidden_;  ///< programs with a source that may not be shown
};

}  // namespace glibra::render
