#pragma once
// Private to this room: the names of objects, of their parts (language, 12.4) and of programs.

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "scene/run/state.h"

namespace glibra::scene {

/// Declares the name that the statement's first value states. False with glib-E36 if it has a meaning
/// already.
bool declareName(Interpreter&, const Command&, const std::string& name, DeclaredName::Kind kind);
/// Sets the object of a declared name.
void setObject(Interpreter&, const std::string& name,
               const std::variant<std::monostate, TextureIndex, SamplerIndex, BufferIndex>& object);
/// True if the value names a texture or buffer, or a part of one.
bool namesObject(const Interpreter&, const Value& value);
/// True if the value names a choice, or the counter of a Repeat over words, whose word names a texture or
/// buffer. A part of the object may follow, but not `.index`.
bool choosesObject(Interpreter&, const Value& value);
/// The texture or buffer that a value names, with its part. Nothing with the reason reported.
std::optional<ObjectView> objectNamed(Interpreter&, const Value& value);
std::optional<TextureView> textureNamed(Interpreter&, const Value& value);
std::optional<BufferView> bufferNamed(Interpreter&, const Value& value);
/// Takes the member from "particles.velocity" and leaves the name of the buffer. `what`: the statement, for
/// messages. Nothing with the reason reported.
std::optional<std::string> takeMember(Interpreter&, Value& name, std::string_view what);
/// A texture, buffer, camera or variable of the scene that the name means here; null if a scope gives the
/// name another meaning, or nothing has the name.
const DeclaredName* declaredName(const Interpreter&, std::string_view name);
/// The word that a name stands for, if it is the counter of a Repeat over words or a choice; otherwise the
/// name itself.
std::string wordBehind(Interpreter&, const std::string& name);
/// True for the word `window`.
bool isWindow(const Value& value);
/// True if the value names a sampler as its last part: `brick.crisp`.
bool endsInSampler(const Interpreter&, const Value& value);

/// The program of that name, if it draws or if it computes, as wanted. Nothing with glib-E27 or E34 reported.
std::optional<ProgramIndex> programNamed(Interpreter&, const Value& name, bool isCompute);

}  // namespace glibra::scene
