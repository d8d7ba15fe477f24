#pragma once
// Messages about tags that set no uniform and uniforms that no tag sets.

#include <glibra/diagnostic.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plan/type_table.h"
#include "plan/uniform_names.h"

namespace glibra::plan {

/// The messages of one program.
class UniformMessages {
  public:
    /// `modern`: the scene if it is modern, else null. Messages are appended to `to`. The references must
    /// outlive this.
    UniformMessages(const scene::Program& program, const ProgramInterface& interface,
                    const UniformNames& names, const scene::Scene* modern, Diagnostics& to)
        : program_(program), interface_(interface), names_(names), modern_(modern), to_(to) {}

    /// glib-W25: glibra supplies the uniform.
    void supplied(const GivenValue& given);

    /// glib-E16: the tag is probably a key of its statement; only Dispatch has keys that its tags may
    /// resemble.
    void misspelt(std::string_view tag, std::string_view key, const Place& place);

    /// The tag names no active uniform: supplied but unused (glib-W25), declared but unused (glib-W24), the
    /// misspelt key `resembles` (glib-E16), or unknown (glib-W23).
    void unknown(const GivenValue& given, std::string_view resembles = {});

    /// True for a tag that names an element or member that is declared in an array or structure of which
    /// the program reads some other part. Drivers differ in which of these they call active.
    [[nodiscard]] bool isUnreadPart(std::string_view tag) const;

    /// glib-W37: the uniforms have no value. Many members of a variable or block are reported as one.
    void unset(std::span<const ActiveUniform> uniforms);

  private:
    void warn(const char* id, std::string text, const Place& place, std::string_view subject = {},
              std::string suggestion = {});
    [[nodiscard]] bool isDeclared(std::string_view name) const;
    const std::vector<std::string>& knownNames();
    /// For a uniform that a Set names, but of another scope.
    [[nodiscard]] std::string scopeHint(const std::string& name) const;
    [[nodiscard]] std::string modernHint(const ActiveUniform& target) const;

    const scene::Program& program_;
    const ProgramInterface& interface_;
    const UniformNames& names_;
    const scene::Scene* modern_;
    Diagnostics& to_;
    std::vector<std::string> knownNames_;
};

/// glib-E27 for a word as the value of a tag, which names nothing of the scene.
Diagnostic unknownWord(const scene::Scene& scene, std::string_view word, const Place& place);

}  // namespace glibra::plan
