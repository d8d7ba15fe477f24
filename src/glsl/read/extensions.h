#pragma once
// GLSL extensions whose content the target has: what each of them adds, and since which core version
// (language, 7.2).

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace glibra::glsl {

/// An extension whose content core GLSL has, or the translator supplies.
struct Extension {
    std::string_view name;
    int since;  ///< the core version that has all that it adds; 0: the translator supplies it
    /// The words that it adds, separated by blanks: functions, variables, constants, types, qualifiers and
    /// words of layout(...). `old=new` has another spelling in the core profile. Texture functions that are
    /// named after their sampler are replaced by a rule (language, 7.5). `+word` is no part of any core
    /// version: a driver must have the extension.
    std::string_view adds;
};

/// Every extension once, by name.
std::span<const Extension> extensions();
/// The row of an extension; null for others.
const Extension* findExtension(std::string_view name);
/// True if core GLSL of this version, or the translator, has what the extension adds.
bool isInCore(std::string_view name, int version);

using ExtensionNames = std::set<std::string, std::less<>>;

/// The core profile's word for a word of these extensions; empty if it has the same spelling, or is none.
/// Words that begin with gl_ need no #extension line, because nothing else can have such a name.
std::string_view coreWordOf(std::string_view word, const ExtensionNames& enabled);
/// Of these extensions the one whose word this is, if no core version has it; else null.
const Extension* extensionThatAlone(std::string_view word, const ExtensionNames& enabled);

}  // namespace glibra::glsl
