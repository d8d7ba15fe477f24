#pragma once
// Private to this room: what a scene, or a Once or Step block, depends on.

#include <string_view>

#include "expression/known_names.h"
#include "scene/run/state.h"

namespace glibra::scene {

/// Remembers that a Once block, or whoever collects it, reads the value of a name at that place. Reports
/// memory-E11 for a variable that changes with time and that Once reads.
void noteRead(Interpreter&, std::string_view name, Environment::Slot slot, const Place& place);

/// Remembers what the scene, or the block that is open, depends on.
void addDepends(Interpreter&, expression::Depends depends);

/// Collects what the evaluations during its life depend on. At its end the scene or block depends on it too.
class DependsOnly {
  public:
    explicit DependsOnly(Interpreter& in);
    DependsOnly(const DependsOnly&) = delete;
    DependsOnly& operator=(const DependsOnly&) = delete;
    ~DependsOnly() { all_ = all_ | before_; }
    [[nodiscard]] expression::Depends depends() const { return all_; }

  private:
    expression::Depends& all_;
    expression::Depends before_;
};

}  // namespace glibra::scene
