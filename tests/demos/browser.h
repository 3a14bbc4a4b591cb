// A browser without a window, driven over the DevTools protocol through a pipe.
#pragma once

#include "demos/base/text/json.h"
#include "renderer/images/image.h"
#include "tests/catch.h"
#include "tests/demos/program.h"

#include <sys/types.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::tests {

using demos::Json;

// Path of Chromium or Chrome; none if neither is installed.
std::optional<std::string> find_browser();

class Browser {
  public:
    // With these options besides those that a browser without a window needs. Throws std::runtime_error if it does
    // not start.
    explicit Browser(const std::vector<std::string>& options);
    ~Browser();
    Browser(const Browser&) = delete;
    Browser& operator=(const Browser&) = delete;

    // Opens a page in a window of this size in pixels, and waits until it is loaded. Forgets what was seen before.
    void open(const std::string& address, int width, int height);

    // Value of an expression; of a promise, what it is resolved to. Throws std::runtime_error with the exception's
    // text.
    Json value_of(const std::string& expression);

    // Presses and releases a key, "ArrowRight" or a letter; clicks with the mouse, pixels from the upper left.
    void press(const std::string& key);
    void click(double x, double y);

    renderer::Image screenshot();

    // Since the page was opened: console messages and uncaught exceptions, and requests besides that for the page.
    const std::vector<std::string>& messages() const { return messages_; }
    const std::vector<std::string>& requests() const { return requests_; }

  private:
    Json call(const std::string& method, const Json& parameters);
    Json next_message();
    void note(const Json& event);

    Folder profile_;
    pid_t process_ = -1;
    int to_browser_ = -1, from_browser_ = -1;
    std::string received_;
    std::string session_;
    int last_call_ = 0;
    bool is_loaded_ = false;
    std::string address_;
    std::vector<std::string> messages_, requests_;
};

// Who draws: the renderer that WebGL 2 names; empty without it.
std::string gl_of(Browser& browser);

// A browser with WebGL 2; null, after saying why the test is skipped, where there is none.
std::unique_ptr<Browser> open_browser();

// No console message, no exception and no request.
void check_quiet(const Browser& browser);

}  // namespace pushfactor::tests
