// Any bytes as a scene: parsed and interpreted twice, with equal results.

#include <algorithm>

#include "check.h"
#include "glib/script.h"
#include "scene/interpret.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using glibra::fuzz::check;
    const std::string_view text = glibra::fuzz::textOf(data, size);
    const auto lines =
        std::count(text.begin(), text.end(), '\n') + std::count(text.begin(), text.end(), '\r') + 1;
    const glibra::glib::Script script = glibra::glib::parse(text, "nowhere/scene.glib");
    glibra::fuzz::checkMessages(script.diagnostics);
    for (const glibra::Diagnostic& each : script.diagnostics)
        check(each.place.line <= lines, "a message is about a line that exists");

    const glibra::scene::Scene scene = glibra::scene::interpret(script);
    const glibra::scene::Scene again = glibra::scene::interpret(script);
    glibra::fuzz::checkMessages(scene.diagnostics);
    check(scene.diagnostics.size() == again.diagnostics.size(), "a script means the same twice");
    check(scene.passes.size() == again.passes.size() && scene.shapes.size() == again.shapes.size() &&
              scene.programs.size() == again.programs.size(),
          "a script makes the same scene twice");
    for (const glibra::scene::Pass& pass : scene.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<glibra::scene::Draw>(&step)) {
                check(draw->shape.position() < scene.shapes.size(), "a draw has a shape");
                check(!draw->program || draw->program.position() < scene.programs.size(),
                      "a draw has a program of the scene, or none");
            }
    return 0;
}
