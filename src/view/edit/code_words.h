#pragma once
// The names of the room `editor` that the window's editor uses: words to propose, and their reference.

#include "editor/call_hint.h"
#include "editor/completion.h"
#include "editor/declared_names.h"
#include "editor/reference.h"

namespace glibra::view {

using editor::callAt;
using editor::CallHint;
using editor::CodeContext;
using editor::Completion;
using editor::completionsAt;
using editor::DeclaredName;
using editor::declaredNames;
using editor::KnownName;
using editor::LanguageAt;
using editor::languageAt;
using editor::nameNear;
using editor::referenceAt;
using editor::ReferenceEntry;
using editor::referenceOf;
using editor::SignatureParts;
using editor::wordAt;
using editor::wordBefore;

}  // namespace glibra::view
