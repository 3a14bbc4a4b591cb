// A run, or several side by side, as one HTML file that plays in a browser.
#pragma once

#include "demos/base/platform/output_file.h"
#include "demos/pictures/camera/framing.h"
#include "demos/pictures/camera/survey.h"
#include "demos/pictures/replay/bytes.h"
#include "demos/pictures/replay/page.h"
#include "demos/runs/session.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace pushfactor::demos::pictures {

// Throws UsageError unless the name ends in .html or is that of standard output.
void check_replay_name(const std::filesystem::path& file);

// The frames of a replay: those of --fps, else as many as make at most 60 per second.
Frames replay_frames(const Choices& choices);

struct ReplayChoices {
    std::filesystem::path file;
    bool poses_only = false;  // neither velocities nor forces, which take most of the room
    std::string command;      // that makes the page, as the reader sees it
};

// Written block by block while the runs go on: memory does not grow with their length, but for a few numbers per
// frame. The file appears whole in finish(), or not at all.
class Replay : public Observer {
  public:
    // `session` is at its start and must outlive the replay. Throws OutputError as OutputFile does.
    Replay(const ReplayChoices& choices, const Session& session);

    // Adds the current state of all runs as the next frame.
    void frame(std::size_t number) override;

    // Completes the file with the frames so far. `note` tells why there are no more; empty for a whole run.
    void finish(const std::string& note = "");

    // The same for a run that stopped early. Returns a note, or the reason why the file could not be written.
    // Throws nothing.
    std::string keep(const std::string& why);

  private:
    // One run and its frames since the last block.
    struct Track {
        const Simulation* simulation;
        std::vector<Ball> start;          // what moves, and what it hangs on
        Extents extents;                  // so far
        std::vector<std::size_t> bodies;  // recorded ones
        replay::ForceBlock forces;
        std::vector<std::vector<std::int64_t>> poses{}, velocities{};  // per quantity and frame
        std::vector<std::array<std::int64_t, 4>> orientations{};       // of the last frame
        std::array<std::vector<float>, 5> measures{};                  // per measure and frame
    };

    void write_head(const Sequence& sequence);
    std::vector<View> views() const;
    void record(Track& track, std::map<OverlayKind, double>& largest);
    void record_poses(Track& track) const;
    void record_forces(Track& track, std::map<OverlayKind, double>& largest) const;
    void write_blocks();

    ReplayChoices choices_;
    FrameChoices frames_;
    OutputFile file_;
    replay::Page page_;
    bool has_camera_;
    std::vector<Track> tracks_;
    long block_length_ = 1;                              // frames
    long recorded_ = 0;                                  // frames
    long in_block_ = 0;                                  // of these
    std::map<OverlayKind, std::vector<double>> maxima_;  // N or m/s, per frame
};

}  // namespace pushfactor::demos::pictures
