// How the types of the public headers lie in memory: a line for each type with its size and alignment, and
// for each member with its place and size. abi.sh compares that with layout.txt. A new type or member gets an
// entry here; most that are forgotten change a size all the same.

#include <glibra/classic/classic.h>
#include <glibra/glibra.h>

#include <cstddef>
#include <cstdio>

using namespace glibra;

#define TYPE(type) std::printf("%s: %zu bytes, aligned to %zu\n", #type, sizeof(type), alignof(type))
#define MEMBER(type, name) \
    std::printf("    %s at %zu, %zu\n", #name, offsetof(type, name), sizeof(type::name))

int main() {
    TYPE(Place);
    MEMBER(Place, file);
    MEMBER(Place, line);
    MEMBER(Place, column);
    TYPE(Diagnostic);
    MEMBER(Diagnostic, severity);
    MEMBER(Diagnostic, id);
    MEMBER(Diagnostic, text);
    MEMBER(Diagnostic, place);
    MEMBER(Diagnostic, subject);
    MEMBER(Diagnostic, suggestion);
    TYPE(DrawId);
    MEMBER(DrawId, line);
    MEMBER(DrawId, file);
    MEMBER(DrawId, counter);
    TYPE(Tolerance);
    MEMBER(Tolerance, largest);
    MEMBER(Tolerance, fraction);
    MEMBER(Tolerance, cluster);
    MEMBER(Tolerance, line);
    MEMBER(Tolerance, bias);
    MEMBER(Tolerance, flip);
    MEMBER(Tolerance, structure);
    MEMBER(Tolerance, relative);
    MEMBER(Tolerance, absolute);
    MEMBER(Tolerance, exact);
    TYPE(Comparison);
    MEMBER(Comparison, same);
    MEMBER(Comparison, reason);
    MEMBER(Comparison, differingPixels);
    MEMBER(Comparison, largest);
    MEMBER(Comparison, x);
    MEMBER(Comparison, y);
    MEMBER(Comparison, rootMeanSquare);
    MEMBER(Comparison, flip);
    MEMBER(Comparison, structure);
    MEMBER(Comparison, diagnostics);
    TYPE(ViewState::Object);
    MEMBER(ViewState::Object, line);
    MEMBER(ViewState::Object, matrix);
    MEMBER(ViewState::Object, file);
    MEMBER(ViewState::Object, counter);
    TYPE(ViewState);
    MEMBER(ViewState, scene);
    MEMBER(ViewState, eye);
    MEMBER(ViewState, texture);
    MEMBER(ViewState, objects);
    MEMBER(ViewState, projection);
    MEMBER(ViewState, background);
    TYPE(RenderOptions);
    MEMBER(RenderOptions, width);
    MEMBER(RenderOptions, height);
    MEMBER(RenderOptions, time);
    MEMBER(RenderOptions, steps);
    MEMBER(RenderOptions, set);
    MEMBER(RenderOptions, view);
    MEMBER(RenderOptions, samples);
    MEMBER(RenderOptions, maxError);
    MEMBER(RenderOptions, lastTime);
    MEMBER(RenderOptions, overrideCounts);
    MEMBER(RenderOptions, axes);
    MEMBER(RenderOptions, labels);
    MEMBER(RenderOptions, alpha);
    MEMBER(RenderOptions, floatPixels);
    MEMBER(RenderOptions, strict);
    MEMBER(RenderOptions, incomplete);
    MEMBER(RenderOptions, checkNan);
    MEMBER(RenderOptions, checkUndefined);
    MEMBER(RenderOptions, shim);
    MEMBER(RenderOptions, skip);
    MEMBER(RenderOptions, libraryRoots);
    MEMBER(RenderOptions, within);
    MEMBER(RenderOptions, checks);
    MEMBER(RenderOptions, sceneText);
    MEMBER(RenderOptions, texts);
    MEMBER(RenderOptions, reader);
    MEMBER(RenderOptions, tileSize);
    MEMBER(RenderOptions, viewState);
    MEMBER(RenderOptions, wantedObjects);
    TYPE(Picture);
    MEMBER(Picture, width);
    MEMBER(Picture, height);
    MEMBER(Picture, components);
    MEMBER(Picture, isFloat);
    MEMBER(Picture, isSigned);
    MEMBER(Picture, bits);
    MEMBER(Picture, data);
    TYPE(CurrentContext);
    MEMBER(CurrentContext, loader);
    TYPE(Value);
    MEMBER(Value, name);
    MEMBER(Value, program);
    MEMBER(Value, programLine);
    MEMBER(Value, type);
    MEMBER(Value, value);
    MEMBER(Value, initial);
    MEMBER(Value, hasRange);
    MEMBER(Value, minimum);
    MEMBER(Value, maximum);
    MEMBER(Value, words);
    MEMBER(Value, place);
    TYPE(DrawOptions);
    MEMBER(DrawOptions, width);
    MEMBER(DrawOptions, height);
    MEMBER(DrawOptions, time);
    MEMBER(DrawOptions, samples);
    MEMBER(DrawOptions, alpha);
    MEMBER(DrawOptions, floatPixels);
    MEMBER(DrawOptions, axes);
    MEMBER(DrawOptions, view);
    TYPE(DataView::Field);
    MEMBER(DataView::Field, name);
    MEMBER(DataView::Field, type);
    MEMBER(DataView::Field, offset);
    MEMBER(DataView::Field, count);
    TYPE(DataView);
    MEMBER(DataView, bytes);
    MEMBER(DataView, type);
    MEMBER(DataView, shape);
    MEMBER(DataView, fields);
    MEMBER(DataView, record);
    MEMBER(DataView, first);
    MEMBER(DataView, isOfHead);
    TYPE(BufferContent::Column);
    MEMBER(BufferContent::Column, name);
    MEMBER(BufferContent::Column, type);
    MEMBER(BufferContent::Column, offset);
    MEMBER(BufferContent::Column, count);
    MEMBER(BufferContent::Column, stride);
    MEMBER(BufferContent::Column, offsets);
    TYPE(BufferContent);
    MEMBER(BufferContent, bytes);
    MEMBER(BufferContent, head);
    MEMBER(BufferContent, columns);
    MEMBER(BufferContent, headBytes);
    MEMBER(BufferContent, stride);
    MEMBER(BufferContent, elements);
    TYPE(Result<Picture>);
    MEMBER(Result<Picture>, value);
    MEMBER(Result<Picture>, diagnostics);
    TYPE(Result<void>);
    MEMBER(Result<void>, diagnostics);
    TYPE(Result<Scene>);
    MEMBER(Result<Scene>, value);
    MEMBER(Result<Scene>, diagnostics);
    TYPE(Renderer);
    TYPE(Scene);
    TYPE(classic::GLSLProgram);
    TYPE(classic::Matrix4);
    TYPE(classic::Vec3);
    TYPE(classic::Point3);
    TYPE(classic::VertexArray);
    TYPE(Severity);
    TYPE(Driver);
    TYPE(ViewPolicy);
    TYPE(ProjectionMode);
    TYPE(LabelCorner);
    std::printf("drivers %d %d, corners %d, kinds of messages %d\n", static_cast<int>(Driver::automatic),
                static_cast<int>(Driver::osmesa), static_cast<int>(LabelCorner::topRight),
                static_cast<int>(Severity::error));
}
