#include "tests/demos/browser.h"

#include "renderer/images/read_png.h"
#include "tests/skip.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <stdexcept>

namespace pushfactor::tests {

namespace {

// Without an answer for so long the browser hangs.
constexpr int patience_ms = 60000;

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error("browser: " + what);
}

std::vector<std::uint8_t> bytes_of_base64(const std::string& text) {
    std::vector<std::uint8_t> bytes;
    std::uint32_t collected = 0;
    int bits = 0;
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (const char c : text) {
        const std::size_t digit = digits.find(c);
        if (digit == std::string::npos) break;
        collected = collected << 6U | static_cast<std::uint32_t>(digit);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes.push_back(static_cast<std::uint8_t>(collected >> static_cast<unsigned>(bits)));
    }
    return bytes;
}

// In the child: what it reads is its file 3, what it writes its file 4. Copied upwards first, because the pipes may
// have these numbers.
[[noreturn]] void become(const std::vector<std::string>& words, int reads, int writes) {
    constexpr int high = 100;
    dup2(reads, high);
    dup2(writes, high + 1);
    dup2(high, 3);
    dup2(high + 1, 4);
    const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    for (const int file : {0, 1, 2}) dup2(nothing, file);
    for (int file = 5; file < high + 2; ++file) close(file);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    setpgid(0, 0);
    execv(arguments.front(), arguments.data());
    _exit(127);
}

}  // namespace

std::optional<std::string> find_browser() {
    for (const char* const path : {"/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"}) {
        if (access(path, X_OK) == 0) return path;
    }
    return std::nullopt;
}

Browser::Browser(const std::vector<std::string>& options) {
    std::vector<std::string> words{find_browser().value(),
                                   "--headless=new",
                                   "--no-sandbox",
                                   "--remote-debugging-pipe",
                                   "--no-first-run",
                                   "--hide-scrollbars",
                                   "--disable-background-networking",
                                   "--user-data-dir=" + profile_.path().string()};
    words.insert(words.end(), options.begin(), options.end());
    std::array<int, 2> down{}, up{};
    if (pipe2(down.data(), O_CLOEXEC) != 0 || pipe2(up.data(), O_CLOEXEC) != 0) fail("no pipe");
    process_ = fork();
    if (process_ == 0) become(words, down[0], up[1]);
    close(down[0]);
    close(up[1]);
    to_browser_ = down[1];
    from_browser_ = up[0];
    if (process_ < 0) fail("no process");
    const std::string target = call("Target.createTarget", {{"url", "about:blank"}})["targetId"];
    session_ = call("Target.attachToTarget", {{"targetId", target}, {"flatten", true}})["sessionId"];
    for (const char* const domain : {"Runtime", "Log", "Network", "Page"}) {
        call(std::string(domain) + ".enable", Json::object());
    }
}

Browser::~Browser() {
    close(to_browser_);
    close(from_browser_);
    if (process_ <= 0) return;
    // With all processes that it has started; the profile can be removed then.
    kill(-process_, SIGKILL);
    waitpid(process_, nullptr, 0);
}

Json Browser::next_message() {
    std::size_t end = 0;
    while ((end = received_.find('\0')) == std::string::npos) {
        pollfd waiting{.fd = from_browser_, .events = POLLIN, .revents = 0};
        if (poll(&waiting, 1, patience_ms) <= 0) fail("no answer");
        std::array<char, 65536> part{};
        const ssize_t length = read(from_browser_, part.data(), part.size());
        if (length <= 0) fail("it has ended");
        received_.append(part.data(), static_cast<std::size_t>(length));
    }
    const Json message = demos::parse_json(received_.substr(0, end));
    received_.erase(0, end + 1);
    return message;
}

