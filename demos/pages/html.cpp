#include "demos/pages/html.h"

#include "demos/pages/live_links.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos::html {

namespace {

bool is_plain(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '-' ||
           c == '.';
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string anchor(std::string_view name) {
    std::string result(name);
    std::replace_if(
        result.begin(), result.end(), [](char c) { return !is_plain(c); }, '-');
    return result;
}

std::string link_to(std::string_view file) {
    std::string result;
    for (const char c : file) {
        if (is_plain(c) || c == '/') {
            result += c;
        } else {
            result += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        }
    }
    return result;
}

std::string command(std::string_view command, std::string_view what) {
    std::string live;
    if (has_live_page()) {
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
