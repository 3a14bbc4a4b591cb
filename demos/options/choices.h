// Run options as texts and as parsed values. Precedence: command line, config file, scene file, preset. A preset on
// the command line overrides the method options of the files, because such a file may spell out every option.
#pragma once

#include "demos/options/frame_options.h"
#include "demos/options/settings.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/scene_description.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos {

// Option texts as given, by option name without dashes.
class GivenOptions {
  public:
    // `field` is its name in messages: "--dt", or "dt in my.json". The first text added for a name counts.
    void add(const std::string& name, const std::string& text, const std::string& field);

    // Whether a preset was given that overrides what a file says about this option.
    bool preset_decides(std::string_view option) const;

    struct Given {
        std::string text;
        std::string field;

        bool is_typed() const { return field.starts_with("--"); }  // on the command line, not in a file

        bool operator==(const Given&) const = default;
    };
    const Given* find(std::string_view name) const;
    const std::map<std::string, Given, std::less<>>& all() const { return given_; }
    bool operator==(const GivenOptions&) const = default;
    void add_all(const GivenOptions& other) { given_.insert(other.given_.begin(), other.given_.end()); }

  private:
    std::map<std::string, Given, std::less<>> given_;
};

// Adds the options of a JSON file: an object of option names without dashes, and "scene"; a scene file that is not
// there is looked for beside the config, which may have been moved with it. Throws UsageError for a
// file that cannot be read, is not such an object or has an unknown key; the message suggests the nearest known
// key.
void add_config(const std::filesystem::path& file, GivenOptions& given);

// Parsed options of one run.
struct Choices {
    std::string scene;  // as given: a scene of the catalogue or a file
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

// Parses the options of a run. `scene` names a scene of the catalogue or a scene file. Throws UsageError that names
// the field, the value and what is allowed; also for a parameter that the scene lacks.
Choices understand(const std::string& scene, GivenOptions given);

// Throws UsageError for a name that is neither a scene nor a file, and for a parameter of another scene.
void require_parameters(const std::string& scene, const GivenOptions& given);

// The description with every option spelled out, so that its meaning does not depend on presets.
SceneDescription spelled_out(const Choices& choices);

// Hash of what decides the motion: the scene but for its looks, and the options but for duration and threads.
std::uint32_t motion_hash(const Choices& choices);

// Hash of what decides the pictures of a film, to tell its frames from those of another; empty for stills.
std::string film_mark(const Choices& choices, const GivenOptions& given);

// JSON text that reproduces the run: every option spelled out; for a comparison only the given ones.
std::string config_text(const Choices& choices, const GivenOptions& given);

}  // namespace pushfactor::demos