void Browser::note(const Json& event) {
    const std::string method = event.value("method", "");
    if (method == "Page.loadEventFired") is_loaded_ = true;
    if (method == "Runtime.consoleAPICalled" || method == "Runtime.exceptionThrown" || method == "Log.entryAdded") {
        messages_.push_back(demos::json_text(event["params"], -1));
    }
    if (method == "Network.requestWillBeSent") {
        const std::string address = event["params"]["request"]["url"];
        // A blob is in the memory of the page.
        if (address != address_ && !address.starts_with("blob:")) requests_.push_back(address);
    }
}

Json Browser::call(const std::string& method, const Json& parameters) {
    Json message{{"id", ++last_call_}, {"method", method}, {"params", parameters}};
    if (!session_.empty()) message["sessionId"] = session_;
    const std::string text = demos::json_text(message, -1) + '\0';
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t length = write(to_browser_, text.data() + sent, text.size() - sent);
        if (length <= 0) fail("it has ended");
        sent += static_cast<std::size_t>(length);
    }
    for (;;) {
        const Json answer = next_message();
        if (!answer.contains("id")) {
            note(answer);
        } else if (answer["id"] == last_call_) {
            if (answer.contains("error")) fail(method + ": " + demos::json_text(answer["error"], -1));
            return answer["result"];
        }
    }
}

void Browser::open(const std::string& address, int width, int height) {
    const auto go_to = [&](const std::string& there) {
        is_loaded_ = false;
        call("Page.navigate", {{"url", there}});
        while (!is_loaded_) note(next_message());
    };
    go_to("about:blank");  // another part of the same page would not load it
    call("Emulation.setDeviceMetricsOverride",
         {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
    messages_.clear();
    requests_.clear();
    address_ = address.substr(0, address.find('#'));
    go_to(address);
}

Json Browser::value_of(const std::string& expression) {
    const Json answer =
        call("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
    if (answer.contains("exceptionDetails"))
        fail(expression + ": " + demos::json_text(answer["exceptionDetails"], -1));
    return answer["result"].value("value", Json());
}

void Browser::press(const std::string& key) {
    for (const char* const type : {"keyDown", "keyUp"}) {
        call("Input.dispatchKeyEvent", {{"type", type}, {"key", key}});
    }
}

void Browser::click(double x, double y) {
    for (const char* const type : {"mousePressed", "mouseReleased"}) {
        call("Input.dispatchMouseEvent",
             {{"type", type}, {"x", x}, {"y", y}, {"button", "left"}, {"buttons", 1}, {"clickCount", 1}});
    }
}

renderer::Image Browser::screenshot() {
    return renderer::decode_png(bytes_of_base64(call("Page.captureScreenshot", {{"format", "png"}})["data"]));
}

namespace {

// Mesa's llvmpipe, which draws the pictures too; else Chromium's own rasteriser.
const std::vector<std::string> with_mesa{"--use-angle=gl-egl", "--ignore-gpu-blocklist"};
const std::vector<std::string> with_swiftshader{"--use-angle=swiftshader", "--enable-unsafe-swiftshader"};

}  // namespace

std::string gl_of(Browser& browser) {
    return browser
        .value_of(
            "(() => { const gl = document.createElement('canvas').getContext('webgl2'); if (!gl) return '';"
            "const e = gl.getExtension('WEBGL_debug_renderer_info');"
            "return String(gl.getParameter(e ? e.UNMASKED_RENDERER_WEBGL : gl.RENDERER)); })()")
        .get<std::string>();
}

// A browser with WebGL 2; null, with the reason, where there is none.
std::unique_ptr<Browser> open_browser() {
    if (!find_browser()) {
        skip("no Chromium is installed");
        return nullptr;
    }
    for (const auto& options : {with_mesa, with_swiftshader}) {
        auto browser = std::make_unique<Browser>(options);
        if (!gl_of(*browser).empty()) return browser;
    }
    skip("this Chromium has no WebGL 2");
    return nullptr;
}

void check_quiet(const Browser& browser) {
    CHECK(browser.messages() == std::vector<std::string>{});
    CHECK(browser.requests() == std::vector<std::string>{});
}

}  // namespace pushfactor::tests
