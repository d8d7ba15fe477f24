// Generated programs of variables, groups, repetitions and conditions (language, 12.2). What the interpreter
// makes of them is compared with a small reference interpreter, which works on the program as a tree: it has
// no slots, no cache and no text. Each program runs at several times in one Interpretation, so that nothing
// of an earlier frame may show in a later one.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <ranges>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "check.h"
#include "scene/conditions.h"
#include "scene/interpret.h"
#include "scope_programs.h"

namespace {

using namespace glibra::fuzz;

/// What can be seen of a run, in order, for the frame and for Once blocks.
struct Seen {
    std::vector<std::string> frame, once, checks;
};

/// A statement reads a name that nothing has: the program is wrong.
struct Unknown {};

/// The reference interpreter.
class Reference {
  public:
    Reference(const Program& program, double time) : time_(program.usesTime ? time : 0) {
        expect(program.statements);
        run(program.statements, nullptr);
    }
    [[nodiscard]] const Seen& seen() const { return seen_; }

  private:
    /// One name of a scope, which hides those around it. Without a value it means the variable of the scene.
    struct Name;
    using Names = std::shared_ptr<Name>;
    struct Name {
        Names around;
        std::string name;
        std::optional<double> value;
    };
    struct Group {
        const Statement* statement = nullptr;
        Names names;
    };
    struct Tag {
        const Sum* sum = nullptr;
        Names names;
    };

    static Names add(Names around, const std::string& name, std::optional<double> value) {
        return std::make_shared<Name>(Name{std::move(around), name, value});
    }
    static const Name* findIn(const Names& names, const std::string& name) {
        for (const Name* each = names.get(); each != nullptr; each = each->around.get())
            if (each->name == name) return each;
        return nullptr;
    }
    /// Notes what the scene declares somewhere.
    void expect(const std::vector<Statement>& all) {
        for (const Statement& each : all) {
            if (each.kind == Kind::let) expected_.insert(each.name);
            expect(each.body);
            expect(each.other);
        }
    }
    double sceneValue(const std::string& name) {
        if (block_)
            if (const auto own = block_->find(name); own != block_->end()) return own->second;
        return scene_.at(name);
    }
    double valueOf(const std::string& name, const Names& names) {
        if (const Name* own = findIn(names, name)) return own->value ? *own->value : sceneValue(name);
        if (scene_.contains(name) || (block_ && block_->contains(name))) return sceneValue(name);
        if (expected_.contains(name)) throw Unknown{};
        for (auto& caller : std::ranges::reverse_view(callers_))
            if (const Name* other = findIn(caller, name)) return other->value.value();
        throw Unknown{};
    }
    double valueOf(const Sum& sum, const Names& names, double modulus = 64) {
        double all = sum.constant;
        for (const std::string& each : sum.names) all += valueOf(each, names);
        return std::fmod(all, modulus);
    }

    void set(const std::string& name, double value) { (block_ ? *block_ : scene_)[name] = value; }

    std::vector<std::string>& list() { return block_ ? seen_.once : seen_.frame; }

    void show(double value, const Names& names) {
        std::string all = std::to_string(value) + " " + camera_;
        for (const auto& [name, tag] : tags_) {
            callers_.push_back(names);
            all += " " + name + " " + std::to_string(valueOf(*tag.sum, tag.names));
            callers_.pop_back();
        }
        list().push_back(all);
    }

    /// Runs statements, which may give names other meanings for those after them.
    Names run(const std::vector<Statement>& all, Names names) {
        for (const Statement& each : all) names = run(each, names);
        return names;
    }
    void runScope(const std::vector<Statement>& all, const Names& names) {
        const auto tags = tags_;
        run(all, names);
        tags_ = tags;
    }

    Names run(const Statement& s, const Names& names) {
        switch (s.kind) {
            case Kind::let: {
                set(s.name, valueOf(s.sum, names));
                const Name* own = findIn(names, s.name);
                return own != nullptr && own->value ? add(names, s.name, std::nullopt) : names;
            }
            case Kind::array: {
                const double last = s.count - 1;
                show(last + valueOf(s.sum, add(names, "i", last)), names);
                return names;
            }
            case Kind::show:
                show(valueOf(s.sum, names), names);
                return names;
            case Kind::set:
                tags_[s.name] = {&s.sum, names};
                return names;
            case Kind::expect:
                seen_.checks.push_back(std::to_string(valueOf(s.sum, names)));
                return names;
            case Kind::repeat:
                for (int round = 0; round < s.count; ++round) runScope(s.body, add(names, s.name, round));
                return names;
            case Kind::values: {
                const double values[] = {valueOf(s.arguments[0].second, names),
                                         valueOf(s.arguments[1].second, names)};
                for (const double each : values) runScope(s.body, add(names, s.name, each));
                return names;
            }
            case Kind::scope:
                runScope(s.body, names);
                return names;
            case Kind::when:
                return valueOf(s.sum, names) + 16 * time_ < s.count ? run(s.body, names)
                                                                    : run(s.other, names);
            case Kind::group:
                groups_[s.name] = {&s, names};
                return names;
            case Kind::draw:
                draw(s, names);
                return names;
            case Kind::pass:
                camera_ = "at[" + std::to_string(static_cast<int>(valueOf(s.sum, names, 4))) + "]";
                runScope(s.body, names);
                camera_.clear();
                return names;
            case Kind::once: {
                block_.emplace();
                const auto tags = tags_;
                run(s.body, names);
                tags_ = tags;
                block_.reset();
                return names;
            }
        }
        return names;
    }

