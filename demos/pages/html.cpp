#include "demos/pages/html.h"

#include "demos/pages/live_links.h"
#include "demos/platform/assets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>

namespace pushfactor::demos::html {

namespace {

bool is_plain(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        result += c == '&'   ? "&amp;"
                  : c == '<' ? "&lt;"
                  : c == '>' ? "&gt;"
                  : c == '"' ? "&quot;"
                             : std::string(1, c);
    }
    return result;
}

std::string anchor(std::string_view name) {
    std::string result(name);
    std::ranges::replace_if(result, std::not_fn(is_plain), '-');
    return result;
}

std::string link_to(std::string_view file) {
    std::string result;
    for (const char c : file)
        result +=
            is_plain(c) || c == '/' ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    return result;
}

std::string command(std::string_view command, std::string_view what) {
    std::string live;
    if (std::filesystem::exists(live_page())) {
        for (const LiveLink& link : live_links(command)) {
            live += fmt::format(" · <a href=\"{}\">In the browser{}</a>", escaped(link.address),
                                link.differs.empty() ? "" : ", " + escaped(link.differs));
        }
    }
    return fmt::format(
        "<div class=\"command\"><code>{}</code><button type=\"button\" class=\"copy\" hidden aria-label=\"Copy the "
        "command: {}\">Copy</button></div>{}",
        escaped(command), escaped(what),
        live.empty() ? "" : "<p class=\"files\">" + live.substr(std::string_view(" · ").size()) + "</p>");
}

}  // namespace pushfactor::demos::html
