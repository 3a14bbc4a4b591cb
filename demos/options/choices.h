// Everything that somebody chose for one run, before and after it is understood. Precedence: command line, then
// config file, then scene file, then preset. A preset counts where it is given: one of the command line wins over
// what the files say of the method, because such a file may spell out every option.
#pragma once

#include "demos/options/frame_options.h"
#include "demos/options/settings.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/scene_description.h"

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos {

// The texts as given, by option name without dashes.
class GivenOptions {
  public:
    // `field` is how messages call it: "--dt", or "dt in my.json". The first one given for a name holds.
    void add(const std::string& name, const std::string& text, const std::string& field);

    // Whether a preset has been given that wins over what a file says of this option.
    bool preset_decides(std::string_view option) const;

    struct Given {
        std::string text;
        std::string field;
    };
    const Given* find(std::string_view name) const;
    const std::map<std::string, Given, std::less<>>& all() const { return given_; }
    void add_all(const GivenOptions& other) { given_.insert(other.given_.begin(), other.given_.end()); }

  private:
    std::map<std::string, Given, std::less<>> given_;
};

// Adds what the JSON file says: an object of option names without dashes, and "scene". Throws UsageError for a file
// that cannot be read, is no such object or has an unknown key; the message suggests the nearest known one.
void add_config(const std::filesystem::path& file, GivenOptions& given);

// One run, understood.
struct Choices {
    std::string scene;  // as it was named: a scene of the catalogue or a file
    SceneDescription description;
    Settings settings;
    std::vector<std::pair<std::string, std::string>> parameters;  // of the scene, all values in force
    FrameChoices frames;

    // The same run with one thread, for measurements of CPU time. The state hash does not depend on it.
    Choices on_one_thread() const {
        Choices choices = *this;
        choices.settings.threads = 1;
        return choices;
    }
};

// `scene` names a scene of the catalogue or a scene file. Throws UsageError that names the field, the value and
// what is allowed; also for a parameter that the scene lacks.
Choices understand(const std::string& scene, GivenOptions given);

// The description with every option in it, so that it means the same when a preset changes.
SceneDescription spelled_out(const Choices& choices);

// The JSON file that makes the same run again: every option spelled out, or where runs are compared just those that
// were given.
std::string config_text(const Choices& choices, const GivenOptions& given);

}  // namespace pushfactor::demos