    void draw(const Statement& call, const Names& names) {
        const Group group = groups_.at(call.name);
        std::map<std::string, double> given;
        for (const auto& [name, sum] : call.arguments) given[name] = valueOf(sum, names);
        callers_.push_back(names);
        Names own = group.names;
        for (const auto& [name, usual] : group.statement->arguments) {
            const auto known = given.find(name);
            own = add(own, name, known != given.end() ? known->second : valueOf(usual, group.names));
        }
        runScope(group.statement->body, own);
        callers_.pop_back();
    }

    double time_;
    std::set<std::string> expected_;
    std::map<std::string, double> scene_;
    std::optional<std::map<std::string, double>> block_;  ///< what an open Once sets
    std::map<std::string, Group> groups_;
    std::map<std::string, Tag> tags_;
    std::vector<Names> callers_;
    std::string camera_;
    Seen seen_;
};

void addDraws(const glibra::scene::Scene& scene, const glibra::scene::NodeList& nodes,
              std::vector<std::string>& seen) {
    for (const glibra::scene::Pass& pass : nodes.passes)
        for (const auto& step : pass.steps) {
            const auto* draw = std::get_if<glibra::scene::Draw>(&step);
            if (draw == nullptr) continue;
            std::string all = std::to_string(scene.shapes[draw->shape].numbers.at(0)) + " " + pass.camera;
            std::map<std::string, double> tags;
            if (draw->uniforms)
                for (const auto& each : scene.uniformSets[draw->uniforms].values)
                    tags[each.tag] = each.values.at(0);
            for (const auto& [name, value] : tags) all += " " + name + " " + std::to_string(value);
            seen.push_back(all);
        }
}

/// The inputs are no texts, so a difference is shown with the scene.
void checkEqual(const std::vector<std::string>& found, const std::vector<std::string>& expected,
                std::string_view what, const std::string& scene) {
    if (found == expected) return;
    std::fprintf(stderr, "%s", scene.c_str());
    for (std::size_t i = 0; i < std::max(found.size(), expected.size()); ++i)
        std::fprintf(stderr, "%zu: expected %s, found %s\n", i,
                     i < expected.size() ? expected[i].c_str() : "nothing",
                     i < found.size() ? found[i].c_str() : "nothing");
    check(false, what);
}

Seen seenOf(const glibra::scene::Scene& scene) {
    Seen seen;
    addDraws(scene, scene.frame, seen.frame);
    for (const glibra::scene::OnceBlock& each : scene.once) addDraws(scene, each.nodes, seen.once);
    for (const glibra::scene::Check& each : scene.checks) {
        const auto answer = answerTo(*each.condition.expression, *each.condition.names, each.place.file,
                                     {.types = glibra::scene::kConditionTypes});
        check(answer && answer->found.ends_with(" == 99"), "a condition of an Expect has a value");
        seen.checks.push_back(std::to_string(std::stod(answer->found)));
    }
    return seen;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Program program = Generator(Choices(data, std::min<std::size_t>(size, 400))).program();
    const std::string text = Writer().write(program);
    const glibra::glib::Script script = glibra::glib::parse(text, "nowhere/scene.glib");
    check(script.diagnostics.empty(), "a generated program is a scene");
    glibra::scene::Interpretation interpretation(script, {});
    bool isFirst = true;
    for (const double time : {0., 1., 0.}) {
        const glibra::scene::Scene scene = interpretation.at({.time = time});
        try {
            const Seen expected = Reference(program, time).seen();
            for (const glibra::Diagnostic& each : scene.diagnostics)
                checkEqual({each.severity == glibra::Severity::error ? each.text : ""}, {""},
                           "a program without unknown names has no errors", text);
            const Seen found = seenOf(scene);
            checkEqual(found.frame, expected.frame, "draws have the values of their scopes", text);
            checkEqual(found.once, expected.once, "draws of Once have the values of their scopes", text);
            checkEqual(found.checks, expected.checks, "conditions have the values of their scopes", text);
        } catch (const Unknown&) {
            check(!isFirst || hasError(scene.diagnostics), "a name that nothing has is reported");
        }
        isFirst = false;
    }
    return 0;
}
